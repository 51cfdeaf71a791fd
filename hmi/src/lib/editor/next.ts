// The block that comes after the one being run (GSK990MC part 2, 3.2: current and next).

/** Remarks of all control languages, and the number of the block. */
const bare = (line: string) => line.replace(/\([^)]*\)|[;'].*$|^\s*\/*\s*N\d+/gi, '').trim();

/** Blocks behind which another one may come than the next line: jumps, conditions, loops, calls, ends. */
const LEADS_AWAY = /GOTO|IF|ELSE|END|WHILE|FOR|REPEAT|BREAK|CONTINUE|CALL|RETURN|PCALL|MCALL|^(O|LL?\s*\d)|(?<![A-Z])(G0*(65|66)|M0*(2|30|98|99|198))(?!\d)/i;

/** How many lines without a block are passed over. */
const MOST = 500;

/** Whether another block may come behind this one than the next line's. */
export function leadsAway(block: string): boolean {
  return LEADS_AWAY.test(bare(block));
}

/** The block behind a line, from 1; null where none is known: behind the last one, and where this one may lead
    elsewhere. `at` has the text of a line, null behind the end. */
export function nextBlock(at: (line: number) => string | null, line: number): string | null {
  if (line < 1 || leadsAway(at(line) ?? '')) return null;
  for (let next = line + 1; next <= line + MOST; next++) {
    const text = at(next);
    if (text === null) return null;
    if (bare(text).replace('%', '')) return text.trim();
  }
  return null;
}
