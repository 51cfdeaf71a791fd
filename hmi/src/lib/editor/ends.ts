// The line ends of a document that has several kinds of them.
import { RangeSet, RangeValue, StateField, type EditorState, type Extension, type Text } from '@codemirror/state';

/** The end of a line that is ended in another way than most of its text: it stays with its line break. */
class LineEnd extends RangeValue {
  override startSide = 1;
  override endSide = -1;
  constructor(readonly end: string) {
    super();
  }
  override eq(other: RangeValue): boolean {
    return other instanceof LineEnd && other.end === this.end;
  }
}

const field = StateField.define<RangeSet<LineEnd>>({
  create: () => RangeSet.empty,
  update: (ends, { changes }) => ends.map(changes),
});

/** Keeps the ends of these lines, by their place from 0, as the document is changed. */
export function lineEnds(doc: Text, others: Map<number, string>): Extension {
  const at = (line: number) => doc.line(line + 1).to;
  return field.init(() => RangeSet.of([...others].map(([line, end]) => new LineEnd(end).range(at(line), at(line) + 1))));
}

/** Where those lines are now. */
export function othersIn(state: EditorState): Map<number, string> {
  const others = new Map<number, string>();
  state.field(field).between(0, state.doc.length, (from, _, { end }) => {
    others.set(state.doc.lineAt(from).number - 1, end);
  });
  return others;
}
