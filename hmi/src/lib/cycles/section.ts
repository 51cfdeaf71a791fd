// A form in section: planes, depth, passes and the tool above them.
import { number, outline, word } from './geometry';
import { angle, isBoss, isHole, measure, span, toward, type Item, type Subject } from './items';
import { holeDiameter } from './plan';
import type { Point } from './geometry';

/** How close the tool comes at rapid where a form has no distance for it, mm (4.1.2). */
const NEAR = 1;

/** Drills, whose tip is a point. */
const POINTED = ['G281', 'G282', 'G283'];

/** The place of what is the tool's, and how it moves. */
const OF_TOOL: Record<string, 'shaft' | 'down' | 'along' | 'floor' | 'out'> = {
  T: 'shaft', D: 'shaft', S: 'shaft', FZ: 'down', F: 'along', t: 'floor', KF: 'out',
};

/** The width of the section: that of the shape across its middle. */
function width(of: Subject): number {
  if (isHole(of)) return holeDiameter(of);
  if (of.has('L')) return Math.abs(number(of.values, 'L'));
  if (of.has('R')) return 2 * number(of.values, 'R');
  const points = (of.request.profile?.contours ?? []).flatMap(outline);
  return points.length ? span(points) : 40;
}

/** The levels and widths of a section. */
type Room = {
  surface: number;
  safety: number;
  floor: number;
  /** Where the tool comes to at rapid. */
  near: number;
  depth: number;
  /** 1 where the tool is above the part, else -1. */
  up: 1 | -1;
  /** Half the width that is shown, and half that of the part. */
  half: number;
  edge: number;
};

function roomOf(of: Subject): Room {
  const v = of.values;
  const full = Math.max(width(of), 0.1);
  const surface = number(v, 'Z');
  const safety = number(v, 'ZS', surface + 5);
  const up = safety < surface || (safety === surface && number(v, 'P') < 0) ? -1 : 1;
  const depth =
    word(v, 'mode') === 'angle'
      ? number(v, 'phi') / 2 / Math.tan((number(v, 'alpha', 90) * Math.PI) / 360)
      : Math.abs(number(v, 'P'));
  // Wide pockets are shown as far as the depth can be read.
  const tall = Math.max(depth + Math.abs(safety - surface), 2);
  const half = Math.min(full, tall * 3) / 2;
  const near = surface + up * Math.min(number(v, 'DP', NEAR), Math.abs(safety - surface));
  const edge = half + Math.max(half * 0.7, tall * 0.25);
  return { surface, safety, floor: surface - up * depth, near, depth, up, half, edge };
}

function part(of: Subject, { surface, floor, up, half, edge, depth, safety }: Room): Item[] {
  const walls: Point[] = isBoss(of)
    ? [[-edge, floor], [-half, floor], [-half, surface], [half, surface], [half, floor], [edge, floor]]
    : of.form.id === 'G290'
      ? [[-edge, floor], [edge, floor]]
      : of.form.id === 'G281'
        ? [[-edge, surface], [-half, surface], [0, floor], [half, surface], [edge, surface]]
        : [[-edge, surface], [-half, surface], [-half, floor], [half, floor], [half, surface], [edge, surface]];
  const below = floor - up * Math.max(depth + Math.abs(safety - surface), 2) * 0.25;
  return [
    { kind: 'area', points: [...walls, [edge, below], [-edge, below]], look: 'material' },
    { kind: 'line', points: walls, look: 'part' },
  ];
}

function planes(of: Subject, { surface, safety, floor, near, edge }: Room): Item[] {
  const level = (field: string, z: number, look: 'level' | 'safety'): Item => ({
    kind: 'line', points: [[-edge, z], [edge, z]], look, field,
  });
  const at = edge * 1.08;
  const items = [
    level('Z', surface, 'level'),
    level('ZS', safety, 'safety'),
    level('DP', near, 'level'),
    measure('P', [at, surface], [at, floor]),
    measure('ZS', [at, 0], [at, safety], edge * 0.16),
    measure('Z', [at, 0], [at, surface], edge * 0.3),
  ];
  if (of.has('DP')) items.push(measure('DP', [-edge * 0.9, surface], [-edge * 0.9, near]));
  if (of.has('ZR')) {
    const back = number(of.values, 'ZR', near);
    items.push(level('ZR', back, 'safety'), measure('ZR', [at, 0], [at, back], edge * 0.44));
  }
  return items;
}

