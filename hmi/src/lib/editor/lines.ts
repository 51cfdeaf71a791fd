// A text as the editor has it, and how it is put together again as it was: with the line ends that it has, the mark of
// UTF-8 that it begins with, and no line end behind its last line that was not there.

export type Lines = {
  /** Whether it begins with a byte order mark. The editor does not show it. */
  mark: boolean;
  lines: string[];
  /** What most lines end with, and so those that are written anew. */
  end: string;
  /** Lines that end in another way, by their place from 0. */
  others: Map<number, string>;
};

const MARK = '\ufeff';

/** The lines of a text, ended in any way that the editor knows. One kind of line feeds, with a carriage return each or
    with none, is split at much faster than by an expression, which counts in a program of 10 MB. */
export function linesOf(text: string): Lines {
  const mark = text.startsWith(MARK);
  const body = mark ? text.slice(1) : text;
  for (const end of ['\n', '\r\n']) {
    if (!body.includes(end)) continue;
    const lines = body.split(end);
    if (lines.every((line) => !line.includes('\r') && !line.includes('\n'))) return { mark, lines, end, others: new Map() };
  }
  const ends = body.match(/\r\n?|\n/g) ?? [];
  const count = (end: string) => ends.filter((one) => one === end).length;
  const end = ['\n', '\r\n', '\r'].reduce((most, one) => (count(one) > count(most) ? one : most));
  const others = new Map([...ends.entries()].filter(([, one]) => one !== end));
  return { mark, lines: body.split(/\r\n?|\n/), end, others };
}

/** The text of lines. */
export function textOf({ mark, lines, end, others }: Lines): string {
  const body = others.size === 0 ? lines.join(end) : lines.map((line, at) => (at < lines.length - 1 ? line + (others.get(at) ?? end) : line)).join('');
  return mark ? MARK + body : body;
}
