// The restart that is prepared (`docs/restart.md`): asked for by a page, searched by the control, shown before cycle start.
import type { Reply } from '$lib/api/types';
import { t } from '$lib/i18n/index.svelte';
import { again } from './again';
import { machine } from './machine.svelte';

export type Restarts = Extract<Reply, { reply: 'restarts' }>;

/** The line that somebody wants to begin at; null for the block that was interrupted. */
let wanted = $state.raw<number | null>(null);
let asked = $state(false);

/** What a difference is of: `G03` a modal group, `zero.X` with its axis. */
export function called(of: string): string {
  const group = /^G(\d+)$/.exec(of);
  if (group) return t('restart.of_group', { number: group[1]! });
  const [what = '', axis = ''] = of.split('.');
  return t(`restart.of_${what}`, { axis });
}

export const restart = {
  /** Whether somebody is about to prepare one. */
  get asked() {
    return asked;
  },
  get line() {
    return wanted;
  },
  /** Asks how: from a line on, or where the run was interrupted. */
  ask(line: number | null): void {
    wanted = line;
    asked = true;
  },
  close(): void {
    asked = false;
  },
  /** Tells what is prepared until the answer is called. What differs changes as the operator makes the machine as the program
      has it: it is asked for again and again. */
  follow(told: (now: Restarts) => void): () => void {
    return again(300, async (wanted) => {
      const reply = await machine.ask({ do: 'restarts' }).catch(() => null);
      if (wanted() && reply?.reply === 'restarts') told(reply);
    });
  },
  /** Has the control search the block. */
  search(how: { pass: number; sends: boolean; axis_by_axis: boolean }): Promise<boolean> {
    return machine.tell({ do: 'restart', line: wanted, ...how });
  },
  /** Forgets what is prepared. */
  async forget(): Promise<void> {
    asked = false;
    await machine.tell({ do: 'cancel_restart' });
  },
};
