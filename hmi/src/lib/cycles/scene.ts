// What the drawing of a form shows: the shape to scale from above and in section, and a measure for each parameter
// that is one.
import { circle, distance, figure, number, outline, rectangle, turned, word } from './geometry';
import type { Form, Request } from '$lib/api/cycles';
import type { Point } from './geometry';

/** A piece of a drawing, mm; in the section the ordinate is the tool axis. */
export type Item =
  | { kind: 'line'; points: Point[]; look: 'part' | 'wall' | 'safety' | 'level' | 'tool' | 'stock' | 'row'; field?: string }
  | { kind: 'area'; points: Point[]; look: 'material' | 'cut' }
  | { kind: 'measure'; field: string; from: Point; to: Point; /** How far aside it stands. */ aside: number }
  | { kind: 'angle'; field: string; at: Point; from: number; to: number; radius: number }
  | { kind: 'mark'; field?: string; at: Point };

export type Scene = { plan: Item[]; section: Item[] };

/** The size by which measures stand aside. */
function span(points: Point[]): number {
  const xs = points.map((p) => p[0]);
  const ys = points.map((p) => p[1]);
  return Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys), 4);
}

/** The point of a cycle and the fields that it has. */
function origin(request: Request): { at: Point; fields: [string, string] | null } {
  const v = request.values;
  if ('XC' in v) return { at: [number(v, 'XC'), number(v, 'YC')], fields: ['XC', 'YC'] };
  if ('X1' in v) return { at: [number(v, 'X1'), number(v, 'Y1')], fields: ['X1', 'Y1'] };
  return { at: [number(v, 'X'), number(v, 'Y')], fields: 'X' in v ? ['X', 'Y'] : null };
}

/** Diameter of the tool of a stage. */
export function toolDiameter(request: Request): number {
  const stage = ['rough.T', 'T', 'finish.T'].map((name) => request.values[name]).find((value) => Number(value) > 0);
  return request.tools.find((tool) => tool.number === stage)?.diameter ?? 8;
}

