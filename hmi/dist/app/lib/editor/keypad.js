import { cursorCharLeft, cursorCharRight, cursorLineDown, cursorLineEnd, cursorLineStart, cursorLineUp, deleteCharBackward, insertNewlineAndIndent, redo as redo$1, selectCharLeft, selectCharRight, selectLineDown, selectLineEnd, selectLineStart, selectLineUp, undo as undo$1 } from "@codemirror/commands";
// src/lib/editor/keypad.ts
/** What is typed: words as they are met most, then the rest, then signs of names and remarks. The space stands for itself. */
var LAYERS = [
	[..."GXYZAIJKRMFST", ..."1234567890.-"],
	[..."NOPQHDLUVWBCE", ..."+*/()[]#=,<>"],
	[...";:%_$&|!", ..."\"'?@^~\\"]
];
/** Keys that move the cursor; what they do while a piece is being selected. */
var MOVES = {
	left: {
		icon: "left",
		move: cursorCharLeft,
		select: selectCharLeft
	},
	right: {
		icon: "right",
		move: cursorCharRight,
		select: selectCharRight
	},
	up: {
		icon: "up",
		move: cursorLineUp,
		select: selectLineUp
	},
	down: {
		icon: "down",
		move: cursorLineDown,
		select: selectLineDown
	},
	home: {
		icon: "home",
		move: cursorLineStart,
		select: selectLineStart
	},
	end: {
		icon: "end",
		move: cursorLineEnd,
		select: selectLineEnd
	}
};
var erase = deleteCharBackward;
var endBlock = insertNewlineAndIndent;
/** Types in the place of what is selected, as a keyboard does: codes are completed. */
function type(view, text) {
	view.dispatch(view.state.update(view.state.replaceSelection(text), {
		scrollIntoView: true,
		userEvent: "input.type"
	}));
}
/** What was taken last, for a browser that gives nobody its clipboard; and whether it is a whole line. */
var taken = {
	text: "",
	line: false
};
/** What is selected, else the line of the cursor with its end. */
function chosen(state) {
	const { from, to, empty } = state.selection.main;
	if (!empty) return {
		from,
		to
	};
	const line = state.doc.lineAt(from);
	return {
		from: line.from,
		to: Math.min(line.to + 1, state.doc.length)
	};
}
/** Takes a piece, which is selected no longer then. */
function copy(view) {
	take(view);
	view.dispatch({ selection: { anchor: view.state.selection.main.head } });
}
function take({ state }) {
	const { from, to } = chosen(state);
	const line = state.selection.main.empty;
	const text = state.sliceDoc(from, to);
	taken = {
		text: line && !text.endsWith("\n") ? `${text}\n` : text,
		line
	};
	navigator.clipboard?.writeText(taken.text).catch(() => void 0);
}
function cut(view) {
	take(view);
	view.dispatch({
		changes: chosen(view.state),
		userEvent: "delete.cut",
		scrollIntoView: true
	});
}
/** A whole line is put before that of the cursor. */
async function paste(view) {
	const text = await navigator.clipboard?.readText().catch(() => "") || taken.text;
	if (!text) return;
	const { state } = view;
	const { empty, head } = state.selection.main;
	const insert = state.toText(text);
	const put = taken.line && text === taken.text && empty ? {
		changes: {
			from: state.doc.lineAt(head).from,
			insert
		},
		selection: { anchor: head + insert.length }
	} : state.replaceSelection(insert);
	view.dispatch(state.update(put, {
		scrollIntoView: true,
		userEvent: "input.paste"
	}));
}
export { LAYERS, MOVES, copy, cut, endBlock, erase, paste, redo$1 as redo, type, undo$1 as undo };
