// What the tool draws where no path of a selected program tells what is done: in DNC, in MDI and by hand (GSK990MC part 2, 3.5).
// It goes on whatever page is shown.
import type { Status } from '$lib/api/types';
import { Trail } from '$lib/graphics/trail';
import { machine } from './machine.svelte';
import { prefs } from './prefs.svelte';

const drawn = new Trail();
let any = $state.raw(false);
/** Whether no program is under way: the next one begins. */
let idle = false;

function take({ position, program_mode, activity }: Status): void {
  const runs = activity === 'running';
  if (runs && idle && prefs.drawing.erases) clear();
  idle = activity === 'idle' || (idle && !runs);
  // AUTO shades the path of its program.
  if (!prefs.drawing.trail || (runs && program_mode === 'auto')) {
    drawn.lift();
    return;
  }
  const { X = 0, Y = 0, Z = 0 } = position.machine;
  if (drawn.add(X, Y, Z)) any = true;
}

function clear(): void {
  drawn.clear();
  any = false;
}

export const trail = {
  /** Follows the machine; for an effect. */
  follow: () => machine.watch(take),
  clear,
  /** Whether there is something to see. */
  get any() {
    return any;
  },
  get drawn() {
    return drawn;
  },
};
