// A form from above.
import { circle, number, outline, rectangle, turned, word } from './geometry';
import { angle, coordinates, isBoss, isHole, measure, span, toward, type Item, type Subject } from './items';
import { figure } from './rows';
import type { Point } from './geometry';

const MIDDLE = ['XC', 'YC'] as const;
const ENTRY = ['X1', 'Y1'] as const;
const POINT = ['X', 'Y'] as const;

/** The fields of a cycle's point. */
function origin(of: Subject): [string, string] | null {
  const found = [MIDDLE, ENTRY, POINT].find(([x]) => of.has(x));
  return found ? [...found] : null;
}

/** The diameter of a hole, mm. */
export function holeDiameter(of: Subject): number {
  return number(of.values, 'phi', of.tool);
}

const isRectangle = (of: Subject) => of.has('L') && of.has('H');
/** A rectangle as if it were neither turned nor had corners. */
const flat = (of: Subject) => rectangle({ ...of.values, corner: 'sharp', alpha: 0 });

function center(points: Point[]): Point {
  const xs = points.map((p) => p[0]);
  const ys = points.map((p) => p[1]);
  return [(Math.min(...xs) + Math.max(...xs)) / 2, (Math.min(...ys) + Math.max(...ys)) / 2];
}

/** The point outside a rectangle or circle by a distance, in the middle of the side that looks in a direction. */
function outside(of: Subject, at: Point, degrees: number, by: number): Point {
  if (!isRectangle(of)) return toward(at, degrees, number(of.values, 'R') + by);
  const [one, , other] = flat(of) as [Point, Point, Point];
  const half = Math.abs(degrees % 180 === 0 ? other[0] - one[0] : other[1] - one[1]) / 2;
  return turned(toward(center([one, other]), degrees, half + by), at, number(of.values, 'alpha'));
}

/** A rectangle, larger all round. */
function grown(of: Subject, at: Point, by: number): Point[] {
  const [one, , other] = flat(of) as [Point, Point, Point];
  const [a, b] = [Math.min(one[0], other[0]) - by, Math.max(one[0], other[0]) + by];
  const [c, d] = [Math.min(one[1], other[1]) - by, Math.max(one[1], other[1]) + by];
  const points: Point[] = [[a, c], [b, c], [b, d], [a, d], [a, c]];
  return points.map((p) => turned(p, at, number(of.values, 'alpha')));
}

/** The shape of a cycle's own; profiles have none. */
function shape(of: Subject, at: Point): Point[] | null {
  if (isRectangle(of)) return rectangle(of.values);
  if (of.has('R')) return circle(at, number(of.values, 'R'));
  return isHole(of) ? circle(at, holeDiameter(of) / 2) : null;
}

function rectangleMarks(of: Subject, at: Point): Item[] {
  const v = of.values;
  const turn = (p: Point) => turned(p, at, number(v, 'alpha'));
  const [a, b, c, d] = flat(of) as [Point, Point, Point, Point];
  const size = span([a, c]);
  const aside = size * 0.1;
  const items = [measure('L', turn(a), turn(b), -aside), measure('H', turn(b), turn(c), -aside)];
  if (of.has('alpha')) items.push(angle('alpha', at, 0, number(v, 'alpha'), size * 0.3));
  if (of.has('r')) {
    const along = Math.sign(c[0] - d[0]) * number(v, 'r');
    items.push(measure('r', turn(d), turn([d[0] + along, d[1]]), aside * 0.5));
  }
  return items;
}

function circleMarks(of: Subject, at: Point): Item[] {
  const items = [measure('R', at, toward(at, 0, number(of.values, 'R')))];
  if (of.has('r')) {
    const emptied = number(of.values, 'r');
    items.push({ kind: 'line', points: circle(at, emptied), look: 'stock', field: 'r' });
    items.push(measure('r', at, toward(at, -90, emptied)));
  }
  return items;
}

/** A measure between two radii about a point. */
function spoke(field: string, at: Point, degrees: number, from: number, to: number): Item {
  return measure(field, toward(at, degrees, from), toward(at, degrees, to));
}

/** A thread between its crest and its root (4.7). */
function threadMarks(of: Subject, at: Point): Item[] {
  const v = of.values;
  const outer = holeDiameter(of) / 2;
  const inner = Math.max(0, outer - number(v, 'K'));
  const internal = word(v, 'side', 'internal') === 'internal';
  // The way that the tool cuts into the thread.
  const [crest, root, into] = internal ? [inner, outer, 1] : [outer, inner, -1];
  return [
    { kind: 'line', points: circle(at, inner), look: 'stock', field: 'K' },
    spoke('K', at, 0, inner, outer),
    spoke('step', at, 60, crest, crest + into * number(v, 'step')),
    spoke('delta', at, 120, root, root - into * number(v, 'delta')),
    spoke('DS', at, 210, root, root - into * number(v, 'DS')),
    angle('alpha', at, 0, number(v, 'alpha'), outer),
  ];
}

