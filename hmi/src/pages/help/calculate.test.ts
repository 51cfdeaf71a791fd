import { expect, it } from 'vitest';
import { calculate } from './calculate';

it.each([
  ['1+2*3', 7],
  ['(1+2)*3', 9],
  ['-2^2', -4],
  ['2^3^2', 512],
  ['10/4-1', 1.5],
  ['sin(30)', 0.5],
  ['sin 30 + 1', 1.5],
  ['√16', 4],
  ['2 × 3 ÷ 4 − 1', 0.5],
  ['1,5*2', 3],
  ['atan(1)', 45],
])('%s is %d', (text, value) => expect(calculate(text)).toBeCloseTo(value, 9));

it.each(['', '1+', '1/0', '2 3', '(1', ')', 'foo(2)', '1..2', 'sqrt(-1)', 'alert(1)', '('.repeat(5000), '-'.repeat(5000)])('%s has no value', (text) =>
  expect(calculate(text)).toBeNull(),
);
