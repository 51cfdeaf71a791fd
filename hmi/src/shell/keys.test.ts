import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { auxiliaries, axisKeysOf, increments, modes, ownKeysOf, rapids, spindle, switches } from './keys';

const read = (...path: string[]) => readFileSync(join(import.meta.dirname, ...path), 'utf8');
const ladder = read('../../../machines/standard.lad');
const named = (prefix: string) => new Set([...ladder.matchAll(new RegExp(`^(${prefix}_\\S+)\\s*= [XY]`, 'gm'))].map((found) => found[1]!));

/** Signals that the panel has: those of its tables, and those that its parts name themselves. */
const tables = [...modes, ...switches, ...spindle, ...auxiliaries, ...rapids, ...increments].map(({ signal }) => signal as string);
const axes = axisKeysOf(['X', 'Y', 'Z', 'C']).flatMap(({ plus, minus, wheel }) => [plus, minus, wheel]);
const parts = ['.', 'panel']
  .flatMap((folder) => readdirSync(join(import.meta.dirname, folder)).filter((name) => name.endsWith('.svelte')).map((name) => read(folder, name)))
  .flatMap((source) => [...source.matchAll(/signal="(KEY_\w+)"/g)].map((found) => found[1]!));

it('each key of the standard ladder is on the panel, once, and no other', () => {
  const mine = [...tables, ...axes, ...parts];
  expect(mine.toSorted()).toEqual([...named('KEY')].toSorted());
});

it('each lamp of a key is one of the standard ladder', () => {
  const lamps = named('LAMP');
  expect([...modes, ...switches, ...spindle, ...auxiliaries, ...rapids].map(({ lamp }) => lamp).filter((lamp) => !lamps.has(lamp))).toEqual([]);
});

it('each switch of the standard ladder is on the panel', () => {
  const overrides = read('panel', 'Overrides.svelte');
  expect([...named('SWITCH')].filter((name) => !overrides.includes(`'${name}'`))).toEqual([]);
});

it('what a ladder has of its own is what the panel has no place for', () => {
  const bits = (prefix: string, ...more: string[]) =>
    [...named(prefix), ...more].map((name, index) => ({ name, address: `${prefix === 'KEY' ? 'X' : 'Y'}${index}.0`, meaning: name === 'KEY_DOOR' ? 'door' : '' }));
  expect(ownKeysOf(bits('KEY', 'KEY_5+', 'KEY_W5'), bits('LAMP', 'LAMP_ZERO_5', 'TOWER_RED'))).toEqual([]);
  expect(ownKeysOf(bits('KEY', 'KEY_DOOR', 'KEY_AIR'), bits('LAMP', 'LAMP_DOOR', 'LAMP_WARM'))).toEqual([
    { signal: 'KEY_DOOR', lamp: 'LAMP_DOOR', text: 'door' },
    { signal: 'KEY_AIR', lamp: '', text: 'KEY_AIR' },
    { signal: '', lamp: 'LAMP_WARM', text: 'LAMP_WARM' },
  ]);
});
