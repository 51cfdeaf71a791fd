import { expect, it } from 'vitest';
import { edge, middle, zeroAt } from './measuring';

it('an edge is a radius from the tool', () => {
  expect(edge(-5, 5, 'below')).toBe(0);
  expect(edge(105, 5, 'above')).toBe(100);
});

it('two touches have a middle', () => {
  expect(middle(10, 30, 3)).toEqual({ centre: 20, inner: 26, outer: 14 });
});

it('a zero is without the external one, which the control adds', () => {
  expect(zeroAt({ X: 12, Z: -40 }, 10, { X: 3, Y: 5 })).toEqual({ X: -1, Z: -50 });
  expect(zeroAt({ X: 12 }, 10, {})).toEqual({ X: 2 });
});
