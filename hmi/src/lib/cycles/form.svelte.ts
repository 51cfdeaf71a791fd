// Forms as they were filled in, each cycle's its own, kept while the panel is open.
import type { Contour, Depth, Element, Form, FormField, Positions, Request, ToolData, Value } from '$lib/api/cycles';
import { fresh } from './items';
import { key } from './rows';
import type { Values } from './geometry';

export type Filled = {
  values: Values;
  positions: Positions | null;
  contours: Contour[];
  depths: Depth[];
};

const filled = $state<Record<string, Filled>>({});
/** What somebody typed of tools; all else is as the machine's table has it. */
const own = $state<Record<number, ToolData>>({});
/** Diameters of the machine's table, wear included. */
let table = $state.raw<Record<number, number>>({});
let chosen = $state('G287');

/** A contour to begin with: a square with round corners, open where the tool follows it. */
function contours(form: Form): Contour[] {
  const corners: [number, number][] = [[-40, -25], [40, -25], [40, 25], [-40, 25]];
  const round = { kind: 'round' as const, size: 8 };
  if (form.profile === 'none') return [];
  if (form.profile === 'contours' || form.profile === 'depths') {
    // It begins on a side: where a profile of depth begins, there is no corner.
    const elements = corners.map((to): Element => ({ kind: 'line', to, corner: { ...round } }));
    return [{ start: [-40, 0], elements: [...elements, { kind: 'line', to: [-40, 0], corner: null }], entry: 0, exit: 0 }];
  }
  const elements = corners.slice(1).map((to, i): Element => ({ kind: 'line', to, corner: i < 2 ? { ...round } : null }));
  return [{ start: [-40, -25], elements, entry: 0, exit: 0 }];
}

export const forms = {
  get chosen() {
    return chosen;
  },
  choose(id: string): void {
    chosen = id;
  },
  /** The form of a cycle as filled in; none before it was begun. */
  of(form: Form): Filled | undefined {
    return filled[form.id];
  },
  /** Begins a form where it is not. */
  begin(form: Form): void {
    if (!(form.id in filled)) this.clear(form);
  },
  /** Begins a form anew. */
  clear(form: Form): void {
    filled[form.id] = { values: fresh(form.parameters), positions: null, contours: contours(form), depths: [] };
  },
  /** Fills a form in as a cycle of a program is. */
  fill(form: Form, { values, positions, profile, depths }: Request): void {
    filled[form.id] = { values: { ...values }, positions: positions[0] ?? null, contours: profile?.contours ?? contours(form), depths };
    chosen = form.id;
  },
  figure(form: Form, kind: string): Positions | null {
    const found = form.positions.find((one) => one.kind === kind);
    return found ? { kind, values: fresh(found.parameters), points: [] } : null;
  },
  /** What is known of a tool. */
  tool(number: number): ToolData & { diameter: number } {
    return { number, ...own[number], diameter: own[number]?.diameter ?? table[number] ?? 0 };
  },
  /** What was typed of a tool; none where it is as the machine's table has it. */
  ownTool(number: number): ToolData | undefined {
    return own[number];
  },
  /** Something of a tool was typed; null is as the table has it. */
  setTool(number: number, typed: Partial<ToolData>): void {
    const all = Object.entries({ ...own[number], ...typed, number }).filter(([, value]) => value !== null);
    if (all.length > 1) own[number] = Object.fromEntries(all) as ToolData;
    else delete own[number];
  },
  /** A tool is as the table has it. */
  dropTool(number: number): void {
    delete own[number];
  },
  /** What the machine's table has, by number. */
  setTable(diameters: Record<number, number>): void {
    table = diameters;
  },
};

/** The numbers of the tools that a form calls. */
export function toolsOf(values: Values): number[] {
  const names = ['T', 'drill.T', 'rough.T', 'semi.T', 'finish.T'];
  const called = names.map((name) => values[name]).filter((value): value is number => typeof value === 'number');
  return [...new Set(called.filter((value) => Number.isInteger(value) && value > 0 && value < 10_000))].sort((a, b) => a - b);
}

/** What the server is asked for. */
export function request(form: Form, of: Filled): Request {
  const values: Record<string, Value> = {};
  for (const field of form.parameters) {
    const value = of.values[field.name];
    if (value !== undefined && value !== '') values[field.name] = value;
  }
  if (form.profile !== 'depths' || of.depths.length === 0) for (const name of ['Z1', 'Z2', 'Z3', 'Z4']) delete values[name];
  else of.depths.forEach((_, i) => (values[`Z${i + 1}`] ??= `DEPTH${i + 1}`));
  return {
    cycle: form.id,
    values,
    positions: of.positions && form.positions.length ? [of.positions] : [],
    profile: form.profile === 'none' ? null : { contours: of.contours },
    depths: form.profile === 'depths' ? of.depths : [],
    tools: toolsOf(values).flatMap((number) => forms.ownTool(number) ?? []),
  };
}

/** A field of positions under the key that findings and drawings have for it. */
export const placed = (field: FormField): FormField => ({ ...field, name: key(field.name) });

/** Every field of a form and of its positions, with what is filled in. */
export function drawn(form: Form, of: Filled): { fields: FormField[]; values: Values } {
  const figure = form.positions.find((one) => one.kind === of.positions?.kind);
  const positions = Object.entries(of.positions?.values ?? {}).map(([name, value]) => [key(name), value] as const);
  return {
    fields: [...form.parameters, ...(figure?.parameters ?? []).map(placed)],
    values: { ...of.values, ...Object.fromEntries(positions) },
  };
}

/** The axis whose position a field may take, counted from 0; none where it is no position (3.3). */
export function axisOf(field: FormField): number | null {
  if (field.kind !== 'length' || field.stage !== 'cycle') return null;
  if (['X', 'XC', 'X1', 'XN', 'XA'].includes(field.name)) return 0;
  if (['Y', 'YC', 'Y1', 'YN', 'YA'].includes(field.name)) return 1;
  if (['Z', 'ZS', 'ZR'].includes(field.name)) return 2;
  return null;
}
