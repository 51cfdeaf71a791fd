import { expect, it } from 'vitest';
import { recorded, type Part } from './recording';

/** A control that has so many samples at its third answer, and gives 1333 rows at a time. */
function control(samples: number) {
  let asked = 0;
  return async (from: number, most: number): Promise<Part> => {
    asked += 1;
    const done = asked > 2;
    const count = done ? Math.max(0, Math.min(1333, most, samples - from)) : 0;
    const rows = Array.from({ length: count }, (_, index) => `${((from + index) / 1000).toFixed(6)},${from + index},${-(from + index)}\n`);
    return { done, samples: done ? samples : asked, csv: (from === 0 ? 't,velocity.X,velocity.Y\n' : '') + rows.join('') };
  };
}

it('a recording of many answers is read to its end', async () => {
  const read = await recorded(control(5000), async () => true);
  expect(read?.names).toEqual(['velocity.X', 'velocity.Y']);
  expect(read?.times).toHaveLength(5000);
  expect([read?.times[4999], read?.lines[0]?.[4999], read?.lines[1]?.[4999]]).toEqual([4.999, 4999, -4999]);
});

it('an empty one has its names', async () => {
  expect(await recorded(control(0), async () => true)).toEqual({ names: ['velocity.X', 'velocity.Y'], times: [], lines: [[], []] });
});

it('one that nobody waits for is left', async () => {
  expect(await recorded(control(5000), async () => false)).toBeNull();
});

it('one that was ended by another is left', async () => {
  let answers = 0;
  const ask = async (): Promise<Part> => ({ done: true, samples: 10, csv: answers++ < 2 ? 't,v\n0,1\n' : '' });
  expect(await recorded(ask, async () => true)).toBeNull();
});
