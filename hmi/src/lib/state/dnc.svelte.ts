// The program of DNC (GSK990MC part 2, 11.3): a file of this computer. The server has it once it came, and gives it to
// the control while it runs, whatever becomes of this page.
import type { DncFile } from '$lib/api/answers';
import { http } from '$lib/api/http';
import { machine } from './machine.svelte';

let file = $state.raw<DncFile | null>(null);
/** What comes to the server from this page. */
let coming = $state.raw<{ name: string; bytes: number; sent: number } | null>(null);
let abort: AbortController | null = null;

export const dnc = {
  /** What the server has. */
  get file() {
    return file;
  },
  get coming() {
    return coming;
  },
  /** Asks how far it is. */
  async look(): Promise<void> {
    try {
      file = await http.dnc();
    } catch {
      // It is asked again; that there is no connection is told elsewhere.
    }
  },
  /** Brings a file. */
  async send(chosen: File): Promise<void> {
    abort?.abort();
    const mine = (abort = new AbortController());
    coming = { name: chosen.name, bytes: chosen.size, sent: 0 };
    try {
      const come = await http.bringDnc(chosen, mine.signal, (sent) => {
        if (abort === mine) coming = { name: chosen.name, bytes: chosen.size, sent };
      });
      if (abort === mine) file = come;
    } catch (refused) {
      if (!mine.signal.aborted) machine.refused(refused);
    }
    if (abort === mine) [coming, abort] = [null, null];
  },
  /** Brings or gives the control no more of it. */
  async stop(): Promise<void> {
    if (abort) {
      abort.abort();
      [coming, abort] = [null, null];
      return;
    }
    try {
      file = await http.stopDnc();
    } catch (refused) {
      machine.refused(refused);
    }
  },
};
