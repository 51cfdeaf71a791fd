// The program of DNC (GSK990MC part 2, 11.3): a file of this computer, sent while it runs, whichever page is shown. The
// control keeps a megabyte of it and refuses what has no room yet.
import { Refused } from '$lib/api/socket';
import { t } from '$lib/i18n/index.svelte';
import { machine } from './machine.svelte';
import { notify } from './notices.svelte';

/** Bytes of a part. */
const PART = 128 * 1024;
/** ms until a part that had no room is sent again. */
const AGAIN = 200;
const NO_ROOM_YET = 'FC-1418';

let file = $state.raw<File | null>(null);
let sent = $state(0);
let sending = $state(false);
/** For the connection to come back. */
let waiting = $state(false);
let turn = 0;

/** UTF-8, else what Chinese shops write. */
function decoderFor(beginning: ArrayBuffer): TextDecoder {
  try {
    new TextDecoder('utf-8', { fatal: true }).decode(beginning, { stream: true });
    return new TextDecoder('utf-8');
  } catch {
    return new TextDecoder('gb18030');
  }
}

/** Whether a part may be said again: there was no room for it yet, or it was never said, since there is no connection
    or command has not come back yet after one was lost. */
function isToBeSaidAgain(refused: unknown): boolean {
  if (!(refused instanceof Refused) || refused.open) return false;
  return refused.alarm?.id === NO_ROOM_YET || refused.code === 'no_connection' || (refused.code === 'not_in_command' && machine.regains);
}

/** Sends a part as soon as there is room for it and a connection; false where nobody wants it sent any more. */
async function part(text: string, first: boolean, last: boolean, mine: number): Promise<boolean> {
  while (mine === turn) {
    try {
      await machine.ask({ do: 'dnc', text, first, last });
      waiting = false;
      return true;
    } catch (refused) {
      if (!isToBeSaidAgain(refused)) throw refused;
      waiting = machine.link !== 'open';
      await new Promise((resolve) => setTimeout(resolve, AGAIN));
    }
  }
  return false;
}

export const dnc = {
  get file() {
    return file;
  },
  /** Bytes that the control has. */
  get sent() {
    return sent;
  },
  get sending() {
    return sending;
  },
  /** Whether it waits for the connection to come back. */
  get waiting() {
    return sending && waiting;
  },
  async send(chosen: File): Promise<void> {
    const mine = ++turn;
    [file, sent, sending, waiting] = [chosen, 0, true, false];
    try {
      let decoder: TextDecoder | null = null;
      for (let at = 0; at === 0 || at < chosen.size; at += PART) {
        const bytes = await chosen.slice(at, at + PART).arrayBuffer();
        const last = at + PART >= chosen.size;
        decoder ??= decoderFor(bytes);
        if (!(await part(decoder.decode(bytes, { stream: !last }), at === 0, last, mine))) return;
        sent = Math.min(chosen.size, at + PART);
      }
    } catch (refused) {
      // A part that was on its way may be there or not: said twice it would be run twice.
      if (refused instanceof Refused && refused.open) notify({ kind: 'warning', title: t('program.dnc_broken'), text: t('program.dnc_broken_text') });
      else machine.refused(refused);
    }
    if (mine === turn) sending = false;
  },
  /** Sends no more of it. */
  stop(): void {
    turn += 1;
    sending = false;
  },
};
