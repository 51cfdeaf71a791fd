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
/** The marks of whole lines. */
function marksOf(doc, from, to) {
	const found = [];
	for (let at = from; at <= to;) {
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
var marksIn = (doc, stretches) => Decoration.set(stretches.flatMap(({ from, to }) => marksOf(doc, from, to)));
/** Marks behind a change: only the lines that it touches are looked at anew, and the editor sees that the others are the same. */
function follow(before, doc, changes) {
	let now = before.map(changes);
	changes.iterChangedRanges((_from, _to, begin, end) => {
		const [from, to] = [doc.lineAt(begin).from, doc.lineAt(end).to];
		now = now.update({
			filterFrom: from,
			filterTo: to,
			filter: () => false,
			add: marksOf(doc, from, to)
		});
	});
	return now;
}
var highlighter = ViewPlugin.fromClass(class {
	decorations;
	constructor(view) {
		this.decorations = marksIn(view.state.doc, view.visibleRanges);
	}
	update({ docChanged, viewportChanged, view, changes }) {
		if (viewportChanged) this.decorations = marksIn(view.state.doc, view.visibleRanges);
		else if (docChanged) this.decorations = follow(this.decorations, view.state.doc, changes);
	}
}, { decorations: (plugin) => plugin.decorations });
export { follow, highlighter, marksIn, pieces };
