// Each field of each form has its mark in the drawing. `forms.json` holds the forms of the server; a test of the panel
// (tests/cycles.spec.ts) holds it to them.
import { describe, expect, it } from 'vitest';
import kept from './forms.json';
import { distance } from './geometry';
import { fresh, stands, type Named } from './items';
import { key } from './rows';
import { places, scene } from './scene';
import type { Contour, Form, FormField, Positions } from '$lib/api/cycles';
import type { Point, Values } from './geometry';

type Field = Pick<FormField, 'name' | 'kind' | 'standard'>;
type Kept = Pick<Form, 'id' | 'group' | 'profile'> & { parameters: Field[]; positions: string[] };

const forms = kept.forms as Kept[];
const figures: { kind: string; parameters: Field[] }[] = kept.figures;

/** Kinds of fields that have no place in a drawing. */
const PLACELESS: Record<string, string> = {
  choice: 'a word: what it chooses is drawn itself, or is an order of moves that the simulation shows',
  name: 'a word: the profile that it names is drawn itself',
};

/** Fields besides, by their name without the stage. */
const EXCEPT: Record<string, string> = {
  next: 'a tool that is prepared while this one works does nothing here',
  ...Object.fromEntries(
    ['M1', 'M2', 'M3', 'M4'].map((name) => [name, 'an M function before the stage is no part of its shape']),
  ),
};

/** Fields that are no size but its bound: the drawing has what comes of it. */
const BOUNDS: Record<string, string> = {
  I: 'a depth of pass that is divided into equal passes (4.11)',
};

const bare = (name: string) => name.split('.').at(-1)!;
const isMarked = ({ name, kind }: Field) => !(kind in PLACELESS) && !(bare(name) in EXCEPT);

const contour: Contour = {
  start: [-40, -25],
  elements: [
    { kind: 'line', to: [40, -25] },
    { kind: 'line', to: [40, 25], corner: { kind: 'round', size: 8 } },
    { kind: 'line', to: [-40, 25] },
  ],
};

/** Fillings of a form: as it is when fresh, with a number in each field, and with none. */
const fillings: Record<string, (fields: Field[]) => Values> = {
  fresh: (fields) => fresh(fields as FormField[]),
  full: (fields) =>
    Object.fromEntries(
      fields.flatMap(({ name, kind, standard }, i) => {
        if (kind in PLACELESS) return standard === null ? [] : [[name, standard]];
        return [[name, standard === null || standard === 0 ? 2 + i / 4 : standard]];
      }),
    ),
  empty: () => ({}),
};

function drawn(form: Kept, values: Values, positions: Positions[] = []) {
  const contours = form.profile === 'none' ? [] : [contour];
  const given = { cycle: form.id, values, positions, profile: { contours }, depths: [], tools: [] };
  return scene(form as unknown as Form, given);
}

function named(form: Kept, values: Values, positions?: Positions[]): Named[] {
  const { plan, section } = drawn(form, values, positions);
  const items = [...plan, ...section];
  expect(places(items).flat().every(Number.isFinite), `${form.id}: a place is no number`).toBe(true);
  const kinds = ['measure', 'angle', 'label'];
  return items.filter((item): item is Named => kinds.includes(item.kind));
}

const find = (form: string) => forms.find((one) => one.id === form)!;

describe.each(Object.entries(fillings))('a form that is %s', (_, fill) => {
  it.each(forms.map((form) => [form.id, form] as const))('%s has a mark for each field', (_, form) => {
    const marks = new Set(named(form, fill(form.parameters)).map((item) => item.field));
    const wanted = form.parameters.filter(isMarked).map((field) => field.name);
    expect(wanted.filter((name) => !marks.has(name))).toEqual([]);
  });
  const each = figures.map((figure) => [figure.kind, figure] as const);
  it.each(each)('%s has a mark for each field, at every cycle', (kind, figure) => {
    const positions: Positions = { kind, values: fill(figure.parameters), points: [[1, 2]] };
    for (const form of forms.filter((one) => one.positions.includes(kind))) {
      const marks = new Set(named(form, fill(form.parameters), [positions]).map((item) => item.field));
      const wanted = figure.parameters.filter(isMarked).map((field) => key(field.name));
      if (kind === 'POINTS') wanted.push(key('P2'));
      expect(wanted.filter((name) => !marks.has(name)), form.id).toEqual([]);
    }
  });
});

describe('marks', () => {
  it('name fields that the form has', () => {
    for (const form of forms) {
      const names = new Set(form.parameters.map((field) => field.name));
      const marks = named(form, fillings.full!(form.parameters)).map((item) => item.field);
      expect(marks.filter((name) => !names.has(name)), form.id).toEqual([]);
    }
  });

  it('of lengths are as long as their value, of angles as wide', () => {
    const wrong: string[] = [];
    for (const form of forms) {
      const values = fillings.full!(form.parameters);
      for (const item of named(form, values)) {
        if (item.kind === 'label' || bare(item.field) in BOUNDS) continue;
        const { from, to } = item;
        const size = item.kind === 'angle' ? Math.abs(item.to - item.from) : distance(from as Point, to as Point);
        const value = Math.abs(values[item.field] as number);
        if (Math.abs(size - value) > 1e-6) wrong.push(`${form.id} ${item.field} ${value}: ${size}`);
      }
    }
    expect(wrong).toEqual([]);
  });

  it('of an empty field follow from the others, and stand only in focus', () => {
    const values = { N: 4, L: 75, alpha: 0 };
    const marks = named(find('G282'), { X: 25, Y: 5 }, [{ kind: 'LINE', values, points: [] }]);
    const distance = marks.find((item) => item.field === key('I'));
    expect(distance).toMatchObject({ kind: 'measure', from: [25, 5], to: [50, 5] });
    const filled = { 'positions.N': 4, 'positions.L': 75 };
    const standing = marks.filter((item) => stands(item, filled)).map((item) => item.field);
    expect(standing).toEqual([key('L')]);
  });

  it('of a stage that has no tool stand only in focus', () => {
    const marks = named(find('P2D'), { 'drill.T': 0, 'drill.I': 5 });
    const peck = marks.find((item) => item.field === 'drill.I')!;
    expect(stands(peck, { 'drill.T': 0, 'drill.I': 5 })).toBe(false);
    expect(stands(peck, { 'drill.T': 3, 'drill.I': 5 })).toBe(true);
  });
});
