import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { layout } from './layout';
import { headOf, readLadder, signalsOf } from './ladder';

const text = `
KEY_A = X20.0 ; key
LAMP  = Y20.0 ; lamp
; Level 2
RD KEY_A
OR R1.0
AND.NOT R1.1
WRT LAMP
RD R1.0
RD.STK R1.1
AND R1.2
OR.STK
SET R2.0
RD R3.0
TMR 5
WRT R3.1
RD R9091.1
AND 1
  R10
  15
  R11
END2
END
`;

it('reads rungs with their instructions numbered', () => {
  const ladder = readLadder(text);
  expect(ladder.instructions).toBe(16);
  expect(ladder.symbols.get('KEY_A')).toEqual({ address: 'X20.0', meaning: 'key' });
  const [first, second, third, fourth] = ladder.rungs;
  expect(first?.comment).toBe('Level 2');
  expect(signalsOf(first!)).toEqual(['KEY_A', 'R1.0', 'R1.1', 'LAMP']);
  expect(first?.outputs[0]).toMatchObject({ kind: 'coil', name: 'LAMP', index: 3 });
  expect(second?.conditions).toHaveLength(1);
  expect(second?.outputs[0]).toMatchObject({ text: 'S', name: 'R2.0' });
  expect(third?.outputs.map((output) => output.name)).toEqual(['TMR', 'R3.1']);
  expect(fourth?.outputs[0]?.text).toBe('AND 1 R10 15 R11');
});

it('power flows through what conducts', () => {
  const [rung] = readLadder(text).rungs;
  const on = new Set(['R1.0']);
  const drawn = layout(rung!, (contact) => on.has(contact.name) !== contact.not, () => true);
  expect(drawn.contacts.map((one) => [one.contact.name, one.on])).toEqual([['KEY_A', false], ['R1.0', true], ['R1.1', true]]);
  const dead = layout(rung!, () => false, () => false);
  expect(dead.contacts.some((one) => one.on)).toBe(false);
});

it('reads the standard ladder', () => {
  const standard = readFileSync(join(import.meta.dirname, '../../../../machines/standard.lad'), 'utf8');
  const ladder = readLadder(standard);
  expect(ladder.rungs.length).toBeGreaterThan(150);
  expect(ladder.symbols.get('KEY_START')?.address).toBe('X22.0');
  for (const rung of ladder.rungs) {
    const drawn = layout(rung, () => true, () => true);
    expect(drawn.height).toBeGreaterThan(0);
    for (const contact of drawn.contacts) expect(contact.contact.name).not.toBe('');
  }
});

it('tells what signals are in the words that it is given', () => {
  const list = 'KEY_A = X20.0 ; key\nLAMP_A = Y1.0 ; lamp\nRD KEY_A\nWRT LAMP_A\nEND1\nEND2\nEND\n';
  const { rungs, symbols } = readLadder(list, new Map([['KEY_A', 'Taste'], ['LAMP_A', '']]));
  expect([symbols.get('KEY_A')?.meaning, symbols.get('LAMP_A')?.meaning]).toEqual(['Taste', 'lamp']);
  expect(rungs[0]?.outputs[0]?.meaning).toBe('lamp');
});

it('a ladder is called by the remark that it begins with', () => {
  expect(headOf('\n;\n; The mill: its panel\n; more\nRD X0.0')).toBe('The mill: its panel');
  expect(headOf('RD X0.0 ; key\n; later')).toBe('');
});
