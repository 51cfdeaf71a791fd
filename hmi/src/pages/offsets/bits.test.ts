import { expect, it } from 'vitest';
import { asNumberedBit, numberedBit } from './bits';

it('a bit is found as the manual prints it, and no other is', () => {
  expect(numberedBit(43, 1)).toContain(asNumberedBit('43#1'));
  expect(numberedBit(43, 1)).toContain(asNumberedBit('no43#1'));
  expect(numberedBit(43, 1)).not.toContain(asNumberedBit('3#1'));
  expect(asNumberedBit('feed')).toBe('feed');
});