/** Levels of passes in depth (4.12), and for pecks how far the tool is drawn back (4.4). */
function levels(of: Subject, { surface, near, depth, up, half, edge }: Room): Item[] {
  const v = of.values;
  const field = ['rough.I', 'rough.I1', 'I'].find(of.has);
  if (!field) return [];
  const items: Item[] = [];
  const boss = isBoss(of);
  const open = boss || of.form.id === 'G290';
  const longest = of.request.tools[0]?.cutting_length ?? 0;
  const wanted = Math.abs(number(v, field)) || longest || depth;
  const reach = Math.max(0, depth - number(v, 'finish.deltaz'));
  const count = Math.min(60, Math.max(1, Math.ceil(reach / Math.max(wanted, 1e-3) - 1e-9)));
  const each = number(v, field) < 0 || isHole(of) ? wanted : reach / count;
  for (let i = 1; i < count; i += 1) {
    const z = surface - up * Math.min(reach, each * i);
    const inside: Point[] = open ? [[-edge, z], [boss ? -half : edge, z]] : [[-half, z], [half, z]];
    items.push({ kind: 'line', points: inside, look: 'level', field });
  }
  const first = surface - up * Math.min(each, reach);
  const x = open ? -edge * 0.8 : -half * 0.55;
  items.push(measure(field, [x, surface], [x, first]));
  if (of.has('semi.I2')) {
    const semi = surface - up * Math.min(Math.abs(number(v, 'semi.I2')), depth);
    items.push({ kind: 'line', points: [[half * 0.7, semi], [half, semi]], look: 'level', field: 'semi.I2' });
    items.push(measure('semi.I2', [half * 0.8, surface], [half * 0.8, semi]));
  }
  if (of.form.id === 'G283') {
    const back = number(v, 'B') > 0 ? first + up * number(v, 'B') : near;
    items.push(measure('B', [half * 0.55, first], [half * 0.55, back]));
  }
  return items;
}

/** Stock on floor and wall, and the passes along the wall. */
function stock(of: Subject, { surface, floor, depth, up, half, edge }: Room): Item[] {
  const v = of.values;
  const items: Item[] = [];
  // The way from the wall into what is cut.
  const into = isBoss(of) ? 1 : -1;
  if (of.has('finish.deltaz')) {
    const z = floor + up * number(v, 'finish.deltaz');
    items.push({ kind: 'line', points: [[-half, z], [half, z]], look: 'stock', field: 'finish.deltaz' });
    items.push(measure('finish.deltaz', [half * 0.45, floor], [half * 0.45, z]));
  }
  const wall = ['finish.delta', 'delta'].find(of.has);
  if (wall && !isHole(of)) {
    const x = -half - into * number(v, wall);
    const z = surface - up * depth * 0.6;
    items.push({ kind: 'line', points: [[x, surface], [x, floor]], look: 'stock', field: wall });
    items.push(measure(wall, [-half, z], [x, z]));
  }
  const across = (z: number, field: string): Item => ({
    kind: 'line', points: [[half - edge * 0.05, z], [half + edge * 0.05, z]], look: 'level', field,
  });
  if (of.has('finish.N')) {
    const count = Math.min(60, Math.max(1, Math.round(number(v, 'finish.N'))));
    for (let i = 1; i <= count; i += 1) items.push(across(surface - (up * depth * i) / count, 'finish.N'));
    items.push({ kind: 'label', field: 'finish.N', at: [half + edge * 0.05, surface - (up * depth) / count / 2] });
  }
  if (of.has('finish.eps')) {
    const z = surface - up * number(v, 'finish.eps');
    items.push(across(surface, 'finish.eps'), across(z, 'finish.eps'));
    items.push(measure('finish.eps', [half, surface], [half, z]));
  }
  return items;
}

/** Angles at which the tool enters: in roughing from the surface, in finishing down to the floor; 0 is straight down
 *  (4.12). */
function entries(of: Subject, { surface, floor, depth, up, half }: Room): Item[] {
  const radius = Math.min(half, depth) * 0.7;
  const steep = (field: string) => number(of.values, field) || 90;
  const items: Item[] = [];
  const ramp = (field: string, at: Point, flat: number, degrees: number) => {
    items.push({ kind: 'line', points: [at, toward(at, degrees, radius)], look: 'level', field });
    items.push(angle(field, at, flat, degrees, radius));
  };
  if (of.has('rough.beta')) ramp('rough.beta', [0, surface], 0, -up * steep('rough.beta'));
  if (of.has('finish.theta')) ramp('finish.theta', [0, floor], 180, 180 - up * steep('finish.theta'));
  return items;
}

