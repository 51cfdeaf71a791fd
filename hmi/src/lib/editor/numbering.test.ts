import { expect, it } from 'vitest';
import { numberBehind } from './numbering';

const behind = (text: string, line: number, step: number, rest = '') => numberBehind((at) => text.split('\n')[at - 1] ?? null, line, step, rest);

it('goes on from the number before', () => {
  expect(behind('O0001', 1, 10)).toBe('N10 ');
  expect(behind('O0001\nN10 G0 X1\n(note)', 3, 10)).toBe('N20 ');
  expect(behind('O0001\n/ n25 G0 X1', 2, 5)).toBe('N30 ');
});

it('leaves alone what has one, what would be too large, and all where the increment is 0', () => {
  expect(behind('N10 G0', 1, 10, 'N15 X1')).toBe('');
  expect(behind('N99995 G0', 1, 10)).toBe('');
  expect(behind('N10 G0', 1, 0)).toBe('');
});
