// Highlighting of part programs over the visible lines alone, so that a keystroke in a program of 10 MB costs no more
// than one in a program of ten lines.
import type { ChangeDesc, Range, Text } from '@codemirror/state';
import { Decoration, ViewPlugin, type DecorationSet, type EditorView, type ViewUpdate } from '@codemirror/view';

export type Kind = 'comment' | 'g' | 'm' | 'n' | 'axis' | 'word' | 'macro';
/** How each kind looks. Axis words look like the text itself: most words are, and each mark costs at every keystroke. */
const marks: Partial<Record<Kind, Decoration>> = {
  comment: Decoration.mark({ class: 'nc-comment' }),
  g: Decoration.mark({ class: 'nc-g' }),
  m: Decoration.mark({ class: 'nc-m' }),
  n: Decoration.mark({ class: 'nc-n' }),
  word: Decoration.mark({ class: 'nc-word' }),
  macro: Decoration.mark({ class: 'nc-macro' }),
};

const PIECES =
  /(\([^)\n]*\)?|;.*|"[^"\n]*"?)|\b(IF|GOTO|WHILE|DO|END|THEN|EQ|NE|GT|LT|GE|LE|AND|OR|XOR|MOD|SIN|COS|TAN|ATAN|ASIN|ACOS|SQRT|ABS|ROUND|FIX|FUP|LN|EXP|BIN|BCD)\b\d*|(#\d*|#[A-Z]\w*)|([A-Za-z])(?=\s*[-+.#[\d])\s*[-+]?\d*\.?\d*/gi;
/** Of a line that is longer than this, only so much is looked at: nobody reads further. */
const LONGEST = 2000;

/** The pieces of a line: kind, begin and end. */
export function pieces(line: string): { kind: Kind; from: number; to: number }[] {
  const found: { kind: Kind; from: number; to: number }[] = [];
  for (const match of line.slice(0, LONGEST).matchAll(PIECES)) {
    const [whole, comment, macro, variable, letter] = match;
    const from = match.index;
    let kind: Kind;
    if (comment !== undefined) kind = 'comment';
    else if (macro !== undefined || variable !== undefined) kind = 'macro';
    else {
      const address = letter!.toUpperCase();
      if (address === 'G') kind = 'g';
      else if (address === 'M') kind = 'm';
      else if (address === 'N' || address === 'O') kind = 'n';
      else kind = 'XYZABCUVWIJKR'.includes(address) ? 'axis' : 'word';
    }
    found.push({ kind, from, to: from + whole.trimEnd().length });
  }
  return found;
}

/** The marks of whole lines. */
function marksOf(doc: Text, from: number, to: number): Range<Decoration>[] {
  const found: Range<Decoration>[] = [];
  for (let at = from; at <= to; ) {
    const line = doc.lineAt(at);
    for (const { kind, from, to } of pieces(line.text)) {
      const mark = marks[kind];
      if (mark) found.push(mark.range(line.from + from, line.from + to));
    }
    at = line.to + 1;
  }
  return found;
}

/** The marks of some stretches of a text. */
export const marksIn = (doc: Text, stretches: readonly { from: number; to: number }[]): DecorationSet =>
  Decoration.set(stretches.flatMap(({ from, to }) => marksOf(doc, from, to)));

/** Marks behind a change: only the lines that it touches are looked at anew, and the editor sees that the others are the same. */
export function follow(before: DecorationSet, doc: Text, changes: ChangeDesc): DecorationSet {
  let now = before.map(changes);
  changes.iterChangedRanges((_from, _to, begin, end) => {
    const [from, to] = [doc.lineAt(begin).from, doc.lineAt(end).to];
    now = now.update({ filterFrom: from, filterTo: to, filter: () => false, add: marksOf(doc, from, to) });
  });
  return now;
}

export const highlighter = ViewPlugin.fromClass(
  class {
    decorations: DecorationSet;
    constructor(view: EditorView) {
      this.decorations = marksIn(view.state.doc, view.visibleRanges);
    }
    update({ docChanged, viewportChanged, view, changes }: ViewUpdate): void {
      if (viewportChanged) this.decorations = marksIn(view.state.doc, view.visibleRanges);
      else if (docChanged) this.decorations = follow(this.decorations, view.state.doc, changes);
    }
  },
  { decorations: (plugin) => plugin.decorations },
);
