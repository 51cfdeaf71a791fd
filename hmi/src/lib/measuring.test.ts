import { expect, it } from 'vitest';
import { circle, edge, middle } from './measuring';

it('an edge is a radius from the tool', () => {
  expect(edge(-5, 5, 'below')).toBe(0);
  expect(edge(105, 5, 'above')).toBe(100);
});

it('two touches have a middle', () => {
  expect(middle(10, 30, 3)).toEqual({ centre: 20, inner: 26, outer: 14 });
});

it('three points are on a circle, but not on a line', () => {
  const found = circle([{ X: 1005, Y: 0 }, { X: 1000, Y: 5 }, { X: 995, Y: 0 }]);
  expect(found?.x).toBeCloseTo(1000, 9);
  expect(found?.y).toBeCloseTo(0, 9);
  expect(found?.radius).toBeCloseTo(5, 9);
  expect(circle([{ X: 0, Y: 0 }, { X: 1, Y: 1 }, { X: 2, Y: 2 }])).toBeNull();
});
