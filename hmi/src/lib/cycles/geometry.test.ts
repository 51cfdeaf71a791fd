import { describe, expect, it } from 'vitest';
import { centerOfRadius, corner, distance, isClosed, outline, rectangle, snap, sweep } from './geometry';
import type { Contour } from '$lib/api/cycles';
import type { Point } from './geometry';

const near = (a: Point, b: Point) => expect(distance(a, b)).toBeLessThan(1e-9);

describe('shapes', () => {
  it('of a rectangle lie on the side that its signs say, and turn about its point', () => {
    const corners = rectangle({ X: 10, Y: 5, L: -20, H: 8, start: 'corner' });
    near(corners[2]!, [-10, 13]);
    const half = rectangle({ X: 0, Y: 0, L: 20, H: 10, start: 'centre', alpha: 90 });
    near(half[0]!, [5, -10]);
  });
  it('have rounded corners that touch both sides', () => {
    const made = corner([0, 10], [0, 0], [10, 0], 'round', 3);
    near(made[0]!, [0, 3]);
    near(made.at(-1)!, [3, 0]);
    for (const point of made) expect(distance(point, [3, 3])).toBeCloseTo(3, 9);
    expect(corner([0, 10], [0, 0], [10, 0], 'round', 30)).toEqual([[0, 0]]);
  });
  it('of a contour end where they began', () => {
    const round = { kind: 'round' as const, size: 2 };
    const to: Point[] = [[10, 0], [10, 10], [0, 10], [0, 0]];
    const contour: Contour = { start: [0, 0], elements: to.map((one) => ({ kind: 'line', to: one, corner: round })) };
    const points = outline(contour);
    expect(isClosed(contour)).toBe(true);
    near(points[0]!, points.at(-1)!);
  });
});

describe('arcs', () => {
  it('turn the way they are told, and once round where they end where they began', () => {
    expect(sweep([1, 0], [0, 1], [0, 0], false)).toBeCloseTo(Math.PI / 2);
    expect(sweep([1, 0], [0, 1], [0, 0], true)).toBeCloseTo(-1.5 * Math.PI);
    expect(sweep([1, 0], [1, 0], [0, 0], true)).toBeCloseTo(-2 * Math.PI);
  });
  it('of a radius keep to the side of their centre', () => {
    near(centerOfRadius([0, 0], [6, 0], 5, [3, -1]), [3, -4]);
    near(centerOfRadius([0, 0], [6, 0], 1, [3, 9]), [3, 9]);
  });
});

describe('snapping', () => {
  const contour: Contour = { start: [0, 0], elements: [{ kind: 'line', to: [20, 0] }] };
  const all = { grid: 1, ends: true, centres: true, middles: true, aligned: true };
  it('takes an end before the grid, and the grid before nothing', () => {
    expect(snap([19.4, 0.3], [contour], 1, all)).toEqual({ at: [20, 0], kind: 'end' });
    expect(snap([10.3, 0.2], [contour], 1, all)).toEqual({ at: [10, 0], kind: 'middle' });
    expect(snap([5.4, 7.7], [contour], 1, all)).toEqual({ at: [5, 8], kind: 'grid' });
    expect(snap([20.4, 7.7], [contour], 1, all, [20, 0])).toEqual({ at: [20, 8], kind: 'aligned' });
  });
});
