// What drawings of forms are made of, and what a drawing is asked for.
import { number } from './geometry';
import type { Form, FormField, Request } from '$lib/api/cycles';
import type { Point, Values } from './geometry';

type Look = 'part' | 'wall' | 'safety' | 'level' | 'tool' | 'stock' | 'row';

/** A piece of a drawing, mm; in the section the ordinate is the tool axis. */
export type Item =
  | { kind: 'line'; points: Point[]; look: Look; field?: string }
  | { kind: 'area'; points: Point[]; look: 'material' | 'cut' }
  | { kind: 'measure'; field: string; from: Point; to: Point; /** How far aside it stands. */ aside: number }
  | { kind: 'angle'; field: string; at: Point; /** Degrees. */ from: number; to: number; radius: number }
  /** The place of what has no length: counts, feeds, speeds. */
  | { kind: 'label'; field: string; at: Point }
  | { kind: 'mark'; field?: string; at: Point };

/** The kinds that name their field beside them. */
export type Named = Extract<Item, { kind: 'measure' | 'angle' | 'label' }>;

/** A form as it is drawn. */
export type Subject = {
  form: Form;
  request: Request;
  /** What is filled in; a field that is empty is drawn as in a fresh form. */
  values: Values;
  /** Whether the form has a field. */
  has: (name: string) => boolean;
  /** Diameter of the tool, mm. */
  tool: number;
};

/** What stands in a fresh form. */
export function fresh(fields: FormField[]): Values {
  const values: Values = {};
  for (const field of fields) if (field.standard !== null) values[field.name] = field.standard;
  return values;
}

/** Diameter of the tool of a stage, mm. */
export function toolDiameter(request: Request): number {
  const stage = ['rough.T', 'T', 'finish.T'].map((name) => request.values[name]).find((value) => Number(value) > 0);
  return request.tools.find((tool) => tool.number === stage)?.diameter || 8;
}

export function subject(form: Form, request: Request): Subject {
  const names = new Set(form.parameters.map((field) => field.name));
  return {
    form,
    request,
    values: { ...fresh(form.parameters), ...request.values },
    has: (name) => names.has(name),
    tool: toolDiameter(request),
  };
}

export const isBoss = ({ form }: Subject) => form.group === 'bosses';
export const isHole = ({ form }: Subject) => form.group === 'axis';

/** The size by which measures stand aside, mm. */
export function span(points: Point[]): number {
  const xs = points.map((p) => p[0]);
  const ys = points.map((p) => p[1]);
  return Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys), 4);
}

export function measure(field: string, from: Point, to: Point, aside = 0): Item {
  return { kind: 'measure', field, from, to, aside };
}

/** An angle at a point, degrees. */
export function angle(field: string, at: Point, from: number, to: number, radius: number): Item {
  return { kind: 'angle', field, at, from, to, radius };
}

/** Both coordinates of a point, from the zero point. */
export function coordinates([x, y]: [string, string], at: Point, aside: number): Item[] {
  return [measure(x, [0, at[1]], at, -aside), measure(y, [at[0], 0], at, aside)];
}

/** The point at a distance from another in a direction, degrees. */
export function toward(from: Point, degrees: number, by: number): Point {
  const angle = (degrees * Math.PI) / 180;
  return [from[0] + by * Math.cos(angle), from[1] + by * Math.sin(angle)];
}

/** Whether a field that is named stands in the drawing although it is not in focus: what is a length or an angle of a
 *  stage that has a tool. */
export function stands(item: Named, values: Values): boolean {
  const stage = item.field.includes('.') ? item.field.split('.')[0] : '';
  return item.kind !== 'label' && number(values, item.field) !== 0 && values[`${stage}.T`] !== 0;
}
