// What the keyboard does on every page, by key and modifiers. Keys that a browser keeps to itself are none of these: the
// page never hears of Ctrl with PgUp and PgDn, which change its tabs.
import { axisSignals } from './keys';

/** A key, as events name it, with the modifiers that are held meanwhile. */
export type Chord = { key: string; ctrl?: boolean; alt?: boolean; shift?: boolean };
type Modifiers = Pick<KeyboardEvent, 'type' | 'key' | 'ctrlKey' | 'altKey' | 'shiftKey'>;

/** Keys that are held like those of the machine panel. */
export const heldKeys = [
  { key: 'F9', signal: 'KEY_HOLD' },
  { key: 'F10', signal: 'KEY_START' },
] as const;

/** What a key that is held does. Shift+F10 and others open menus, so that a start is F10 alone; a hold stops the machine
    whatever else is down. */
export function heldKey(event: Modifiers & Pick<KeyboardEvent, 'metaKey'>): string | undefined {
  const isAlone = !(event.ctrlKey || event.altKey || event.shiftKey || event.metaKey);
  return heldKeys.find(({ key, signal }) => key === event.key && (isAlone || signal === 'KEY_HOLD'))?.signal;
}

/** Axis keys, by the place of their axis; they move in the mode JOG alone, and only with Ctrl, so that a cursor key never
    moves a machine. With Shift they move the axes behind the first two. */
export const axisKeys: readonly { chord: Chord; axis: number; signal: string }[] = (
  [
    ['ArrowRight', false, 0, '+'],
    ['ArrowLeft', false, 0, '-'],
    ['ArrowUp', false, 1, '+'],
    ['ArrowDown', false, 1, '-'],
    ['ArrowUp', true, 2, '+'],
    ['ArrowDown', true, 2, '-'],
    ['ArrowRight', true, 3, '+'],
    ['ArrowLeft', true, 3, '-'],
  ] as const
).map(([key, shift, axis, sign]) => ({ chord: { key, ctrl: true, shift }, axis, signal: `KEY_${axisSignals[axis]}${sign}` }));

/** Switches of the panel that a key turns by a step, with Alt and Shift: with the position that they have unless told, and
    the last one. */
export const overrideKeys: Record<string, [name: string, by: number, standard: number, last: number]> = {
  ArrowUp: ['SWITCH_FEED', 1, 10, 20],
  ArrowDown: ['SWITCH_FEED', -1, 10, 20],
  ArrowRight: ['SWITCH_SPINDLE', 1, 5, 7],
  ArrowLeft: ['SWITCH_SPINDLE', -1, 5, 7],
};

/** Steps of the rapid override, with Alt and Shift. */
export const rapidKeys: Record<string, number> = { PageUp: 1, PageDown: -1 };

/** All of them, and those of the editor. */
export const chords: readonly Chord[] = [
  { key: 'F1' },
  { key: 'F8' },
  { key: '?', shift: true },
  ...heldKeys.map(({ key }) => ({ key })),
  ...axisKeys.map(({ chord }) => chord),
  ...[...Object.keys(overrideKeys), ...Object.keys(rapidKeys)].map((key) => ({ key, alt: true, shift: true })),
  ...['1', '2', '3', '4', '5', '6', '7', '8'].map((key) => ({ key, alt: true, shift: true })),
  ...['1', '2', '3', '4', '5', '6', '7', '8', '9', '0'].map((key) => ({ key, alt: true })),
  { key: 's', ctrl: true },
  { key: 'f', ctrl: true },
  { key: ' ', ctrl: true },
];

/** The axis key that is pressed, of a machine with so many axes. */
export function axisKey(event: Modifiers, axes: number): (typeof axisKeys)[number] | undefined {
  if (!event.ctrlKey || event.altKey) return undefined;
  return axisKeys.find(({ chord, axis }) => axis < axes && chord.key === event.key && chord.shift === event.shiftKey);
}

/** Whether a key that is held is one no more, since a modifier of it was let go. */
export function ended(chord: Chord, event: Modifiers): boolean {
  const off = (needed: boolean | undefined, isDown: boolean, key: string) => needed === true && (!isDown || (event.type === 'keyup' && event.key === key));
  return off(chord.ctrl, event.ctrlKey, 'Control') || off(chord.shift, event.shiftKey, 'Shift') || off(chord.alt, event.altKey, 'Alt');
}
