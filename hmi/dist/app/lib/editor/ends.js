import { RangeSet, RangeValue, StateField } from "@codemirror/state";
// src/lib/editor/ends.ts
/** The end of a line that is ended in another way than most of its text: it stays with its line break. */
var LineEnd = class LineEnd extends RangeValue {
	end;
	startSide = 1;
	endSide = -1;
	constructor(end) {
		super();
		this.end = end;
	}
	eq(other) {
		return other instanceof LineEnd && other.end === this.end;
	}
};
var field = StateField.define({
	create: () => RangeSet.empty,
	update: (ends, { changes }) => ends.map(changes)
});
/** Keeps the ends of these lines, by their place from 0, as the document is changed. */
function lineEnds(doc, others) {
	const at = (line) => doc.line(line + 1).to;
	return field.init(() => RangeSet.of([...others].map(([line, end]) => new LineEnd(end).range(at(line), at(line) + 1))));
}
/** Where those lines are now. */
function othersIn(state) {
	const others = /* @__PURE__ */ new Map();
	state.field(field).between(0, state.doc.length, (from, _, { end }) => {
		others.set(state.doc.lineAt(from).number - 1, end);
	});
	return others;
}
export { lineEnds, othersIn };
