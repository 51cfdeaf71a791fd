import { expect, it } from 'vitest';
import { nextBlock } from './next';

const next = (text: string, line: number) => nextBlock((at) => text.split('\n')[at - 1] ?? null, line);

it('is the next line that has a block', () => {
  const text = 'O0001 (PART)\nN10 G0 X1\n\n(note)\nN20\n; remark\n/ N30 G1 Y2 (M30)\nM30\n%';
  expect(next(text, 2)).toBe('/ N30 G1 Y2 (M30)');
  expect(next(text, 7)).toBe('M30');
  expect([next(text, 8), next(text, 0), next(text, 40)]).toEqual([null, null, null]);
  expect(next('G0 X1\n%', 1)).toBe(null);
});

it('is not known where a block may lead elsewhere', () => {
  for (const block of ['M98 P2', 'N5 M99', 'GOTO 7', 'IF [#1 LT 3] GOTO 2', 'WHILE [#1 LT 3] DO1', 'END1', 'G65 P9010 A1', '$IF P1==2', 'M02', 'M30', '#CALL PART', 'LL 5', 'o100 call']) {
    expect(next(`${block}\nG0 X1`, 1), block).toBe(null);
  }
  for (const block of ['G0 X1', 'M6 T2', 'M3 S980', 'G81 Z-5. R2. L3', 'G10 L2 P1 X0', 'M300']) expect(next(`${block}\nG0 X1`, 1), block).toBe('G0 X1');
});