function plan(form: Form, request: Request): Item[] {
  const v = request.values;
  const { at, fields } = origin(request);
  const items: Item[] = [];
  const shapes: Point[][] = [];
  const boss = form.group === 'bosses';
  const has = (name: string) => typeof v[name] === 'number';
  const tool = toolDiameter(request);

  if (has('L') && has('H')) {
    const points = rectangle(v);
    shapes.push(points);
    const flat = rectangle({ ...v, corner: 'sharp', alpha: 0 });
    const turn = (p: Point) => turned(p, at, number(v, 'alpha'));
    const aside = span(flat) * 0.1;
    items.push({ kind: 'measure', field: 'L', from: turn(flat[0]!), to: turn(flat[1]!), aside: -aside });
    items.push({ kind: 'measure', field: 'H', from: turn(flat[1]!), to: turn(flat[2]!), aside: -aside });
    if (number(v, 'alpha') !== 0) {
      items.push({ kind: 'angle', field: 'alpha', at, from: 0, to: number(v, 'alpha'), radius: span(flat) * 0.3 });
    }
    if (number(v, 'r') > 0 && word(v, 'corner') !== 'sharp') {
      items.push({ kind: 'mark', field: 'r', at: points[0]! });
    }
  }
  if (has('R') && form.group !== 'profiles') {
    const radius = number(v, 'R');
    shapes.push(circle(at, radius));
    items.push({ kind: 'measure', field: 'R', from: at, to: [at[0] + radius, at[1]], aside: 0 });
    if (has('r')) {
      items.push({ kind: 'line', points: circle(at, number(v, 'r')), look: 'stock', field: 'r' });
      const down: Point = [at[0], at[1] - number(v, 'r')];
      items.push({ kind: 'measure', field: 'r', from: at, to: down, aside: 0 });
    }
  }
  if (form.group === 'axis') {
    const diameter = number(v, 'phi', tool);
    shapes.push(circle(at, diameter / 2));
    if (has('phi')) {
      items.push({
        kind: 'measure',
        field: 'phi',
        from: [at[0] - diameter / 2, at[1]],
        to: [at[0] + diameter / 2, at[1]],
        aside: -diameter * 0.65,
      });
    }
    const other = has('phiK') ? number(v, 'phiK') : has('K') ? diameter - 2 * number(v, 'K') : 0;
    if (other > 0) {
      const name = has('phiK') ? 'phiK' : 'K';
      items.push({ kind: 'line', points: circle(at, other / 2), look: 'stock', field: name });
      const edge: Point = [at[0] + diameter / 2, at[1]];
      if (name === 'K') items.push({ kind: 'measure', field: 'K', from: [at[0] + other / 2, at[1]], to: edge, aside: 0 });
    }
    if (has('dx')) {
      const to: Point = [at[0] + number(v, 'dx'), at[1] + number(v, 'dy')];
      items.push({ kind: 'measure', field: 'dx', from: at, to: [to[0], at[1]], aside: tool * 0.2 });
      items.push({ kind: 'measure', field: 'dy', from: [to[0], at[1]], to, aside: tool * 0.2 });
    }
  }
  const contours = request.profile?.contours ?? [];
  for (const contour of contours) {
    const points = outline(contour);
    if (points.length > 1) shapes.push(points);
  }
  const all = shapes.flat();
  const room = all.length ? span(all) : 20;

  // Stock that is left, and what the boss stands in.
  if (boss) {
    const around = number(v, 'Q');
    const shape = shapes[0] ?? [];
    const grown = has('R') ? circle(at, number(v, 'R') + around) : grow(v, around);
    items.push({ kind: 'area', points: grown, look: 'cut' });
    items.push({ kind: 'area', points: shape, look: 'material' });
    const first = shape[0];
    if (first && around > 0) {
      const from: Point = has('R') ? [at[0] + number(v, 'R'), at[1]] : first;
      items.push({ kind: 'measure', field: 'Q', from, to: [from[0] + (has('R') ? around : -around), from[1]], aside: 0 });
    }
  } else {
    for (const [index, shape] of shapes.entries()) {
      if (form.profile === 'points' || form.profile === 'path') continue;
      items.push({ kind: 'area', points: shape, look: contours.length > 0 && index > 0 ? 'material' : 'cut' });
    }
  }
  for (const shape of shapes) items.push({ kind: 'line', points: shape, look: 'part' });
  if (has('rough.step') || has('step')) {
    const name = has('rough.step') ? 'rough.step' : 'step';
    const width = number(v, name) || tool * 0.75;
    const middle = center(shapes[0] ?? [at]);
    items.push({ kind: 'measure', field: name, from: middle, to: [middle[0] + width, middle[1]], aside: room * 0.06 });
  }
  const rows = figure(request.positions[0], at);
  for (const point of rows.slice(1)) {
    const by: Point = [point[0] - at[0], point[1] - at[1]];
    for (const shape of shapes) {
      items.push({ kind: 'line', points: shape.map((p) => [p[0] + by[0], p[1] + by[1]]), look: 'row' });
    }
  }
  if (fields) {
    items.push({ kind: 'mark', field: fields[0], at });
    items.push({ kind: 'measure', field: fields[0], from: [0, at[1]], to: at, aside: -room * 0.04 });
    items.push({ kind: 'measure', field: fields[1], from: [at[0], 0], to: at, aside: room * 0.04 });
  }
  const exit: Point | null = has('XN') && has('YN') ? [number(v, 'XN'), number(v, 'YN')] : null;
  if (exit) items.push({ kind: 'mark', field: 'XN', at: exit });
  return items;
}

function center(points: Point[]): Point {
  const xs = points.map((p) => p[0]);
  const ys = points.map((p) => p[1]);
  return [(Math.min(...xs) + Math.max(...xs)) / 2, (Math.min(...ys) + Math.max(...ys)) / 2];
}

