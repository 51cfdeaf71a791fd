// The programs of the memory.
import { http } from '$lib/api/http';
import type { ProgramInfo } from '$lib/api/types';
import { Refused } from '$lib/api/socket';
import { isSameProgram } from '$lib/numbers';
import { untrack } from 'svelte';
import { machine } from './machine.svelte';

/** Bytes from which on a program comes as a file: a file is read faster than a line of JSON. */
const LONG = 500_000;

let list = $state.raw<ProgramInfo[] | null>(null);
/** How many there can be, and bytes that there is room for; null where the control does not tell. */
let most = $state.raw<number | null>(null);
let room = $state.raw<number | null>(null);

export const programs = {
  get list() {
    return list;
  },
  get most() {
    return most;
  },
  get room() {
    return room;
  },
  async refresh(): Promise<void> {
    const reply = await machine.fetch('programs', { do: 'programs' });
    if (reply) ({ programs: list, most, room } = reply);
  },
  /** The program that a name means to the control, if there is one. */
  named(name: string): ProgramInfo | undefined {
    return list?.find((one) => isSameProgram(one.name, name));
  },
  /** When a program was changed, ms; null where there is none, or nobody knows. */
  async changedAt(program: string): Promise<number | null> {
    await this.refresh();
    return untrack(() => list)?.find((one) => one.name === program)?.changed || null;
  },
  /** The text of a program. */
  async read(program: string): Promise<string> {
    // One that is too long for a line is not asked for over the socket first. An effect that reads a program is not run
    // again for a new list.
    if (untrack(() => list) === null) await this.refresh();
    const bytes = untrack(() => list)?.find((one) => one.name === program)?.bytes ?? 0;
    if (bytes < LONG) {
      try {
        const reply = await machine.ask({ do: 'read', program });
        if (reply.reply === 'program') return reply.text;
      } catch (refused) {
        // One that is too long for a line comes as a file.
        if (!(refused instanceof Refused) || refused.alarm || refused.code === 'no_connection') throw refused;
      }
    }
    return http.program(program);
  },
  /** Stores a program: over the socket, or as a file where it is too long for a line. */
  async store(program: string, text: string): Promise<boolean> {
    const longest = machine.hello?.longest_line ?? 4_000_000;
    if (text.length * 1.1 + 200 < longest) return machine.tell({ do: 'store', program, text });
    return this.bring(program, text);
  },
  /** Stores a file as a program. Of the encodings that shops have its own is found. */
  async bring(program: string, file: Blob | string): Promise<boolean> {
    try {
      await http.upload(program, file);
      return true;
    } catch (failed) {
      machine.refused(failed);
      return false;
    }
  },
};
