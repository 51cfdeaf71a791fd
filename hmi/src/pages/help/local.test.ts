import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { findLocal } from './local';

function texts(language: string): (key: string) => string {
  const folder = join(import.meta.dirname, '../../locales', language);
  const read = (page: string) => JSON.parse(readFileSync(join(folder, `${page}.json`), 'utf8')) as Record<string, string>;
  const [help, operations] = [read('help'), read('operations')];
  return (key) => (key.startsWith('help.') ? help : operations)[key.split('.')[1]!] ?? key;
}
const find = (sought: string, language = 'en') => findLocal(sought, texts(language));

describe('the box of the help', () => {
  it('finds how something is done by what it is called and by what is said of it', () => {
    expect(find('work zeros').find((one) => one.id === 'zero')).toMatchObject({ kind: 'operation', page: ['settings', 'zeros'], isNear: true });
    expect(find('underlines').map((one) => [one.id, one.isNear])).toEqual([['check', false]]);
    expect(find('LADDER').some((one) => one.id === 'ladder')).toBe(true);
    expect(find('nothing of this kind')).toEqual([]);
    expect(find('  ')).toEqual([]);
  });
  it('says what this machine has no page for', () => {
    expect(find(texts('en')('operations.not_bus')).some((one) => one.kind === 'not_here')).toBe(true);
  });
  it.each(['en', 'zh', 'ru', 'es', 'tr'])('finds the calculator by its name, and each operation by its title, in %s', (language) => {
    const t = texts(language);
    expect(find(t('help.calculator').slice(0, 3), language).some((one) => one.id === 'calculator')).toBe(true);
    for (const id of ['home', 'replace', 'limit']) expect(find(t(`operations.${id}`), language)[0]?.id).toBe(id);
  });
  it('works a sum out, but takes no number and no code for one', () => {
    expect(find('2+3*(4-1)^2')[0]).toMatchObject({ title: '2+3*(4-1)^2 = 29', page: ['help', 'calculator', '2+3*(4-1)^2'] });
    expect(find('sin 30')[0]?.title).toBe('sin 30 = 0.5');
    for (const one of ['12', '-1.5', 'G81', 'P98', '#5021', 'FC-1417', '24#6', 'X-5', 'X20.0', '']) expect(find(one).filter(({ id }) => id === 'sum'), one).toEqual([]);
  });
});
