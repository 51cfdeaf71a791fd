import { expect, it } from 'vitest';
import { shareOf, smaller } from './fit';

it('a number is as large as it may be with all its characters inside', () => {
  expect(shareOf(80, { edge: 100, align: 'right' })).toBe(1);
  expect(shareOf(100, { edge: 100, align: 'right' })).toBe(1);
  expect(shareOf(125, { edge: 100, align: 'right' })).toBe(0.8);
  // What begins at the left is cut off by nothing on its left.
  expect(shareOf(125, { edge: 0, align: 'left' })).toBe(1);
});

it('a font keeps all but its size', () => {
  expect(smaller('500 60px "Inter 4px", sans-serif', 0.8)).toBe('500 48px "Inter 4px", sans-serif');
  expect(smaller('400 16.8px sans-serif', 0.5)).toBe('400 8.4px sans-serif');
});
