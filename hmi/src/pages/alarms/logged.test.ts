import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { text } from '$lib/i18n/plural';
import { logged } from './logged';

const read = (path: string) => readFileSync(join(import.meta.dirname, '../../../..', path), 'utf8');
const catalogue = (language: string): Record<string, string> =>
  Object.fromEntries(
    ['log', 'item'].flatMap((page) =>
      Object.entries(JSON.parse(read(`hmi/src/locales/${language}/${page}.json`)) as Record<string, string>).map(([key, value]) => [`${page}.${key}`, value]),
    ),
  );
const texts = (language: string) => {
  const all = catalogue(language);
  return { t: (key: string, values?: Record<string, string | number>) => text(all, language, key, values), has: (key: string) => key in all };
};

/** The words that a source gives to the log: strings in an entry, and those of its parts, with a number for each value. */
function words(path: string, ...forms: RegExp[]): string[] {
  const source = read(path).split('#[cfg(test)]')[0]!;
  return forms.flatMap((form) => [...source.matchAll(form)].flatMap((found) => found.slice(1).filter(Boolean))).map((one) => one.replace(/\{\w*\}/g, '4'));
}

const memory = 'crates/memory/src';
const entry = [/\bname: "([^"]+)"/g, /\bname: format!\("([^"]+)"/g, /\bto: "([^"]+)"/g, /if fits \{ "(\w+)" \} else \{ "(\w+)" \}/g];
const seats = /Seat::\w+ => "(\w+)"/g;
/** Where each is said: the field and the item. */
const said: Record<'name' | 'value', Record<string, string[]>> = {
  name: {
    rights: [...words(`${memory}/password.rs`, entry[1]!), ...words(`${memory}/items.rs`, /SessionNote::\w+(?: \{ to \})? => \("([^"]+)"/g)],
    memory: [...words(`${memory}/backup.rs`, entry[0]!), ...words(`${memory}/damage.rs`, entry[0]!)],
    ladder: words(`${memory}/apply.rs`, /Item::Ladder, "([^"]+)"/g),
    alarms: words(`${memory}/apply.rs`, /Item::Alarms, "([^"]+)"/g),
    log: words(`${memory}/apply.rs`, /Item::Log, "([^"]+)"/g),
    position: words(`${memory}/apply.rs`, /format!\("(machine zero [^"]+)"/g).map((one) => one.replace('4', 'X')),
    counters: words(`${memory}/items.rs`, /Counter::\w+ => "([^"]+)"/g),
    offsets: words(`${memory}/rows.rs`, /\("(\w+)", offset\.\w+\)/g).map((name) => `4 ${name}`),
  },
  value: {
    rights: [...words(`${memory}/password.rs`, entry[2]!, entry[3]!, seats), ...words(`${memory}/items.rs`, /SessionNote::\w+(?: \{ to \})? => \("[^"]+", (?:format!\()?"([^"]+)"/g)],
    programs: words(`${memory}/apply.rs`, /format!\("(locked [^"]+)"/g),
    plc: words(`${memory}/apply.rs`, /map_or\("(\w+)"\.to_owned\(\), \|on\|/g, /format!\("(forced [^"]+)"/g).map((one) => one.replace('4', '1')),
    memory: words(`${memory}/error.rs`, /(?:f\.write_str|write!)\((?:f, )?"((?:memory|mark)[^"]+)"/g),
  },
};
const who = [
  ...words(`${memory}/author.rs`, /Author::Control => "(\w+)"/g),
  ...words('crates/server/src/hub.rs', /format!\("(connection [^"]+)"/g),
  ...words('crates/server/src/web/session.rs', /format!\("(panel from [^"]+)"/g),
  ...words('crates/ferrocut/src/commands/memory.rs', /"(ferrocut memory(?: \([^"]*\))?)"/g),
];
const items = words(`${memory}/items.rs`, /Item::\w+ => "([^"]+)"/g);

describe('the operation log', () => {
  it('is read as the control writes it', () => {
    expect(said.name).toMatchObject({ rights: ['log in 4', 'password 4', ...Array<string>(6).fill('command'), 'log out'], memory: ['restored', 'uploaded', 'recovered'], ladder: ['exchanged'], alarms: ['all'], log: ['all'], position: ['machine zero X'] });
    expect(said.value).toMatchObject({ rights: ['set', 'right', 'wrong', 'machine', 'network', 'taken', 'left', 'asked for', 'asked for no longer', 'handed over to connection 4', 'declined to connection 4'], programs: ['locked 4'], plc: ['released', 'forced 1'] });
    expect(said.value.memory).toHaveLength(7);
    expect(said.name.counters).toHaveLength(7);
    expect(said.name.offsets).toHaveLength(7);
    expect(who).toEqual(['control', 'connection 4', 'connection 4 from 4', 'panel from 4', 'ferrocut memory', 'ferrocut memory (4)']);
    expect(items).toHaveLength(14);
  });

  it.each(['en', 'zh', 'ru', 'es', 'tr'])('has a text in %s for all that the control says', (language) => {
    const of = texts(language);
    const line = { time: 0, level: null, who: '', item: '', name: '', from: '', to: '' };
    const raw: string[] = [];
    const judge = (words: string, shown: string) => {
      if (shown === words || /\blog\.|[{}]/.test(shown)) raw.push(`${words}: ${shown}`);
    };
    for (const one of who) judge(one, logged({ ...line, who: one }, of).who);
    for (const one of [...items, 'rights', 'memory']) judge(one, logged({ ...line, item: one }, of).item);
    for (const [item, names] of Object.entries(said.name)) for (const name of names) judge(name, logged({ ...line, item, name }, of).name);
    for (const [item, values] of Object.entries(said.value)) {
      for (const value of values) {
        judge(value, logged({ ...line, item, from: value }, of).from);
        judge(value, logged({ ...line, item, to: value }, of).to);
      }
    }
    expect(raw).toEqual([]);
  });

  it('shows names, numbers and paths as they are', () => {
    const of = texts('en');
    const line = { time: 0, level: 4, who: 'O0001', item: 'parameters', name: 'P98', from: '5', to: '6' };
    expect(logged(line, of)).toEqual({ who: 'O0001', item: 'Parameters', name: 'P98', from: '5', to: '6' });
    const restored = { ...line, who: 'panel from 192.0.2.7', item: 'memory', name: 'restored', from: '/backups/a b.backup', to: 'offsets ladder' };
    expect(logged(restored, of)).toEqual({ who: 'Panel at 192.0.2.7', item: 'Memory', name: 'Restored', from: '/backups/a b.backup', to: 'Tool offsets, Ladder' });
  });
});