/** A rectangle of a form, larger all round. */
function grow(v: Request['values'], by: number): Point[] {
  const at: Point = [number(v, 'X'), number(v, 'Y')];
  const flat = rectangle({ ...v, corner: 'sharp', alpha: 0 });
  const xs = flat.map((p) => p[0]);
  const ys = flat.map((p) => p[1]);
  const [a, b, c, d] = [Math.min(...xs) - by, Math.max(...xs) + by, Math.min(...ys) - by, Math.max(...ys) + by];
  const points: Point[] = [[a, c], [b, c], [b, d], [a, d], [a, c]];
  return points.map((p) => turned(p, at, number(v, 'alpha')));
}

/** The width of the section: that of the shape across its middle. */
function width(form: Form, request: Request): number {
  const v = request.values;
  if (form.group === 'axis') return number(v, 'phi', toolDiameter(request));
  if (typeof v.L === 'number') return Math.abs(v.L);
  if (typeof v.R === 'number' && form.group !== 'profiles') return 2 * v.R;
  const points = (request.profile?.contours ?? []).flatMap((contour) => outline(contour));
  return points.length ? span(points) : 40;
}

function section(form: Form, request: Request): Item[] {
  const v = request.values;
  const items: Item[] = [];
  const full = Math.max(width(form, request), 0.1);
  const surface = number(v, 'Z');
  const safety = number(v, 'ZS', surface + 5);
  const up = safety < surface || (safety === surface && number(v, 'P') < 0) ? -1 : 1;
  const punched = form.id === 'G281' && word(v, 'mode') === 'angle';
  const depth = punched
    ? number(v, 'phi') / 2 / Math.tan((number(v, 'alpha', 90) * Math.PI) / 360)
    : Math.abs(number(v, 'P'));
  const floor = surface - up * depth;
  // Wide pockets are shown as far as the depth can be read.
  const tall = Math.max(depth + Math.abs(safety - surface), 2);
  const shown = Math.min(full, tall * 3);
  const half = shown / 2;
  const edge = half + Math.max(shown * 0.35, tall * 0.25);
  const below = floor - up * tall * 0.25;
  const boss = form.group === 'bosses';
  const face = form.id === 'G290';

  const walls: Point[] = boss
    ? [[-edge, floor], [-half, floor], [-half, surface], [half, surface], [half, floor], [edge, floor]]
    : face
      ? [[-edge, floor], [edge, floor]]
      : form.id === 'G281'
        ? [[-edge, surface], [-half, surface], [0, floor], [half, surface], [edge, surface]]
        : [[-edge, surface], [-half, surface], [-half, floor], [half, floor], [half, surface], [edge, surface]];
  items.push({ kind: 'area', points: [...walls, [edge, below], [-edge, below]], look: 'material' });
  items.push({ kind: 'line', points: walls, look: 'part' });
  items.push({ kind: 'line', points: [[-edge, surface], [edge, surface]], look: 'level', field: 'Z' });
  items.push({ kind: 'line', points: [[-edge, safety], [edge, safety]], look: 'safety', field: 'ZS' });
  const near = Math.min(form.group === 'axis' ? number(v, 'DP', 1) : 1, Math.abs(safety - surface));
  items.push({ kind: 'line', points: [[-edge, surface + up * near], [edge, surface + up * near]], look: 'level', field: 'DP' });

  const at = edge * 1.08;
  items.push({ kind: 'measure', field: 'P', from: [at, surface], to: [at, floor], aside: 0 });
  items.push({ kind: 'measure', field: 'ZS', from: [at, 0], to: [at, safety], aside: edge * 0.16 });
  items.push({ kind: 'measure', field: 'Z', from: [at, 0], to: [at, surface], aside: edge * 0.3 });
  if (form.group === 'axis') {
    items.push({ kind: 'measure', field: 'DP', from: [-edge * 0.9, surface], to: [-edge * 0.9, surface + up * near], aside: 0 });
  }
  const step = ['rough.I', 'rough.I1', 'I'].find((name) => typeof v[name] === 'number');
  if (step) {
    const cutting = request.tools[0]?.cutting_length ?? 0;
    const wanted = Math.abs(number(v, step)) || cutting || depth;
    const exact = number(v, step) < 0;
    const stock = number(v, 'finish.deltaz');
    const reach = Math.max(0, depth - stock);
    const count = Math.min(60, Math.max(1, Math.ceil(reach / Math.max(wanted, 1e-3) - 1e-9)));
    const each = exact || form.group === 'axis' ? wanted : reach / count;
    for (let i = 1; i < count; i += 1) {
      const z = surface - up * Math.min(reach, each * i);
      const inside: Point[] = boss || face ? [[-edge, z], [boss ? -half : edge, z]] : [[-half, z], [half, z]];
      items.push({ kind: 'line', points: inside, look: 'level', field: step });
    }
    const x = boss || face ? -edge * 0.8 : -half * 0.55;
    items.push({ kind: 'measure', field: step, from: [x, surface], to: [x, surface - up * Math.min(each, reach)], aside: 0 });
  }
  const floorStock = number(v, 'finish.deltaz');
  if (floorStock > 0) {
    const z = floor + up * floorStock;
    items.push({ kind: 'line', points: [[-half, z], [half, z]], look: 'stock', field: 'finish.deltaz' });
    items.push({ kind: 'measure', field: 'finish.deltaz', from: [half * 0.3, floor], to: [half * 0.3, z], aside: 0 });
  }
  const name = typeof v['finish.delta'] === 'number' ? 'finish.delta' : 'delta';
  const wallStock = number(v, name);
  if (wallStock > 0 && !face && form.group !== 'axis') {
    const x = boss ? -half - wallStock : -half + wallStock;
    items.push({ kind: 'line', points: [[x, surface], [x, floor]], look: 'stock', field: name });
    const z = surface - up * depth * 0.6;
    items.push({ kind: 'measure', field: name, from: [-half, z], to: [x, z], aside: 0 });
  }
  if (typeof v.ZR === 'number') {
    items.push({ kind: 'line', points: [[-half, v.ZR], [half, v.ZR]], look: 'safety', field: 'ZR' });
  }
  if (typeof v.B === 'number' && (form.id === 'G298' || form.id === 'G299')) {
    const pitch = Math.abs(v.B);
    items.push({ kind: 'measure', field: 'B', from: [0, floor], to: [0, floor + up * pitch], aside: 0 });
  }
  if (punched) items.push({ kind: 'angle', field: 'alpha', at: [0, floor], from: 90 - number(v, 'alpha') / 2, to: 90 + number(v, 'alpha') / 2, radius: depth * 0.6 });
  // The tool above what it does.
  const radius = Math.min(toolDiameter(request), full) / 2;
  const tip = safety;
  const left = form.group === 'axis' ? 0 : boss ? -half - radius * 1.2 : 0;
  const shaft = tip + up * tall * 0.3;
  const body: Point[] =
    form.id === 'G281' || form.id === 'G282' || form.id === 'G283'
      ? [[left - radius, shaft], [left - radius, tip + up * radius * 0.6], [left, tip], [left + radius, tip + up * radius * 0.6], [left + radius, shaft]]
      : [[left - radius, shaft], [left - radius, tip], [left + radius, tip], [left + radius, shaft]];
  items.push({ kind: 'line', points: body, look: 'tool' });
  return items;
}

/** What a form looks like. */
export function scene(form: Form, request: Request): Scene {
  return { plan: plan(form, request), section: section(form, request) };
}

/** Every point of the items, for their box. */
export function places(items: Item[]): Point[] {
  return items.flatMap((item) => {
    switch (item.kind) {
      case 'line':
      case 'area':
        return item.points;
      case 'measure': {
        const long = distance(item.from, item.to) || 1;
        const [nx, ny] = [-(item.to[1] - item.from[1]) / long, (item.to[0] - item.from[0]) / long];
        return [item.from, item.to].flatMap((p): Point[] => [p, [p[0] + nx * item.aside, p[1] + ny * item.aside]]);
      }
      default:
        return [item.at];
    }
  });
}
