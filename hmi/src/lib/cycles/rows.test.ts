import { describe, expect, it } from 'vitest';
import { distance } from './geometry';
import { figure, key } from './rows';
import type { Point } from './geometry';

const near = (a: Point, b: Point) => expect(distance(a, b)).toBeLessThan(1e-9);

describe('figures', () => {
  const at: Point = [5, 5];
  it('have their points', () => {
    near(figure({ kind: 'LINE', values: { I: 10, N: 3, alpha: 90 }, points: [] }, at).points.at(-1)!, [5, 25]);
    expect(figure({ kind: 'GRID', values: { IX: 10, NX: 4, LY: 20, NY: 3 }, points: [] }, at).points).toHaveLength(12);
    expect(figure({ kind: 'RECT', values: { IX: 10, NX: 4, IY: 10, NY: 3 }, points: [] }, at).points).toHaveLength(10);
    const round = figure({ kind: 'ARC', values: { XA: 0, YA: 5, beta: 90, N: 4 }, points: [] }, at).points;
    near(round[2]!, [-5, 5]);
    expect(figure({ kind: 'POINTS', values: {}, points: [[1, 1]] }, at).points).toHaveLength(2);
  });

  // The formats of the manual's examples: what a format leaves out is drawn as it follows (4.23 to 4.26).
  const line = { XN: 100, YN: 100, alpha: 45, L: 106.066, N: 4, I: 35.3553 };
  const arc = { XA: 50, YA: 50, R: 40, N: 7, alpha: 0, tau: 270, beta: 45 };
  const grid = { LX: 75, LY: 50, NX: 4, NY: 3, IX: 25, IY: 25, alpha: 0, beta: 90 };
  const rows = ['LX LY NX NY alpha beta', 'NX NY IX IY alpha beta', 'LX LY IX IY alpha beta'];
  const examples: [string, Point, Record<string, number>, string[]][] = [
    ['LINE', [25, 25], line, ['XN YN N', 'alpha L N', 'alpha N I', 'XN YN I', 'alpha L I']],
    [
      'ARC', [90, 50], arc,
      [
        'XA YA N tau', 'XA YA N beta', 'R N alpha tau', 'R N alpha beta', 'XA YA tau beta', 'R alpha tau beta',
        'XA YA R N alpha beta', 'XA YA R N alpha tau', 'XA YA R alpha tau beta',
      ],
    ],
    ['RECT', [25, 25], grid, rows],
    ['GRID', [25, 25], grid, rows],
  ];
  const formats = examples.flatMap(([kind, from, all, given]) =>
    given.map((names) => [kind, names, from, all] as const),
  );
  it.each(formats)('%s by %s has the sizes of the manual', (kind, names, from, all) => {
    const values = Object.fromEntries(names.split(' ').map((name) => [name, all[name]!]));
    const { marks } = figure({ kind, values, points: [] }, from, 8);
    const sizes = new Map<string, number>();
    for (const item of marks) {
      if (item.kind === 'measure') sizes.set(item.field, distance(item.from, item.to));
      if (item.kind === 'angle') sizes.set(item.field, item.to - item.from);
      if (item.kind === 'label') sizes.set(item.field, 0);
    }
    expect([...sizes.keys()].sort()).toEqual(Object.keys(all).map(key).sort());
    for (const [name, value] of Object.entries(all)) {
      if (!name.startsWith('N')) expect(sizes.get(key(name)), name).toBeCloseTo(value, 3);
    }
  });
});
