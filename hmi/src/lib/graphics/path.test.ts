import { expect, it } from 'vitest';
import { at, busiest, follow, OTHER, readPath, segments } from './path';

/** A path of points, kinds, with 1 s and one line a point. */
export function buffer(points: number[][], kinds: number[], flags = 0): ArrayBuffer {
  const n = points.length;
  const made = new ArrayBuffer(64 + 21 * n);
  const view = new DataView(made);
  view.setUint32(0, 0x31504346, true);
  view.setUint32(4, n, true);
  view.setUint32(8, flags, true);
  [0, 0, 0, 10, 10, 0].forEach((value, index) => view.setFloat64(16 + 8 * index, value, true));
  points.forEach((point, index) => {
    point.forEach((value, axis) => view.setFloat32(64 + 12 * index + 4 * axis, value, true));
    view.setFloat32(64 + 12 * n + 4 * index, index, true);
    view.setUint32(64 + 16 * n + 4 * index, index, true);
    view.setUint8(64 + 20 * n + index, kinds[index]!);
  });
  return made;
}

const square = () =>
  readPath(buffer([[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0], [5, 5, 0], [6, 5, 0]], [0, 1, 2, 2, 0, 2], 2));

it('reads what the server sends', () => {
  const path = square();
  expect(path.count).toBe(6);
  expect(path.short).toBe(true);
  expect(path.alarm).toBe(false);
  expect([...path.points.slice(6, 9)]).toEqual([10, 10, 0]);
  expect(path.box.high).toEqual([10, 10, 0]);
  expect(() => readPath(new ArrayBuffer(10))).toThrow();
  expect(() => readPath(buffer([[0, 0, 0]], [0]).slice(0, 70))).toThrow();
});

it('makes pairs of what is joined, and keeps ends when points are left out', () => {
  expect([...segments(square(), 1)]).toEqual([0, 1, 1, 2, 2, 3, 4, 5]);
  expect([...segments(square(), 100)]).toEqual([0, 1, 1, 3, 4, 5]);
});

it('finds a time and the tool', () => {
  const path = square();
  expect(at(path, 2.5)).toBe(2);
  expect(at(path, -1)).toBe(0);
  expect(at(path, 99)).toBe(5);
  expect(follow(path, 2, [10, 4, 0], 0)).toBe(2);
  // What a subprogram of another file does has no lines.
  path.lines.fill(0);
  expect(follow(path, OTHER, [10, 4, 0], 0)).toBe(2);
  expect(follow(path, OTHER, [4, 10, 0], 2)).toBe(3);
  expect(follow(path, 77, [10, 4, 0], 3)).toBe(3);
});

it('finds the height at which the most is cut', () => {
  // Rapids, ways down and the shorter pass do not count.
  const points = [[0, 0, 20], [90, 0, 20], [90, 0, -3], [80, 0, -3], [80, 0, -5], [50, 0, -5], [50, 20, -5.001]];
  expect(busiest(readPath(buffer(points, [0, 1, 2, 2, 2, 2, 3])))).toBeCloseTo(-5);
  expect(busiest(readPath(buffer([[0, 0, 0], [5, 0, 0]], [0, 1])))).toBe(null);
});
