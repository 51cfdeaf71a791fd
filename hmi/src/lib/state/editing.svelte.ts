// What the program editor leaves behind while another page or program is shown: which program was open last, where its
// cursor is, what of each program is not yet saved; and text that another page puts into it.

let open = $state.raw<{ program: string; line: number } | null>(null);
/** What is not stored yet: the text, and what the memory had when it was begun. */
export type Draft = { text: string; base: string };
let drafts = $state.raw<ReadonlyMap<string, Draft>>(new Map());
let wanted = $state.raw<{ program: string; line: number } | null>(null);
let pending = $state.raw<{ program: string; text: string; instead: string[] } | null>(null);
/** A cycle of a program that is open in the cycle editor: where it stands, and its lines. */
export type Opened = { program: string; from: number; lines: string[] };
let opened = $state.raw<Opened | null>(null);

export const editing = {
  /** The program that was open last. */
  get program(): string | null {
    return open?.program ?? null;
  },
  /** The line of its cursor, from 1. */
  get line(): number {
    return open?.line ?? 0;
  },
  /** What stands in the editor and not yet in the memory; null where both are the same. */
  draft(program: string): Draft | null {
    return drafts.get(program) ?? null;
  },
  /** Programs of which something is not stored yet. */
  get unsaved(): string[] {
    return [...drafts.keys()];
  },
  leave(program: string, line: number, draft: Draft | null): void {
    open = { program, line };
    const now = new Map(drafts);
    if (draft === null) now.delete(program);
    else now.set(program, draft);
    drafts = now;
  },
  /** A line of a program, from 1, is to be shown; the editor goes there when it shows the program. */
  goTo(program: string, line: number): void {
    wanted = { program, line };
  },
  /** Takes the line of a program that is to be shown; 0 where none is. One of another program is not shown any more. */
  takeLine(program: string): number {
    const line = wanted?.program === program ? wanted.line : 0;
    if (wanted) wanted = null;
    return line;
  },
  /** A program is gone, or is called something else: its draft goes with it. */
  moved(program: string, to: string | null): void {
    const draft = drafts.get(program);
    if (draft === undefined) return;
    const now = new Map(drafts);
    now.delete(program);
    if (to !== null) now.set(to, draft);
    drafts = now;
  },
  /** Text for a program, in place of lines of it where there are such; the editor takes it up when it shows it. */
  put(program: string, text: string, instead: string[] = []): void {
    pending = { program, text, instead };
  },
  /** The lines in whose place the text that waits goes. */
  get instead(): string[] {
    return pending?.instead ?? [];
  },
  /** The cycle that is filled in anew; null where a new one is. */
  get opened(): Opened | null {
    return opened;
  },
  open(cycle: Opened | null): void {
    opened = cycle;
  },
  /** Whether text waits for a program. */
  waits(program: string): boolean {
    return pending?.program === program;
  },
  /** Takes the text that waits. */
  take(): string {
    const { text } = pending ?? { text: '' };
    pending = null;
    return text;
  },
};

/** The line, from 1, at which lines stand in a text, those nearest to where they were; 0 where they do not. */
export function placeOf(text: readonly string[], lines: readonly string[], near: number): number {
  let best = 0;
  for (let at = 0; at + lines.length <= text.length && lines.length > 0; at++) {
    if (text[at] !== lines[0] || !lines.every((line, index) => text[at + index] === line)) continue;
    if (best === 0 || Math.abs(at + 1 - near) < Math.abs(best - near)) best = at + 1;
  }
  return best;
}

/** A line without its remarks. */
const code = (line: string) => line.replace(/\([^)]*\)|[;'].*$/g, '');

/** The line behind which text goes into a program: that of the cursor, but never behind the end of the program, where
    nothing is run. Without a cursor before the end. */
export function lineFor(program: string, cursor: number): number {
  const lines = program.split(/\r?\n/);
  const end = lines.findIndex((line) => /(^|[^A-Z0-9])M0*(30|2|99)([^0-9]|$)/i.test(code(line)));
  const last = end >= 0 ? end : lines.length - (lines.at(-1) === '' ? 1 : 0);
  return cursor > 0 ? Math.min(cursor, last) : last;
}

/** Codes of which one of a row is in force: planes, units, absolute or incremental, feed a minute or a revolution, offset of
    the radius. G70 and G71 are units too. */
const ROWS = [['17', '18', '19'], ['20', '21', '70', '71'], ['90', '91'], ['94', '95'], ['40', '41', '42']];
const SAME: Record<string, string> = { 70: '20', 71: '21' };

/** The code of each row that stands last in a text; '' where there is none. */
function lastCodes(text: string): string[] {
  const found = text.split(/\r?\n/).flatMap((line) => [...code(line).matchAll(/G0*(\d+(?:\.\d+)?)/gi)].map((one) => one[1]!));
  return ROWS.map((row) => found.findLast((one) => row.includes(one)) ?? '');
}

/** Codes that are in force above a place and are not any more behind text that is put there. */
export function codesLost(above: string, put: string): string[] {
  const behind = lastCodes(put);
  const same = (one: string) => SAME[one] ?? one;
  return lastCodes(above).filter((one, row) => one && behind[row] && same(one) !== same(behind[row])).map((one) => `G${one}`);
}
