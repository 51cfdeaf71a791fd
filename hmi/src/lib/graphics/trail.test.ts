import { describe, expect, it } from 'vitest';
import { Trail } from './trail';

const strokes = (trail: Trail) => {
  const all: number[][][] = [];
  for (let at = 0; at < trail.count; at++) {
    if (trail.kinds[at] === 0) all.push([]);
    all.at(-1)!.push([...trail.points.slice(3 * at, 3 * at + 3)]);
  }
  return all;
};

describe('the trail of the tool', () => {
  it('keeps of straight ways their ends, and corners', () => {
    const trail = new Trail();
    for (let x = 0; x <= 10; x++) trail.add(x, 0, 0);
    for (let y = 1; y <= 10; y++) trail.add(10, y, 0);
    // The same way back is another one.
    for (let y = 9; y >= 4; y--) trail.add(10, y, 0);
    expect(strokes(trail)).toEqual([[[0, 0, 0], [10, 0, 0], [10, 10, 0], [10, 4, 0]]]);
    expect(trail.box).toEqual({ low: [0, 0, 0], high: [10, 10, 0] });
  });

  it('leaves no point of a curve by more than a hundredth', () => {
    const trail = new Trail();
    const turn = Array.from({ length: 2001 }, (_, at) => [20 * Math.cos(at / 318.3), 20 * Math.sin(at / 318.3)] as const);
    for (const [x, y] of turn) trail.add(x, y, 0);
    const [stroke] = strokes(trail);
    expect(stroke!.length).toBeLessThan(1000);
    for (const [x, y] of turn) {
      let least = Infinity;
      for (let at = 1; at < stroke!.length; at++) {
        const [a, b] = [stroke![at - 1]!, stroke![at]!];
        const [dx, dy] = [b[0]! - a[0]!, b[1]! - a[1]!];
        const part = Math.max(0, Math.min(1, ((x - a[0]!) * dx + (y - a[1]!) * dy) / (dx * dx + dy * dy)));
        least = Math.min(least, Math.hypot(x - a[0]! - part * dx, y - a[1]! - part * dy));
      }
      expect(least).toBeLessThan(0.01);
    }
  });

  it('begins a stroke where it was lifted, and has none of one point', () => {
    const trail = new Trail();
    trail.add(0, 0, 0);
    trail.add(0, 0, 0.001);
    trail.lift();
    trail.add(5, 5, 5);
    expect(trail.box).toBeNull();
    trail.add(6, 5, 5);
    trail.lift();
    trail.add(0, 0, 0);
    trail.add(0, 1, 0);
    expect(strokes(trail)).toEqual([[[5, 5, 5], [6, 5, 5]], [[0, 0, 0], [0, 1, 0]]]);
    trail.clear();
    expect(trail.count).toBe(0);
    trail.add(1, 1, 1);
    expect(trail.kinds[0]).toBe(0);
  });

  it('forgets the oldest and takes no more memory, whatever comes', () => {
    const trail = new Trail();
    for (let at = 0; at < 100_001; at++) trail.add(at, at % 2, 0);
    expect(trail.count).toBeLessThanOrEqual(20_000);
    expect(trail.kinds[0]).toBe(0);
    expect([...trail.points.slice(3 * trail.count - 3, 3 * trail.count)]).toEqual([100_000, 0, 0]);
  });
});
