// What drawings of forms depend on, as `src/lib/cycles/forms.json` keeps it for tests without a server.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Form, FormField } from '../src/lib/api/cycles.ts';

const path = join(import.meta.dirname, '../src/lib/cycles/forms.json');

const field = ({ name, kind, standard }: FormField) => ({ name, kind, standard });

/** Forms without texts and ranges, their figures once. */
export function kept(forms: Form[]) {
  const figures = new Map(forms.flatMap((form) => form.positions).map((one) => [one.kind, one]));
  return {
    figures: [...figures.values()].map(({ kind, parameters }) => ({ kind, parameters: parameters.map(field) })),
    forms: forms.map(({ id, group, profile, parameters, positions }) => ({
      id, group, profile, positions: positions.map((one) => one.kind), parameters: parameters.map(field),
    })),
  };
}

export function read(): unknown {
  return JSON.parse(readFileSync(path, 'utf8'));
}

export function write(forms: Form[]): void {
  // A field a line.
  const text = JSON.stringify(kept(forms), null, 2).replace(/\{[^{}[\]]*\}/g, (one) => one.replace(/\s+/g, ' '));
  writeFileSync(path, `${text}\n`);
}
