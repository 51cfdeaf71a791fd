import { expect, it } from 'vitest';
import { isRestored } from './restoring';

it('the position is backed up, and not restored', () => {
  expect(['offsets', 'position'].filter(isRestored)).toEqual(['offsets']);
  expect(['position'].filter(isRestored)).toEqual([]);
});
