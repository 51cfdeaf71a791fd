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

/** The keys of the first four axes by their place, with the letters that the machine gives them. */
export const axisKeysOf = (letters: readonly string[]) =>
  axisSignals.slice(0, letters.length).map((name, index) => ({
    letter: letters[index]!,
    plus: `KEY_${name}+`,
    minus: `KEY_${name}-`,
    wheel: `KEY_W${name}`,
  }));
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
