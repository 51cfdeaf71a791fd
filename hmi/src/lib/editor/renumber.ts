/** Numbers the blocks of a program anew, and follows with GOTO, P and Q of what names them. Comments, program numbers,
    empty lines and lines of `%` get none. */
export function renumber(text: string, first: number, step: number): string {
  const lines = text.split('\n');
  const numbers = new Map<number, number>();
  let next = first;
  const bare = (line: string) => line.replace(/\([^)]*\)/g, '').trim();
  const wants = lines.map((line) => {
    const body = bare(line);
    return body !== '' && !body.startsWith('%') && !/^[O:;]/i.test(body);
  });
  lines.forEach((line, index) => {
    if (!wants[index]) return;
    const old = /^(\s*\/?\d?\s*)N\s*(\d+)/i.exec(line);
    if (old && !numbers.has(Number(old[2]))) numbers.set(Number(old[2]), next);
    next += step;
  });
  next = first;
  return lines
    .map((line, index) => {
      if (!wants[index]) return line;
      const number = next;
      next += step;
      const [, skip = '', rest = ''] = /^(\s*(?:\/\d?\s*)?)(?:N\s*\d+\s*)?(.*)$/i.exec(line) ?? [];
      return `${skip}N${number} ${follow(rest, numbers)}`;
    })
    .join('\n');
}

/** Jumps of a block: GOTO, and P and Q of the cycles that name blocks (G70 to G73 of lathes name none here). */
function follow(block: string, numbers: Map<number, number>): string {
  return block.replace(/\b(GOTO\s*)(\d+)/gi, (all, word: string, number: string) => {
    const now = numbers.get(Number(number));
    return now === undefined ? all : `${word}${now}`;
  });
}
