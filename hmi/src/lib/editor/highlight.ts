// Highlighting of part programs over the visible lines alone, so that a keystroke in a program of 10 MB costs no more
// than one in a program of ten lines.
import { RangeSetBuilder } from '@codemirror/state';
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

function visible(view: EditorView): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>();
  for (const { from, to } of view.visibleRanges) {
    for (let at = from; at <= to; ) {
      const line = view.state.doc.lineAt(at);
      for (const { kind, from, to } of pieces(line.text)) {
        const mark = marks[kind];
        if (mark) builder.add(line.from + from, line.from + to, mark);
      }
      at = line.to + 1;
    }
  }
  return builder.finish();
}

export const highlighter = ViewPlugin.fromClass(
  class {
    decorations: DecorationSet;
    constructor(view: EditorView) {
      this.decorations = visible(view);
    }
    update(update: ViewUpdate): void {
      if (update.docChanged || update.viewportChanged) this.decorations = visible(update.view);
    }
  },
  { decorations: (plugin) => plugin.decorations },
);
