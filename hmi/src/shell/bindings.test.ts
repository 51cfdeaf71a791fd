import { describe, expect, it } from 'vitest';
import { axisKey, axisKeys, chords, ended, heldKey, type Chord } from './bindings';

/** What Chromium and Firefox do themselves before a page hears of it: tabs, windows, and what closes them. */
const reserved: Chord[] = [
  ...['PageUp', 'PageDown', 'Tab', 'n', 't', 'w', 'q', 'F4'].flatMap((key) => [
    { key, ctrl: true },
    { key, ctrl: true, shift: true },
  ]),
  { key: 'p', ctrl: true, shift: true },
  { key: 'F4', alt: true },
  { key: 'F11' },
];
const said = ({ key, ctrl, alt, shift }: Chord) => [ctrl && 'Ctrl', alt && 'Alt', shift && 'Shift', key].filter(Boolean).join('+');
const event = (key: string, held: string, type = 'keydown') => ({
  type, key, ctrlKey: held.includes('C'), altKey: held.includes('A'), shiftKey: held.includes('S'),
});

describe('keys of the keyboard', () => {
  it('are none that a browser keeps to itself, and each is one', () => {
    const mine = chords.map(said);
    expect(mine.filter((one) => reserved.map(said).includes(one))).toEqual([]);
    expect(new Set(mine).size).toBe(mine.length);
  });
  it('start a cycle without another key alone, and hold with any', () => {
    const held = (key: string, which: string) => heldKey({ ...event(key, which), metaKey: which.includes('M') });
    expect(held('F10', '')).toBe('KEY_START');
    for (const which of ['S', 'C', 'A', 'M', 'CS']) expect(held('F10', which), which).toBeUndefined();
    for (const which of ['', 'S', 'C', 'A', 'M']) expect(held('F9', which), which).toBe('KEY_HOLD');
    expect(held('F8', '')).toBeUndefined();
  });
  it('move each axis both ways, with and without Shift told apart', () => {
    expect(axisKeys.map(({ signal }) => signal).sort()).toEqual(['X', 'Y', 'Z', 'A'].flatMap((axis) => [`KEY_${axis}+`, `KEY_${axis}-`]).sort());
    expect(axisKey(event('ArrowUp', 'C'), 4)?.signal).toBe('KEY_Y+');
    expect(axisKey(event('ArrowUp', 'CS'), 4)?.signal).toBe('KEY_Z+');
    expect(axisKey(event('ArrowLeft', 'CS'), 4)?.signal).toBe('KEY_A-');
    expect(axisKey(event('ArrowLeft', 'CS'), 3)).toBeUndefined();
    expect(axisKey(event('ArrowUp', ''), 4)).toBeUndefined();
    expect(axisKey(event('ArrowUp', 'S'), 4)).toBeUndefined();
    expect(axisKey(event('ArrowUp', 'CA'), 4)).toBeUndefined();
  });
  it('end with the first modifier that is let go', () => {
    const z = { key: 'ArrowUp', ctrl: true, shift: true };
    const x = { key: 'ArrowRight', ctrl: true, shift: false };
    expect(ended(z, event('ArrowUp', 'CS'))).toBe(false);
    expect(ended(z, event('Shift', 'C', 'keyup'))).toBe(true);
    expect(ended(z, event('Control', 'S', 'keyup'))).toBe(true);
    // The other Shift is still down.
    expect(ended(z, event('Shift', 'CS', 'keyup'))).toBe(true);
    // The end of it was not seen.
    expect(ended(z, event('ArrowUp', 'S'))).toBe(true);
    expect(ended(x, event('Shift', 'CS'))).toBe(false);
    expect(ended(x, event('Control', '', 'keyup'))).toBe(true);
  });
});
