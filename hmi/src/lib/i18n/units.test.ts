import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { unitKey } from './units';

const root = join(import.meta.dirname, '../../../..');

/** The signs of units in the control's own lists and in the forms of its cycles. */
function signs(): string[] {
  const rows = readFileSync(join(root, 'crates/machine/data/gsk990mc/data-parameters.csv'), 'utf8').split('\n').slice(1);
  const cells = (row: string) => row.match(/("([^"]|"")*"|[^,]*)(,|$)/g)?.map((cell) => cell.replace(/,$/, '')) ?? [];
  const forms = readFileSync(join(root, 'crates/editor/src/fields.rs'), 'utf8');
  const body = forms.split('fn unit(self)')[1]!.split('fn is_whole')[0]!;
  const all = [...rows.map((row) => cells(row)[3] ?? ''), ...[...body.matchAll(/=> "([^"]*)"/g)].map((found) => found[1]!)];
  return [...new Set(all)].filter(Boolean).sort();
}

it.each(['en', 'zh', 'ru', 'es', 'tr'])('%s has every unit of parameters and cycles', (language) => {
  const texts = JSON.parse(readFileSync(join(root, 'hmi/src/locales', language, 'unit.json'), 'utf8')) as Record<string, string>;
  expect(signs()).toContain('mm/min');
  expect(signs().filter((sign) => !(unitKey(sign).slice('unit.'.length) in texts))).toEqual([]);
});
