// The restart that is prepared (`docs/restart.md`): asked for by a page, searched by the control, shown before cycle start.
import type { Reply } from '$lib/api/types';
import { machine } from './machine.svelte';

export type Restarts = Extract<Reply, { reply: 'restarts' }>;

/** The line that somebody wants to begin at; null for the block that was interrupted. */
let wanted = $state.raw<number | null>(null);
let asked = $state(false);

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
