// What the operation log has, in the user's language. The control keeps it in words of its own (`docs/memory.md`), so that
// the log of a machine is the same whoever reads it; names, numbers and paths are shown as they are.
import type { LogLine } from '$lib/api/types';
import type { Values } from '$lib/i18n/plural';

export type Texts = { t: (key: string, values?: Values) => string; has: (key: string) => boolean };
/** A form of the control's words, and the text that says it with the values in it. */
type Rule = [form: RegExp, key: string];

const WHO: Rule[] = [
  [/^panel from (?<address>.+)$/, 'log.panel'],
  [/^connection (?<number>\d+) from (?<address>.+)$/, 'log.connection_from'],
  [/^connection (?<number>\d+)$/, 'log.connection'],
  [/^control$/, 'log.control'],
  [/^ferrocut memory \((?<user>.+)\)$/, 'log.maintenance_of'],
  [/^ferrocut memory$/, 'log.maintenance'],
];

/** Names of what was changed, by item. */
const NAMES: Record<string, Rule[]> = {
  rights: [
    [/^log in (?<level>\d)$/, 'log.log_in'],
    [/^password (?<level>\d)$/, 'log.password'],
    [/^command$/, 'log.command'],
    [/^log out$/, 'log.log_out'],
  ],
  memory: [
    [/^restored$/, 'log.restored'],
    [/^uploaded$/, 'log.uploaded'],
    [/^recovered$/, 'log.recovered'],
  ],
  ladder: [[/^exchanged$/, 'log.exchanged']],
  position: [[/^machine zero (?<axis>[A-Z])$/, 'log.machine_zero']],
  alarms: [[/^all$/, 'log.all']],
  log: [[/^all$/, 'log.all']],
  counters: ['parts', 'all-parts', 'run-time', 'cutting-time', 'all-cutting-time', 'power-on-time', 'starts'].map((name) => [new RegExp(`^${name}$`), `log.${name}`]),
  offsets: ['length', 'length_wear', 'radius', 'radius_wear', 'cutting_length', 'entry_angle', 'tip_radius'].map((name) => [
    new RegExp(`^(?<number>\\d+) ${name}$`),
    `log.offset_${name}`,
  ]),
};

/** What it was and became, by item. */
const VALUES: Record<string, Rule[]> = {
  rights: [
    [/^machine$/, 'log.machine'],
    [/^network$/, 'log.network'],
    [/^right$/, 'log.right'],
    [/^wrong$/, 'log.wrong'],
    [/^set$/, 'log.set'],
    [/^taken$/, 'log.taken'],
    [/^left$/, 'log.left'],
    [/^asked for$/, 'log.asked'],
    [/^asked for no longer$/, 'log.withdrawn'],
    [/^handed over to connection (?<number>\d+)$/, 'log.handed_over'],
    [/^declined to connection (?<number>\d+)$/, 'log.declined'],
  ],
  programs: [
    [/^locked (?<level>\d)$/, 'log.locked'],
    // How long a program was and is.
    [/^(?<size>\d+)$/, 'log.bytes'],
  ],
  plc: [
    [/^released$/, 'log.released'],
    [/^forced (?<value>[01])$/, 'log.forced'],
  ],
  memory: [
    [/^memory\.db: missing$/, 'log.finding_missing'],
    [/^memory\.db: schema$/, 'log.finding_schema'],
    [/^memory\.db: (?<table>\w+): row_sum$/, 'log.finding_row'],
    [/^memory\.db: (?<table>\w+): total$/, 'log.finding_total'],
    [/^memory\.db-wal: commits (?<found>\d+) < (?<reported>\d+)$/, 'log.finding_commits'],
    [/^mark: missing$/, 'log.finding_mark'],
    [/^memory\.db: (?<said>.+)$/, 'log.finding_structure'],
  ],
};

function said(words: string, rules: Rule[] = [], { t }: Texts): string {
  for (const [form, key] of rules) {
    const found = form.exec(words);
    if (found) return t(key, found.groups);
  }
  return words;
}

/** An entry, as it is shown. */
export function logged(entry: LogLine, texts: Texts): Pick<LogLine, 'who' | 'item' | 'name' | 'from' | 'to'> {
  const { t, has } = texts;
  const item = (name: string) => (has(`item.${name}`) ? t(`item.${name}`) : name);
  const value = (words: string) => {
    // A backup has items, by their names.
    const names = entry.item === 'memory' ? words.split(' ') : [];
    return names.length && names.every((name) => has(`item.${name}`)) ? names.map(item).join(', ') : said(words, VALUES[entry.item], texts);
  };
  return {
    who: said(entry.who, WHO, texts),
    item: item(entry.item),
    name: said(entry.name, NAMES[entry.item], texts),
    from: value(entry.from),
    to: value(entry.to),
  };
}
