// The program of DNC (GSK990MC part 2, 11.3): a file of this computer, sent while it runs, whichever page is shown. The
// control keeps a megabyte of it and refuses what has no room yet.
import { Refused } from '$lib/api/socket';
import { machine } from './machine.svelte';

/** Bytes of a part. */
const PART = 128 * 1024;
/** ms until a part that had no room is sent again. */
const AGAIN = 200;
const NO_ROOM_YET = 'FC-1418';

let file = $state.raw<File | null>(null);
let sent = $state(0);
let sending = $state(false);
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

/** Sends a part as soon as there is room for it; false where nobody wants it sent any more. */
async function part(text: string, first: boolean, last: boolean, mine: number): Promise<boolean> {
  while (mine === turn) {
    try {
      await machine.ask({ do: 'dnc', text, first, last });
      return true;
    } catch (refused) {
      if (!(refused instanceof Refused && refused.alarm?.id === NO_ROOM_YET)) throw refused;
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
  async send(chosen: File): Promise<void> {
    const mine = ++turn;
    [file, sent, sending] = [chosen, 0, true];
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
      machine.refused(refused);
    }
    if (mine === turn) sending = false;
  },
  /** Sends no more of it. */
  stop(): void {
    turn += 1;
    sending = false;
  },
};
