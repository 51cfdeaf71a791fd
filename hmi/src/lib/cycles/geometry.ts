// Shapes of cycles in the plane: what drawings show. The machine's own motion comes from the server.
import type { Contour, Element, Positions } from '$lib/api/cycles';

export type Point = Contour['start'];
export type Values = Positions['values'];

const TURN = 2 * Math.PI;

export function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/** A number of the values; `other` where it is none. */
export function number(values: Values, name: string, other = 0): number {
  const value = values[name];
  return typeof value === 'number' && Number.isFinite(value) ? value : other;
}

export function word(values: Values, name: string, other = ''): string {
  const value = values[name];
  return typeof value === 'string' ? value : other;
}

/** A point turned about another, degrees. */
export function turned(point: Point, about: Point, degrees: number): Point {
  const angle = (degrees * Math.PI) / 180;
  const [x, y] = [point[0] - about[0], point[1] - about[1]];
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  return [about[0] + x * cos - y * sin, about[1] + x * sin + y * cos];
}

export function circle(center: Point, radius: number, count = 72): Point[] {
  return Array.from({ length: count + 1 }, (_, i) => {
    const angle = (i / count) * TURN;
    return [center[0] + radius * Math.cos(angle), center[1] + radius * Math.sin(angle)] as Point;
  });
}

/** The angle that an arc turns, counter-clockwise positive; a whole turn where it ends where it begins. */
export function sweep(from: Point, to: Point, center: Point, clockwise: boolean): number {
  const a = Math.atan2(from[1] - center[1], from[0] - center[0]);
  const b = Math.atan2(to[1] - center[1], to[0] - center[0]);
  if (distance(from, to) < 1e-6) return clockwise ? -TURN : TURN;
  let angle = (b - a) % TURN;
  if (angle < 0) angle += TURN;
  return clockwise ? angle - TURN : angle;
}

/** Points of an arc behind its first. */
export function arcPoints(from: Point, to: Point, center: Point, clockwise: boolean): Point[] {
  const angle = sweep(from, to, center, clockwise);
  const radius = distance(from, center);
  const first = Math.atan2(from[1] - center[1], from[0] - center[0]);
  const count = Math.max(2, Math.ceil(Math.abs(angle) / 0.1));
  const points = Array.from({ length: count }, (_, i) => {
    const at = first + (angle * (i + 1)) / count;
    return [center[0] + radius * Math.cos(at), center[1] + radius * Math.sin(at)] as Point;
  });
  points[count - 1] = to;
  return points;
}

/** A corner between two straight sides, as points in its place. */
export function corner(before: Point, at: Point, after: Point, kind: string, size: number): Point[] {
  const [a, b] = [distance(before, at), distance(at, after)];
  if (!(size > 0) || a < 1e-9 || b < 1e-9) return [at];
  const u: Point = [(before[0] - at[0]) / a, (before[1] - at[1]) / a];
  const v: Point = [(after[0] - at[0]) / b, (after[1] - at[1]) / b];
  const cos = u[0] * v[0] + u[1] * v[1];
  const half = Math.acos(Math.max(-1, Math.min(1, cos))) / 2;
  const cut = kind === 'round' ? size / Math.tan(half) : size;
  if (!(half > 1e-6) || !(cut <= Math.min(a, b))) return [at];
  const first: Point = [at[0] + u[0] * cut, at[1] + u[1] * cut];
  const last: Point = [at[0] + v[0] * cut, at[1] + v[1] * cut];
  if (kind !== 'round') return [first, last];
  const along = size / Math.sin(half);
  const w: Point = [u[0] + v[0], u[1] + v[1]];
  const length = Math.hypot(w[0], w[1]);
  if (length < 1e-9) return [at];
  const center: Point = [at[0] + (w[0] / length) * along, at[1] + (w[1] / length) * along];
  const clockwise = u[0] * v[1] - u[1] * v[0] > 0;
  return [first, ...arcPoints(first, last, center, clockwise)];
}

/** A rectangle of a cycle, by X Y L H start alpha corner r. */
export function rectangle(values: Values): Point[] {
  const at: Point = [number(values, 'X'), number(values, 'Y')];
  const [l, h] = [number(values, 'L'), number(values, 'H')];
  const centre = word(values, 'start', 'corner') === 'centre';
  const [x, y] = centre ? [at[0] - Math.abs(l) / 2, at[1] - Math.abs(h) / 2] : at;
  const [w, d] = centre ? [Math.abs(l), Math.abs(h)] : [l, h];
  const sharp: Point[] = [[x, y], [x + w, y], [x + w, y + d], [x, y + d]];
  const kind = word(values, 'corner', 'sharp');
  const size = number(values, 'r');
  const points =
    kind === 'sharp'
      ? sharp
      : sharp.flatMap((p, i) => corner(sharp[(i + 3) % 4]!, p, sharp[(i + 1) % 4]!, kind, size));
  return [...points, points[0]!].map((p) => turned(p, at, number(values, 'alpha')));
}

/** A contour as points, the corners between straight sides made. */
export function outline(contour: Contour): Point[] {
  const points: Point[] = [contour.start];
  let at = contour.start;
  const closed = isClosed(contour);
  contour.elements.forEach((element, i) => {
    const next = contour.elements[i + 1] ?? (closed ? contour.elements[0] : undefined);
    const made = element.corner ?? null;
    const straight = element.kind === 'line' && next?.kind === 'line';
    if (element.kind === 'arc') points.push(...arcPoints(at, element.to, element.center, element.clockwise));
    else if (made && straight && next) points.push(...corner(at, element.to, next.to, made.kind, made.size));
    else points.push(element.to);
    at = element.to;
  });
  const last = contour.elements.at(-1);
  // The corner between the last side and the first begins the outline too.
  if (closed && last?.kind === 'line' && last.corner && contour.elements[0]?.kind === 'line') {
    points[0] = points.at(-1)!;
  }
  return points;
}

