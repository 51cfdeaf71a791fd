// What the panel itself can be asked in the box of the help: how something is done, what this machine has no page for, and
// the calculator.
import { calculate } from './calculate';
import { notHere, operations } from './operations';

export type Local = {
  kind: 'operation' | 'not_here' | 'calculator';
  id: string;
  title: string;
  text: string;
  /** The page where it is done, with its tab. */
  page: string[];
  /** Whether it is what was sought, and does not only speak of it. */
  isNear: boolean;
};

const bare = /^[-+−]?[\d.,\s]*$/;

/** What is found, in the language in which `t` gives texts. */
export function findLocal(sought: string, t: (key: string) => string): Local[] {
  const words = sought.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  const has = (...texts: string[]) => words.every((word) => texts.join(' ').toLowerCase().includes(word));
  const all: Omit<Local, 'isNear'>[] = [
    ...operations.map(([id, page]) => ({ kind: 'operation' as const, id, title: t(`operations.${id}`), text: t(`operations.${id}_how`), page: page.split('/') })),
    ...notHere.map(([id]) => ({ kind: 'not_here' as const, id, title: t(`operations.not_${id}`), text: t(`operations.not_${id}_why`), page: ['help', 'operations'] })),
    { kind: 'calculator', id: 'calculator', title: t('help.calculator'), text: '', page: ['help', 'calculator'] },
  ];
  const found: Local[] = all.filter(({ title, text }) => has(title, text)).map((one) => ({ ...one, isNear: has(one.title) }));
  const sum = sought.trim();
  const value = bare.test(sum) ? null : calculate(sum);
  if (value !== null) {
    const title = `${sum} = ${Number(value.toPrecision(12))}`;
    found.unshift({ kind: 'calculator', id: 'sum', title, text: '', page: ['help', 'calculator', sum], isNear: true });
  }
  return found;
}
