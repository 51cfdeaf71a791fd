// The program of DNC (GSK990MC part 2, 11.3): a file of this computer, sent while it runs, whichever page is shown. The
// control keeps a megabyte of it and refuses what has no room yet. It counts what it took, so that a page that lost its
// connection, or is loaded anew and given the file again, goes on behind that.
import { Refused } from '$lib/api/socket';
import type { DncStatus } from '$lib/api/types';
import { t } from '$lib/i18n/index.svelte';
import { machine } from './machine.svelte';
import { notify } from './notices.svelte';

/** Bytes of a part. */
const PART = 128 * 1024;
/** ms until a part that had no room is sent again. */
const AGAIN = 200;
const NO_ROOM_YET = 'FC-1418';
const utf8 = new TextEncoder();

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

/** What the control has of the program, once there is a connection; null where it has none. */
async function taken(mine: number): Promise<DncStatus | null> {
  while (mine === turn) {
    try {
      const reply = await machine.ask({ do: 'status' });
      return reply.reply === 'status' ? reply.dnc : null;
    } catch (refused) {
      if (!(refused instanceof Refused) || !(refused.open || refused.code === 'no_connection')) throw refused;
      await new Promise((resolve) => setTimeout(resolve, AGAIN));
    }
  }
  return null;
}

/** Sends a part as soon as there is room for it and a connection; false where nobody wants it sent any more. `before`
    are the bytes of the program that went before it. */
async function part(text: string, before: number, last: boolean, mine: number): Promise<boolean> {
  while (mine === turn) {
    try {
      await machine.ask({ do: 'dnc', text, first: before === 0, last });
      waiting = false;
      return true;
    } catch (refused) {
      waiting = machine.link !== 'open';
      if (refused instanceof Refused && refused.open) {
        // It was on its way: the control has counted it, or it has not.
        const now = await taken(mine);
        waiting = false;
        if (now?.taken === before + utf8.encode(text).length && text.endsWith(now.tail.slice(-text.length))) return true;
        // What begins a program takes the place of any.
        if (before > 0 && now?.taken !== before) throw refused;
      } else if (!isToBeSaidAgain(refused)) throw refused;
      await new Promise((resolve) => setTimeout(resolve, AGAIN));
    }
  }
  return false;
}

/** The text of a file, in parts, the last one told. */
async function* parts(chosen: File): AsyncGenerator<{ text: string; end: number; last: boolean }> {
  let decoder: TextDecoder | null = null;
  for (let at = 0; at === 0 || at < chosen.size; at += PART) {
    const bytes = await chosen.slice(at, at + PART).arrayBuffer();
    const last = at + PART >= chosen.size;
    decoder ??= decoderFor(bytes);
    yield { text: decoder.decode(bytes, { stream: !last }), end: Math.min(chosen.size, at + PART), last };
  }
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
  /** Sends a file; `onward` what the control has not got yet of it. */
  async send(chosen: File, onward = false): Promise<void> {
    const mine = ++turn;
    [file, sent, sending, waiting] = [chosen, 0, true, false];
    try {
      const there = onward ? await taken(mine) : null;
      if (onward && !there?.awaited) throw new Refused('dnc_over', null);
      let before = 0;
      for await (const { text, end, last } of parts(chosen)) {
        const bytes = utf8.encode(text);
        const missing = (there?.taken ?? 0) - before;
        if (missing >= bytes.length && bytes.length > 0) {
          if (last || (missing === bytes.length && !text.endsWith(there!.tail.slice(-text.length)))) throw new Refused('dnc_foreign', null);
        } else {
          const had = missing > 0 ? new TextDecoder('utf-8', { ignoreBOM: true }).decode(bytes.subarray(0, missing)) : '';
          if (had && !had.endsWith(there!.tail.slice(-had.length))) throw new Refused('dnc_foreign', null);
          if (!(await part(text.slice(had.length), before + Math.max(0, missing), last, mine))) return;
        }
        before += bytes.length;
        sent = end;
      }
    } catch (refused) {
      // What was on its way came neither whole nor not at all: another page sends too, or the run was given up.
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