/** Points as the path of a drawing, whose ordinate goes up. */
export const svgPath = (points: Point[]): string => points.map((p, i) => `${i ? 'L' : 'M'}${p[0].toFixed(4)} ${(-p[1]).toFixed(4)}`).join('');

/** A contour moved. */
export function moved(contour: Contour, [x, y]: Point): Contour {
  const by = (p: Point): Point => [p[0] + x, p[1] + y];
  const elements = contour.elements.map((one) => (one.kind === 'arc' ? { ...one, to: by(one.to), center: by(one.center) } : { ...one, to: by(one.to) }));
  return { ...contour, start: by(contour.start), elements };
}

export function isClosed(contour: Contour): boolean {
  const last = contour.elements.at(-1);
  return last !== undefined && distance(last.to, contour.start) < 1e-3;
}

/** Where an element begins. */
export function startOf(contour: Contour, index: number): Point {
  return index === 0 ? contour.start : contour.elements[index - 1]!.to;
}

/** An element moved to another end; an arc keeps its middle on the new chord's side as well as it can. */
export function movedEnd(element: Element, from: Point, to: Point): Element {
  if (element.kind === 'line') return { ...element, to };
  if (distance(from, to) < 1e-9) return { ...element, to };
  return { ...element, to, center: nearestCenter(from, to, element.center) };
}

/** The centre of a circle through two points that lies nearest to a given one. */
export function nearestCenter(from: Point, to: Point, center: Point): Point {
  const chord = distance(from, to);
  if (chord < 1e-9) return center;
  const middle: Point = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  const normal: Point = [-(to[1] - from[1]) / chord, (to[0] - from[0]) / chord];
  const along = (center[0] - middle[0]) * normal[0] + (center[1] - middle[1]) * normal[1];
  return [middle[0] + normal[0] * along, middle[1] + normal[1] * along];
}

/** Radius of an arc with its sign as controls take it is not needed here: the centre says all. */
export function radiusOf(element: Element, from: Point): number {
  return element.kind === 'arc' ? distance(element.center, from) : 0;
}

/** The centre of an arc of a radius between two points, on the side of a given centre. */
export function centerOfRadius(from: Point, to: Point, radius: number, center: Point): Point {
  const chord = distance(from, to);
  if (chord < 1e-9 || radius < chord / 2) return nearestCenter(from, to, center);
  const middle: Point = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  const normal: Point = [-(to[1] - from[1]) / chord, (to[0] - from[0]) / chord];
  const side = (center[0] - middle[0]) * normal[0] + (center[1] - middle[1]) * normal[1] < 0 ? -1 : 1;
  const away = side * Math.sqrt(Math.max(0, radius * radius - (chord / 2) ** 2));
  return [middle[0] + normal[0] * away, middle[1] + normal[1] * away];
}

/** What a point snaps to. */
export type Snap = { at: Point; kind: 'end' | 'centre' | 'middle' | 'aligned' | 'grid' | 'free' };

export type Snapping = { grid: number; ends: boolean; centres: boolean; middles: boolean; aligned: boolean };

/** The place that is meant near a point: of what is within reach, ends before centres, middles, alignment, grid. */
export function snap(point: Point, contours: Contour[], reach: number, to: Snapping, from?: Point): Snap {
  const places: Snap[] = [];
  for (const contour of contours) {
    if (to.ends) places.push({ at: contour.start, kind: 'end' });
    let at = contour.start;
    for (const element of contour.elements) {
      if (to.ends) places.push({ at: element.to, kind: 'end' });
      if (element.kind === 'arc') {
        if (to.centres) places.push({ at: element.center, kind: 'centre' });
      } else if (to.middles) {
        places.push({ at: [(at[0] + element.to[0]) / 2, (at[1] + element.to[1]) / 2], kind: 'middle' });
      }
      at = element.to;
    }
  }
  for (const kind of ['end', 'centre', 'middle'] as const) {
    const near = places.filter((place) => place.kind === kind && distance(place.at, point) <= reach);
    near.sort((a, b) => distance(a.at, point) - distance(b.at, point));
    if (near[0]) return near[0];
  }
  const grid = (value: number) => (to.grid > 0 ? Math.round(value / to.grid) * to.grid : value);
  const clean = (value: number) => Math.round(value * 1e4) / 1e4;
  const on: Point = [clean(grid(point[0])), clean(grid(point[1]))];
  if (to.aligned && from) {
    if (Math.abs(point[0] - from[0]) <= reach) return { at: [from[0], on[1]], kind: 'aligned' };
    if (Math.abs(point[1] - from[1]) <= reach) return { at: [on[0], from[1]], kind: 'aligned' };
  }
  return { at: on, kind: to.grid > 0 ? 'grid' : 'free' };
}

/** The least box around points, with a margin; a box about zero where there are none. */
export function box(points: Point[], margin: number): { x: number; y: number; w: number; h: number } {
  const finite = points.filter((p) => Number.isFinite(p[0]) && Number.isFinite(p[1]));
  if (finite.length === 0) return { x: -50, y: -50, w: 100, h: 100 };
  const xs = finite.map((p) => p[0]);
  const ys = finite.map((p) => p[1]);
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const room = Math.max(x1 - x0, y1 - y0, 4) * margin;
  return { x: x0 - room, y: y0 - room, w: x1 - x0 + 2 * room, h: y1 - y0 + 2 * room };
}
