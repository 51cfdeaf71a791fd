// What the program editor leaves behind while another page is shown: which program is open, where its cursor is, what
// of it is not yet saved; and text that another page puts into it.

let open = $state.raw<{ program: string; line: number; draft: string | null } | null>(null);
let pending = $state.raw<{ program: string; text: string } | null>(null);

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
  draft(program: string): string | null {
    return open?.program === program ? open.draft : null;
  },
  leave(program: string, line: number, draft: string | null): void {
    open = { program, line, draft };
  },
  /** Text for a program; the editor takes it up when it shows it. */
  put(program: string, text: string): void {
    pending = { program, text };
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

/** The line behind which text goes into a program: that of the cursor, but never behind the end of the program, where
    nothing is run. Without a cursor before the end. */
export function lineFor(program: string, cursor: number): number {
  const lines = program.split(/\r?\n/);
  const code = (line: string) => line.replace(/\([^)]*\)|[;'].*$/g, '');
  const end = lines.findIndex((line) => /(^|[^A-Z0-9])M0*(30|2|99)([^0-9]|$)/i.test(code(line)));
  const last = end >= 0 ? end : lines.length - (lines.at(-1) === '' ? 1 : 0);
  return cursor > 0 ? Math.min(cursor, last) : last;
}
