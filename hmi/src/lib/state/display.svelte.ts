// What parameters of the control say of its pages (GSK990MC part 2, 1.2.3, 3.1.1 and 3.7). Controls that have no such parameters
// leave the panel as it is.
import { route } from '$lib/routing.svelte';
import { followParameters } from './again';
import { machine } from './machine.svelte';

/** Whether the key of a page, pressed on its page, steps to the next part. Drawing has no parts here (25#5), and what 26#3
    chooses between is one part of the page of programs. */
const STEPS: Record<string, string> = {
  position: 'NO25.0',
  program: 'NO25.1',
  offsets: 'NO25.2',
  settings: 'NO25.4',
  diagnosis: 'NO25.6',
  alarms: 'NO25.7',
  plc: 'NO26.6',
  help: 'NO26.7',
};
const ALARM_OPENS = 'NO24.6';
const SHOWS_MODAL = 'NO23.6';
const EDIT_OPENS = 'NO26.0';
const PROGRAM_IN_EDIT = 'NO26.1';
const PROGRAM_IN_MDI = 'NO26.2';
const names = [...Object.values(STEPS), ALARM_OPENS, SHOWS_MODAL, EDIT_OPENS, PROGRAM_IN_EDIT, PROGRAM_IN_MDI];

let bits = $state.raw<Record<string, number>>({});
/** The parts of the page that is shown. */
let parts = $state.raw<{ page: string; ids: string[]; active: string }>({ page: '', ids: [], active: '' });
const is = (name: string) => bits[name] === 1;

export const display = {
  /** Follows the parameters; for an effect. */
  follow: () => followParameters(names, (values) => (bits = values)),
  /** Whether an alarm shows its page. */
  get alarmOpens() {
    return is(ALARM_OPENS);
  },
  /** Whether the key of the mode EDIT shows the program. */
  get editOpens() {
    return is(EDIT_OPENS);
  },
  /** Whether the codes in force stand beside the running program. */
  get showsModal() {
    return bits[SHOWS_MODAL] !== 0;
  },
  /** A page says which parts it has. */
  has(page: string, ids: string[], active: string): void {
    parts = { page, ids, active };
  },
  /** Where the key of a page leads: to the page, or from it to its next part. */
  to(page: string): string[] {
    if (page !== route.page || page !== parts.page) {
      if (page === 'program' && machine.mode === 'edit' && is(PROGRAM_IN_EDIT)) return [page, 'edit'];
      if (page === 'program' && machine.mode === 'mdi' && is(PROGRAM_IN_MDI)) return [page, 'mdi'];
      return [page];
    }
    const { ids, active } = parts;
    if (ids.length === 0 || !is(STEPS[page] ?? '')) return [page, active, route.item].filter(Boolean);
    return [page, ids[(ids.indexOf(active) + 1) % ids.length]!];
  },
};
