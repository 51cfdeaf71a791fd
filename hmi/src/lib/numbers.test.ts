import { expect, it } from 'vitest';
import { behindLetter, duration, firstOfPage, fixed, isSameProgram, numberNamed, rangeText, systemNamed, typed } from './numbers';

it('measures have a fixed number of digits and no minus zero', () => {
  expect(fixed(-0.0004)).toBe('0.000');
  expect(fixed(-12.5)).toBe('−12.500');
  expect(fixed(1234.5678, 2)).toBe('1234.57');
  expect(fixed(undefined)).toBe('–');
  expect(fixed(Number.NaN)).toBe('–');
});

it('typed numbers take point and comma, and nothing that is no number', () => {
  expect(typed('12,5')).toBe(12.5);
  expect(typed(' −.5 ')).toBe(-0.5);
  expect(typed('5.')).toBe(5);
  for (const wrong of ['', '.', '1e5', '1,2,3', 'x', '--1', 'Infinity']) expect(typed(wrong)).toBeNull();
});

it('a range is told by its ends, as far as it has any', () => {
  expect(rangeText(-9999.999, 9999.999)).toBe('−9999.999 … 9999.999');
  expect(rangeText(0, Infinity)).toBe('≥ 0');
  expect(rangeText(-Infinity, 90)).toBe('≤ 90');
  expect(rangeText(-Infinity, Infinity)).toBe('');
});

it('durations are hours, minutes, seconds', () => {
  expect(duration(3661.9)).toBe('01:01:01');
  expect(duration(360_000)).toBe('100:00:00');
});

it('the letter of an axis and what is behind it', () => {
  expect(behindLetter('X', 'X')).toBe(0);
  expect(behindLetter(' x-2,5 ', 'X')).toBe(-2.5);
  expect(behindLetter('X10', 'X')).toBe(10);
  for (const text of ['10', 'Y10', 'X1e3', 'XX', '']) expect(behindLetter(text, 'X')).toBeNull();
});

it('a work coordinate system is asked for as on the control', () => {
  expect(systemNamed('G56')).toBe('G56');
  expect(systemNamed('59')).toBe('G59');
  for (const text of ['P6', 'P06', 'g54 p6']) expect(systemNamed(text)).toBe('G54 P6');
  for (const text of ['G53', 'P0', 'P51', 'G5', '']) expect(systemNamed(text)).toBeNull();
});

it('the number of a row, and the page that has it', () => {
  expect(['12', ' h012 ', 'D256'].map((text) => numberNamed(text, 'HD', 1, 256))).toEqual([12, 12, 256]);
  for (const text of ['', '0', '257', 'T1', 'HD1', '-1', '1.5', 'H']) expect(numberNamed(text, 'HD', 1, 256)).toBeNull();
  expect(numberNamed('# 500', '#', 1, 999)).toBe(500);
  expect(numberNamed('x5', '', 0, 9)).toBeNull();
  expect([1, 32, 33, 256].map((number) => firstOfPage(number, 1, 32))).toEqual([1, 1, 33, 225]);
});

it('a program is the same however its number is written', () => {
  for (const [one, other] of [['O0001', 'o1'], ['O00123', 'O123'], ['O0', 'O0000'], ['part', 'PART']] as const) expect(isSameProgram(one, other), one).toBe(true);
  for (const [one, other] of [['O1', 'O10'], ['O1', 'O1A'], ['O01A', 'O1A'], ['P1', 'P01']] as const) expect(isSameProgram(one, other), one).toBe(false);
});
