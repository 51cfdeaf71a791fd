// What is computed of points that were touched.

export type Point = Record<string, number>;

/** The edge of a work that was touched by a round tool: the tool's centre, moved by its radius towards the work.
    `from` says from where it was touched: from below (the tool stands at the smaller coordinate) or from above. */
export function edge(touched: number, radius: number, from: 'below' | 'above'): number {
  return touched + (from === 'below' ? radius : -radius);
}

/** The middle of two touches, and how far they are apart with and without the tool's diameter. */
export function middle(a: number, b: number, radius: number): { centre: number; inner: number; outer: number } {
  const apart = Math.abs(a - b);
  return { centre: (a + b) / 2, inner: apart + 2 * radius, outer: apart - 2 * radius };
}

/** The circle through three points of a plane; null where they lie on a line. */
export function circle(points: [Point, Point, Point]): { x: number; y: number; radius: number } | null {
  const [a, b, c] = points.map((point) => [point.X ?? 0, point.Y ?? 0]) as [[number, number], [number, number], [number, number]];
  // From the first point on, so that far from zero no digits are lost.
  const [bx, by, cx, cy] = [b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]];
  const twice = 2 * (bx * cy - by * cx);
  const size = Math.max(Math.hypot(bx, by), Math.hypot(cx, cy));
  if (Math.abs(twice) < 1e-9 * size * size || size === 0) return null;
  const b2 = bx * bx + by * by;
  const c2 = cx * cx + cy * cy;
  const x = (cy * b2 - by * c2) / twice;
  const y = (bx * c2 - cx * b2) / twice;
  return { x: a[0] + x, y: a[1] + y, radius: Math.hypot(x, y) };
}
