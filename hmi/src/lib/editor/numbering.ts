// Sequence numbers that are inserted as blocks are typed (GSK990MC part 2, 3.4.1: 0#5, P210).

/** Largest sequence number. */
const LARGEST = 99999;

/** How many lines are looked back for a number. */
const MOST = 10_000;

/** The number of a block. */
const NUMBER = /^\s*\/*\s*N(\d+)/i;

/** What a line begins with that is typed behind the line `behind`, from 1; empty where it gets no number. `at` has the
    text of a line; `rest` is what is taken over from the line before. */
export function numberBehind(at: (line: number) => string | null, behind: number, step: number, rest = ''): string {
  if (step <= 0 || NUMBER.test(rest)) return '';
  for (let line = behind; line >= 1 && line > behind - MOST; line--) {
    const found = NUMBER.exec(at(line) ?? '');
    if (!found) continue;
    const next = Number(found[1]) + step;
    return next > LARGEST ? '' : `N${next} `;
  }
  return `N${step} `;
}