function holeMarks(of: Subject, at: Point): Item[] {
  const v = of.values;
  const radius = holeDiameter(of) / 2;
  const items: Item[] = [];
  const across = (field: string, half: number, aside: number) =>
    measure(field, [at[0] - half, at[1]], [at[0] + half, at[1]], aside);
  if (of.has('phi')) items.push(across('phi', radius, -radius * 1.3));
  if (of.has('phiK')) {
    const drilled = number(v, 'phiK') / 2;
    items.push({ kind: 'line', points: circle(at, drilled), look: 'stock', field: 'phiK' }, across('phiK', drilled, 0));
  }
  if (of.has('K')) items.push(...threadMarks(of, at));
  if (of.has('beta')) items.push(angle('beta', at, 0, number(v, 'beta'), radius * 0.8));
  if (of.has('dx')) {
    const corner: Point = [at[0] + number(v, 'dx'), at[1]];
    items.push(measure('dx', at, corner, of.tool * 0.2));
    items.push(measure('dy', corner, [corner[0], at[1] + number(v, 'dy')], of.tool * 0.2));
  }
  return items;
}

/** The side beyond which the tool runs on a face, or over which it comes into a slot; degrees (4.19, 4.22). */
const OPEN: Record<string, number> = {
  bidir_y: 90, unidir_y: 90, spiral_y: 90, through_y: 90, corner_ll: 180, corner_ul: 180,
};

function overrun(of: Subject, at: Point): Item {
  const degrees = OPEN[word(of.values, 'strategy') || word(of.values, 'kind')] ?? 0;
  const edge = outside(of, at, degrees, 0);
  // Beside the middle of the side, where its own measure stands.
  return measure('rough.E', edge, outside(of, at, degrees, number(of.values, 'rough.E')), -of.tool);
}

/** A way into a profile or out of it: the circle that touches the profile at its end, on the side of a point (4.20). */
function tangent(field: string, of: Subject, end: Point, before: Point, beside: Point): Item[] {
  const radius = number(of.values, field);
  const along = (Math.atan2(end[1] - before[1], end[0] - before[0]) * 180) / Math.PI;
  const left = toward([0, 0], along + 90, 1);
  const side = left[0] * (beside[0] - end[0]) + left[1] * (beside[1] - end[1]) < 0 ? -90 : 90;
  const middle = toward(end, along + side, radius);
  return [{ kind: 'line', points: circle(middle, radius), look: 'stock', field }, measure(field, middle, end)];
}

function wayMarks(of: Subject, at: Point, profile: Point[], aside: number): Item[] {
  const v = of.values;
  const [first, last] = [profile[0] ?? at, profile.at(-1) ?? at];
  const exit: Point = [number(v, 'XN', last[0]), number(v, 'YN', last[1])];
  return [
    ...tangent('R1', of, first, profile[1] ?? first, at),
    ...tangent('RN', of, last, profile.at(-2) ?? last, exit),
    { kind: 'mark', field: 'XN', at: exit },
    ...coordinates(['XN', 'YN'], exit, aside),
  ];
}

function areas(of: Subject, at: Point, shapes: Point[][]): Item[] {
  if (isBoss(of)) {
    const around = number(of.values, 'Q');
    const cut = isRectangle(of) ? grown(of, at, around) : circle(at, number(of.values, 'R') + around);
    return [
      { kind: 'area', points: cut, look: 'cut' },
      { kind: 'area', points: shapes[0]!, look: 'material' },
    ];
  }
  // Nothing is cleared within a profile that is followed; in a pocket islands stand.
  if (of.form.profile === 'points' || of.form.profile === 'path') return [];
  return shapes.map((points, i) => ({ kind: 'area', points, look: i > 0 ? 'material' : 'cut' }));
}

/** Widths of passes, those of each stage beside the other's; 0 is 3/4 of the tool (4.11). */
function passes(of: Subject, from: Point, room: number): Item[] {
  if (isHole(of)) return [];
  return ['step', 'rough.step', 'finish.step'].filter(of.has).map((field) => {
    const wide = number(of.values, field) || of.tool * 0.75;
    return measure(field, from, [from[0] + wide, from[1]], room * (field === 'finish.step' ? -0.06 : 0.06));
  });
}

export function plan(of: Subject): Item[] {
  const v = of.values;
  const fields = origin(of);
  const at: Point = fields ? [number(v, fields[0]), number(v, fields[1])] : [0, 0];
  const contours = (of.request.profile?.contours ?? []).map(outline).filter((points) => points.length > 1);
  const own = shape(of, at);
  const shapes = own ? [own, ...contours] : contours;
  const room = shapes.length ? span(shapes.flat()) : 20;
  const positions = figure(of.request.positions[0], at, room);

  const items = areas(of, at, shapes);
  for (const points of shapes) items.push({ kind: 'line', points, look: 'part' });
  for (const [x, y] of positions.points.slice(1)) {
    for (const one of shapes) {
      items.push({ kind: 'line', points: one.map((p) => [p[0] + x - at[0], p[1] + y - at[1]]), look: 'row' });
    }
  }
  if (isRectangle(of)) items.push(...rectangleMarks(of, at));
  if (of.has('R')) items.push(...circleMarks(of, at));
  if (isHole(of)) items.push(...holeMarks(of, at));
  if (of.has('Q')) items.push(measure('Q', outside(of, at, 180, 0), outside(of, at, 180, number(v, 'Q'))));
  if (of.has('rough.E')) items.push(overrun(of, at));
  if (of.has('R1')) items.push(...wayMarks(of, at, contours[0] ?? [], room * 0.04));
  items.push(...passes(of, isBoss(of) ? outside(of, at, 0, 0) : center(shapes[0] ?? [at]), room));
  items.push(...positions.marks);
  if (fields) items.push({ kind: 'mark', field: fields[0], at }, ...coordinates(fields, at, room * 0.04));
  return items;
}