/** The hole that is drilled first into a pocket, with planes of its own or those of the pocket (4.15). */
function drilling(of: Subject, { surface, safety, floor, up, half }: Room): Item[] {
  const v = of.values;
  const x = half * 0.8;
  const radius = half * 0.05;
  const top = number(v, 'drill.Z', surface);
  const bottom = top - up * Math.abs(number(v, 'drill.P', (surface - floor) * up));
  const near = top + up * number(v, 'drill.DP', NEAR);
  const at = (aside: number) => x + radius * aside;
  const hole: Point[] = [[at(-1), top], [at(-1), bottom], [at(1), bottom], [at(1), top]];
  const items: Item[] = [
    measure('drill.Z', [at(-2), 0], [at(-2), top]),
    measure('drill.ZS', [at(-3), 0], [at(-3), number(v, 'drill.ZS', safety)]),
    measure('drill.ZR', [at(-4), 0], [at(-4), number(v, 'drill.ZR', near)]),
    measure('drill.DP', [at(2), top], [at(2), near]),
    measure('drill.P', [at(2), top], [at(2), bottom]),
    measure('drill.I', [x, top], [x, top - up * number(v, 'drill.I')]),
  ];
  if (number(v, 'drill.T') > 0) items.push({ kind: 'line', points: hole, look: 'stock', field: 'drill.P' });
  return items;
}

/** The tool above what it does, with what is its own. */
function tool(of: Subject, { surface, safety, floor, depth, up, half }: Room): Item[] {
  const v = of.values;
  const radius = Math.min(of.tool / 2, half);
  const left = isBoss(of) ? -half - radius * 1.2 : 0;
  const length = Math.max(depth + Math.abs(safety - surface), 2) * 0.3;
  const shaft = safety + up * length;
  const shoulder = safety + (POINTED.includes(of.form.id) ? up * radius * 0.6 : 0);
  const [west, east] = [left - radius, left + radius];
  const body: Point[] = [[west, shaft], [west, shoulder], [left, safety], [east, shoulder], [east, shaft]];
  const items: Item[] = [{ kind: 'line', points: body, look: 'tool' }];
  if (of.form.id === 'G299') {
    // Edges are a pitch apart.
    const pitch = Math.abs(number(v, 'B'));
    const count = Math.min(60, Math.max(1, Math.round(number(v, 'N'))));
    for (let i = 0; i < count; i += 1) {
      const z = safety + up * pitch * i;
      items.push({ kind: 'line', points: [[east, z], [east + radius * 0.2, z]], look: 'tool', field: 'N' });
    }
    items.push({ kind: 'label', field: 'N', at: [east + radius * 0.2, safety + (up * pitch * (count - 1)) / 2] });
  }
  const places: Record<(typeof OF_TOOL)[string], Point> = {
    shaft: [left, shaft],
    down: [left, (safety + surface) / 2],
    along: [left, surface - up * depth * 0.5],
    floor: [left, floor],
    out: [east, (safety + surface) / 2],
  };
  for (const { name } of of.form.parameters) {
    const place = OF_TOOL[name.split('.').at(-1)!];
    if (place) items.push({ kind: 'label', field: name, at: places[place] });
  }
  return items;
}

/** The angle of a punch as its cone is drawn (4.2), and the pitch of a helix (4.5, 4.7). */
function ofHoles(of: Subject, { floor, depth, up, half }: Room): Item[] {
  if (of.form.id === 'G281') {
    const open = (Math.atan2(half, depth) * 180) / Math.PI;
    return [angle('alpha', [0, floor], up * (90 - open), up * (90 + open), depth * 0.6)];
  }
  if (of.form.id === 'G298' || of.form.id === 'G299') {
    return [measure('B', [0, floor], [0, floor + up * Math.abs(number(of.values, 'B'))])];
  }
  return [];
}

export function section(of: Subject): Item[] {
  const room = roomOf(of);
  const pieces = [part, planes, levels, stock, entries, ofHoles, tool];
  if (of.has('drill.P')) pieces.push(drilling);
  return pieces.flatMap((piece) => piece(of, room));
}
