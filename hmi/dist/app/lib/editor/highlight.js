import { RangeSetBuilder } from "@codemirror/state";
import { Decoration, ViewPlugin } from "@codemirror/view";
// src/lib/editor/highlight.ts
/** How each kind looks. Axis words look like the text itself: most words are, and each mark costs at every keystroke. */
var marks = {
	comment: Decoration.mark({ class: "nc-comment" }),
	g: Decoration.mark({ class: "nc-g" }),
	m: Decoration.mark({ class: "nc-m" }),
	n: Decoration.mark({ class: "nc-n" }),
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
		for (const { kind, from, to } of pieces(line.text)) {
			const mark = marks[kind];
			if (mark) builder.add(line.from + from, line.from + to, mark);
		}
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
