// The keys, switches and lamps of the operator panel, by the names that the standard ladder gives them
// (`docs/plc.md`; GSK990MC part 2, 1.2.4).
import type { Mode } from '$lib/api/types';
import type { IconName } from '$lib/parts/icons';

export type PanelKey = { signal: string; lamp: string; text: string; icon?: IconName };

const key = (name: string, icon?: IconName): PanelKey => ({
  signal: `KEY_${name}`,
  lamp: `LAMP_${name}`,
  text: `panel.${name.toLowerCase()}`,
  ...(icon ? { icon } : {}),
});

/** What the standard ladder calls the first four axes of a machine, whatever their letters are. */
export const axisSignals = ['X', 'Y', 'Z', 'A'] as const;

/** The keys of axes by their place, with the letters that the machine gives them and the lamps of their reference points. Those
    behind the fourth are called by their number, in ladders that have them. */
export const axisKeysOf = (letters: readonly string[]) =>
  letters.map((letter, index) => {
    const name = axisSignals[index] ?? String(index + 1);
    return { letter, place: index + 1, plus: `KEY_${name}+`, minus: `KEY_${name}-`, wheel: `KEY_W${name}`, zero: `LAMP_ZERO_${name}`, isStandard: index < axisSignals.length };
  });
export type AxisKey = ReturnType<typeof axisKeysOf>[number];

export const modes: { mode: Mode; signal: string; lamp: string }[] = (
  [
    ['auto', 'AUTO'],
    ['edit', 'EDIT'],
    ['mdi', 'MDI'],
    ['dnc', 'DNC'],
    ['home', 'HOME'],
    ['jog', 'JOG'],
    ['step', 'STEP'],
    ['handle', 'MPG'],
  ] as const
).map(([mode, name]) => ({ mode, signal: `KEY_${name}`, lamp: `LAMP_${name}` }));

/** Switches of automatic operation: a press turns them on or off. */
export const switches = ['SINGLE', 'SKIP', 'OPTSTOP', 'DRY', 'MLOCK', 'AUXLOCK', 'RESTART', 'HDRV'].map((name) => key(name));

export const spindle = [
  key('SP_CCW', 'ccw'),
  key('SP_STOP', 'stop'),
  key('SP_CW', 'cw'),
  key('SP_JOG'),
  key('SP_ORIENT', 'target'),
];

export const auxiliaries = [
  key('COOLANT', 'drop'),
  key('CHIP', 'more'),
  key('LUBE'),
  key('LIGHT', 'lamp'),
  key('OT'),
];

/** Steps of the rapid override: F0 is the speed of a parameter (P93). */
export const rapids = [
  { signal: 'KEY_R_F0', lamp: 'LAMP_R_F0', label: 'F0' },
  { signal: 'KEY_R_25', lamp: 'LAMP_R_25', label: '25' },
  { signal: 'KEY_R_50', lamp: 'LAMP_R_50', label: '50' },
  { signal: 'KEY_R_100', lamp: 'LAMP_R_100', label: '100' },
];

/** Steps of the increment, mm. */
export const increments = ['0.001', '0.01', '0.1', '1'].map((label, step) => ({ signal: `KEY_S${step}`, label }));

/** Axes that a machine may have. */
const MOST_AXES = 8;
/** What the panel has a place for. */
const placed = [
  ...[...modes, ...switches, ...spindle, ...auxiliaries, ...rapids].flatMap(({ signal, lamp }) => [signal, lamp]),
  ...increments.map(({ signal }) => signal),
  ...axisKeysOf(Array.from({ length: MOST_AXES }, () => '')).flatMap(({ plus, minus, wheel, zero }) => [plus, minus, wheel, zero]),
  ...['START', 'HOLD', 'RAPID'].flatMap((name) => [`KEY_${name}`, `LAMP_${name}`]),
];

/** A key or a lamp that a ladder has of its own; a lamp without a key has no signal. */
export type OwnKey = { signal: string; lamp: string; text: string };

/** The keys and lamps of a ladder for which the panel has no place, from the bits of X and Y that have a name. */
export function ownKeysOf(inputs: readonly Named[], outputs: readonly Named[]): OwnKey[] {
  const own = (signals: readonly Named[], prefix: string) => signals.filter(({ name, address }) => name.startsWith(prefix) && address.includes('.') && !placed.includes(name));
  const lamps = own(outputs, 'LAMP_');
  const keys = own(inputs, 'KEY_').map(({ name, meaning }) => {
    const lamp = name.replace(/^KEY_/, 'LAMP_');
    return { signal: name, lamp: outputs.some((one) => one.name === lamp) ? lamp : '', text: meaning || name };
  });
  const single = lamps.filter(({ name }) => !keys.some(({ lamp }) => lamp === name));
  return [...keys, ...single.map(({ name, meaning }) => ({ signal: '', lamp: name, text: meaning || name }))];
}
type Named = { name: string; address: string; meaning: string };
