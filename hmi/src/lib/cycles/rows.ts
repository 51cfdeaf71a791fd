// Figures that a cycle is repeated on: their points, and what each of their fields means (4.23 to 4.27).
import { distance, number } from './geometry';
import { angle, coordinates, measure, toward, type Item } from './items';
import type { Positions } from '$lib/api/cycles';
import type { Point, Values } from './geometry';

/** Most points of a figure that are drawn. */
const MOST_POINTS = 500;

/** A figure from the cycle's own point. What its form leaves empty is drawn as it follows from the others. */
type Figure = { points: Point[]; marks: Item[] };

/** The key of a field of positions. */
export const key = (name: string) => `positions.${name}`;

const given = (values: Values, name: string) => (typeof values[name] === 'number' ? values[name] : undefined);
const most = (count: number) => Math.max(1, Math.min(MOST_POINTS, Math.round(count)));
const degrees = (from: Point, to: Point) => (Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI;

/** Distance of neighbours and how many there are, of two that are given. */
function steps(length: number | undefined, distance: number | undefined, count: number | undefined): [number, number] {
  if (length !== undefined && distance) {
    const n = Math.round(Math.abs(length / distance)) + 1;
    return [length / Math.max(1, n - 1), n];
  }
  if (length !== undefined && count !== undefined) return [length / Math.max(1, count - 1), count];
  return [distance ?? 0, count ?? 1];
}

/** Length, distance and count of a row, the length farther aside. */
function rowMarks(
  [length, distance, count]: [string, string, string],
  [from, second, last]: [Point, Point, Point],
  aside: number,
): Item[] {
  return [
    measure(key(length), from, last, aside * 1.4),
    measure(key(distance), from, second, aside),
    { kind: 'label', field: key(count), at: last },
  ];
}

function line(v: Values, from: Point, room: number): Figure {
  const [xn, yn] = [given(v, 'XN'), given(v, 'YN')];
  const end: Point | null = xn !== undefined && yn !== undefined ? [xn, yn] : null;
  const [step, count] = steps(end ? distance(from, end) : given(v, 'L'), given(v, 'I'), given(v, 'N'));
  const turned = end ? degrees(from, end) : number(v, 'alpha');
  const points = Array.from({ length: most(count) }, (_, i) => toward(from, turned, step * i));
  const last = points.at(-1)!;
  const marks: Item[] = [
    ...rowMarks(['L', 'I', 'N'], [from, points[1] ?? from, last], room * 0.6),
    angle(key('alpha'), from, 0, turned, Math.max(Math.abs(step), room) * 0.7),
    { kind: 'mark', field: key('XN'), at: last },
    ...coordinates([key('XN'), key('YN')], last, room * 0.04),
  ];
  return { points, marks };
}

function arc(v: Values, from: Point, room: number): Figure {
  const [radius, first] = [given(v, 'R'), given(v, 'alpha')];
  const [xa, ya] = [given(v, 'XA'), given(v, 'YA')];
  const arm = radius !== undefined && first !== undefined ? toward([0, 0], first, radius) : null;
  // Without a centre, and without radius and angle to it, the arc is where the cycle is.
  const center: Point =
    xa !== undefined && ya !== undefined ? [xa, ya] : arm ? [from[0] - arm[0], from[1] - arm[1]] : from;
  const begins: Point = arm ? [center[0] + arm[0], center[1] + arm[1]] : from;
  const start = degrees(center, begins);
  const reach = distance(begins, center);
  const [count, between, last] = [given(v, 'N'), given(v, 'beta'), given(v, 'tau')];
  const span = (sense: number) => {
    const turn = ((((last ?? 0) - start) * sense) % 360 + 360) % 360;
    return sense * (turn < 1e-9 ? 360 : turn);
  };
  let [step, n] = [between ?? 0, count ?? 1];
  if (between === undefined && last !== undefined) step = span(1) / Math.max(1, n - 1);
  else if (count === undefined && between && last !== undefined) n = Math.abs(span(Math.sign(between)) / between) + 1;
  const end = start + step * (most(n) - 1);
  const points = Array.from({ length: reach > 0 ? most(n) : 1 }, (_, i) =>
    i === 0 ? from : toward(center, start + step * i, reach),
  );
  const marks: Item[] = [
    { kind: 'mark', field: key('XA'), at: center },
    ...coordinates([key('XA'), key('YA')], center, room * 0.04),
    measure(key('R'), center, begins),
    angle(key('alpha'), center, 0, start, reach * 0.3),
    angle(key('tau'), center, 0, end, reach * 0.5),
    angle(key('beta'), center, start, start + step, reach * 0.75),
    { kind: 'label', field: key('N'), at: points.at(-1)! },
  ];
  return { points, marks };
}

/** Rows and columns; of a rectangle those at its edge alone. */
function rows(v: Values, from: Point, room: number, edgeAlone: boolean): Figure {
  const [dx, nx] = steps(given(v, 'LX'), given(v, 'IX'), given(v, 'NX'));
  const [dy, ny] = steps(given(v, 'LY'), given(v, 'IY'), given(v, 'NY'));
  const [lastX, lastY] = [most(nx) - 1, most(ny) - 1];
  const a = number(v, 'alpha');
  const b = a + number(v, 'beta', 90);
  const place = (i: number, j: number) => toward(toward(from, a, dx * i), b, dy * j);
  const points: Point[] = [];
  for (let j = 0; j <= lastY; j += 1) {
    for (let i = 0; i <= lastX && points.length < MOST_POINTS; i += 1) {
      const edge = j === 0 || j === lastY || i === 0 || i === lastX;
      if (edge || !edgeAlone) points.push(place(i, j));
    }
  }
  const radius = Math.max(Math.abs(dx), Math.abs(dy), room) * 0.7;
  const marks: Item[] = [
    ...rowMarks(['LX', 'IX', 'NX'], [from, place(1, 0), place(lastX, 0)], -room * 0.6),
    ...rowMarks(['LY', 'IY', 'NY'], [from, place(0, 1), place(0, lastY)], room * 0.6),
    angle(key('alpha'), from, 0, a, radius),
    angle(key('beta'), from, a, b, radius * 0.6),
  ];
  return { points, marks };
}

/** A figure from a cycle's own point, its measures aside of shapes of a size. */
export function figure(positions: Positions | undefined, from: Point, room = 0): Figure {
  if (!positions) return { points: [from], marks: [] };
  const v = positions.values;
  switch (positions.kind) {
    case 'LINE':
      return line(v, from, room);
    case 'ARC':
      return arc(v, from, room);
    case 'RECT':
    case 'GRID':
      return rows(v, from, room, positions.kind === 'RECT');
    default: {
      const marks = positions.points.map((at, i): Item => ({ kind: 'label', field: key(`P${i + 2}`), at }));
      return { points: [from, ...positions.points], marks };
    }
  }
}
