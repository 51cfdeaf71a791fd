import { RangeSetBuilder } from "@codemirror/state";
import { Decoration, ViewPlugin } from "@codemirror/view";
// src/lib/editor/highlight.ts
/** Kinds of pieces, and how each looks. */
var marks = {
	comment: Decoration.mark({ class: "nc-comment" }),
	g: Decoration.mark({ class: "nc-g" }),
	m: Decoration.mark({ class: "nc-m" }),
	n: Decoration.mark({ class: "nc-n" }),
	axis: Decoration.mark({ class: "nc-axis" }),
	word: Decoration.mark({ class: "nc-word" }),
	macro: Decoration.mark({ class: "nc-macro" })
};
var PIECES = /(\([^)\n]*\)?|;.*|"[^"\n]*"?)|\b(IF|GOTO|WHILE|DO|END|THEN|EQ|NE|GT|LT|GE|LE|AND|OR|XOR|MOD|SIN|COS|TAN|ATAN|ASIN|ACOS|SQRT|ABS|ROUND|FIX|FUP|LN|EXP|BIN|BCD)\b\d*|(#\d*|#[A-Z]\w*)|([A-Za-z])(?=\s*[-+.#[\d])\s*[-+]?\d*\.?\d*/gi;
/** Of a line that is longer than this, only so much is looked at: nobody reads further. */
var LONGEST = 2e3;
/** The pieces of a line: kind, begin and end. */
function pieces(line) {
	const found = [];
	for (const match of line.slice(0, LONGEST).matchAll(PIECES)) {
		const [whole, comment, macro, variable, letter] = match;
		const from = match.index;
		let kind;
		if (comment !== void 0) kind = "comment";
		else if (macro !== void 0 || variable !== void 0) kind = "macro";
		else {
			const address = letter.toUpperCase();
			if (address === "G") kind = "g";
			else if (address === "M") kind = "m";
			else if (address === "N" || address === "O") kind = "n";
			else kind = "XYZABCUVWIJKR".includes(address) ? "axis" : "word";
		}
		found.push({
			kind,
			from,
			to: from + whole.trimEnd().length
		});
	}
	return found;
}
function visible(view) {
	const builder = new RangeSetBuilder();
	for (const { from, to } of view.visibleRanges) for (let at = from; at <= to;) {
		const line = view.state.doc.lineAt(at);
		for (const piece of pieces(line.text)) builder.add(line.from + piece.from, line.from + piece.to, marks[piece.kind]);
		at = line.to + 1;
	}
	return builder.finish();
}
var highlighter = ViewPlugin.fromClass(class {
	decorations;
	constructor(view) {
		this.decorations = visible(view);
	}
	update(update) {
		if (update.docChanged || update.viewportChanged) this.decorations = visible(update.view);
	}
}, { decorations: (plugin) => plugin.decorations });
export { highlighter, pieces };
