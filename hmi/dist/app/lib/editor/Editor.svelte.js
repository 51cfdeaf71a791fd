import { machine } from "../state/machine.svelte.js";
import { prefs } from "../state/prefs.svelte.js";
import { lineEnds, othersIn } from "./ends.js";
import { highlighter } from "./highlight.js";
import Keypad from "./Keypad.svelte.js";
import { checkNow, controlLanguage } from "./language.js";
import { linesOf, textOf } from "./lines.js";
import { numberBehind } from "./numbering.js";
import { phrases } from "./phrases.js";
import { theme } from "./theme.js";
import { untrack } from "svelte";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
import { defaultKeymap, history, historyKeymap, redo, undo } from "@codemirror/commands";
import { lintGutter, lintKeymap } from "@codemirror/lint";
import { gotoLine, highlightSelectionMatches, openSearchPanel, search, searchKeymap } from "@codemirror/search";
import { Compartment, EditorState, StateEffect, StateField, Text } from "@codemirror/state";
import { Decoration, EditorView, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers } from "@codemirror/view";
// src/lib/editor/Editor.svelte
var root = $.from_html(`<div class="whole s-1nec4lb"><div class="editor s-1nec4lb"></div> <!></div>`);
function Editor($$anchor, $$props) {
	$.push($$props, true);
	let readonly = $.prop($$props, "readonly", 3, false), active = $.prop($$props, "active", 3, 0), cursor = $.prop($$props, "cursor", 3, 0), plain = $.prop($$props, "plain", 3, false), step = $.prop($$props, "step", 3, 0);
	/** What is opened; another text is another document. */
	/** The line being run, from 1; 0 for none. */
	/** The line where cycle start begins, from 1. */
	/** Not a part program: without its colours and checks. */
	/** Increment of the sequence numbers that are inserted as lines are typed; 0 inserts none. */
	/** A line was chosen. */
	/** Another page is shown: what stands there, as `value` has it, and the line of the cursor. */
	let host = $.state(void 0);
	let view;
	/** The text that was opened, and of it what the editor does not show. */
	let opened = "";
	/** Whether its owner was told already what stands there. */
	let left = false;
	let form = {
		mark: false,
		end: "\n"
	};
	const said = new Compartment();
	const typed = new Compartment();
	/** A device shows no keyboard of its own beside the keypad. */
	const keyboard = () => EditorView.contentAttributes.of({ inputmode: prefs.keypad ? "none" : "text" });
	const lines = StateEffect.define();
	const activeMark = Decoration.line({ class: "nc-active" });
	const cursorMark = Decoration.line({ class: "nc-cursor" });
	const marked = StateField.define({
		create: () => Decoration.none,
		update(old, transaction) {
			let now = old.map(transaction.changes);
			for (const effect of transaction.effects) {
				if (!effect.is(lines)) continue;
				const { doc } = transaction.state;
				const at = (line) => line >= 1 && line <= doc.lines ? doc.line(line).from : null;
				const run = at(effect.value.active);
				const start = at(effect.value.cursor);
				if (run !== null) now = Decoration.set(activeMark.range(run));
				else now = start === null ? Decoration.none : Decoration.set(cursorMark.range(start));
			}
			return now;
		},
		provide: (field) => EditorView.decorations.from(field)
	});
	/** A new line with its number; false where the editor's own does. */
	function numberLine({ state, dispatch }) {
		if (state.readOnly || plain() || step() <= 0 || state.selection.ranges.length > 1) return false;
		const { from, to } = state.selection.main;
		const line = state.doc.lineAt(from);
		const at = (number) => number === line.number ? state.doc.sliceString(line.from, from) : number >= 1 ? state.doc.line(number).text : null;
		const number = numberBehind(at, line.number, step(), state.doc.sliceString(to, state.doc.lineAt(to).to));
		if (!number) return false;
		dispatch(state.update(state.replaceSelection(`${state.lineBreak}${number}`), {
			scrollIntoView: true,
			userEvent: "input"
		}));
		return true;
	}
	function opening(text) {
		const { lines, others, ...rest } = linesOf(text);
		form = rest;
		const doc = Text.of(lines);
		return EditorState.create({
			doc,
			extensions: [
				lineEnds(doc, others),
				lineNumbers(),
				plain() ? [] : highlighter,
				theme,
				marked,
				said.of(untrack(phrases)),
				typed.of(untrack(keyboard)),
				search({ top: true }),
				EditorView.contentAttributes.of({
					"aria-label": $$props.label,
					spellcheck: "false",
					autocapitalize: "characters"
				}),
				keymap.of([
					{
						key: "Mod-s",
						preventDefault: true,
						run: () => {
							$$props.onsave?.();
							return true;
						}
					},
					{
						key: "Enter",
						run: numberLine
					},
					...searchKeymap,
					...historyKeymap,
					...lintKeymap,
					...defaultKeymap
				]),
				readonly() ? [EditorState.readOnly.of(true), EditorView.updateListener.of((update) => {
					if (update.selectionSet && update.transactions.some((one) => one.isUserEvent("select"))) $$props.online?.(update.state.doc.lineAt(update.state.selection.main.head).number);
				})] : [
					history(),
					highlightActiveLine(),
					highlightActiveLineGutter(),
					highlightSelectionMatches({ minSelectionLength: 2 }),
					EditorView.updateListener.of((update) => {
						if (update.docChanged) $$props.onchange?.();
					}),
					plain() ? [] : [lintGutter(), controlLanguage(() => machine.dialect, (findings) => $$props.onfindings?.(findings))]
				]
			]
		});
	}
	$.user_effect(() => {
		if (!$.get(host)) return;
		opened = untrack(() => $$props.text);
		const made = untrack(() => new EditorView({
			state: opening($$props.text),
			parent: $.get(host)
		}));
		view = made;
		return () => {
			if (!left) leave();
			made.destroy();
			view = void 0;
		};
	});
	$.user_effect(() => {
		const now = $$props.text;
		if (!view || now === opened) return;
		opened = now;
		untrack(() => view?.setState(opening(now)));
	});
	$.user_effect(() => {
		const now = phrases();
		view?.dispatch({ effects: said.reconfigure(now) });
	});
	$.user_effect(() => {
		const now = keyboard();
		view?.dispatch({ effects: typed.reconfigure(now) });
	});
	$.user_effect(() => {
		const now = {
			active: active(),
			cursor: cursor()
		};
		$$props.text;
		if (!view) return;
		const { doc } = view.state;
		const line = now.active || now.cursor;
		const effects = [lines.of(now)];
		if (readonly() && line >= 1 && line <= doc.lines) effects.push(EditorView.scrollIntoView(doc.line(line).from, { y: "center" }));
		view.dispatch({ effects });
	});
	const textIn = (state) => textOf({
		...form,
		lines: state.doc.toJSON(),
		others: othersIn(state)
	});
	/** What stands there now, with the line ends of the text that was opened. */
	function value() {
		return view ? textIn(view.state) : $$props.text;
	}
	/** Whether it is checked when it is saved, since it is too long to be checked as it is typed. */
	function isLong() {
		return view !== void 0 && view.state.doc.length > 4e5;
	}
	/** Checks what stands there now. */
	async function check() {
		return view ? checkNow(view, machine.dialect) : [];
	}
	/** Tells the owner what stands there, before another text takes this one's place. */
	function leave() {
		if (!view) return;
		left = true;
		const { state } = view;
		$$props.onleave?.(() => textIn(state), state.doc.lineAt(state.selection.main.head).number);
	}
	/** Opens another text of the same program, at the same line. What was done before cannot be undone any more. */
	function reopen(now) {
		if (!view) return;
		const { doc, selection } = view.state;
		const line = doc.lineAt(selection.main.head).number;
		opened = now;
		view.setState(opening(now));
		const { from } = view.state.doc.line(Math.min(line, view.state.doc.lines));
		view.dispatch({
			selection: { anchor: from },
			effects: EditorView.scrollIntoView(from, { y: "center" })
		});
	}
	/** A line, from 1; null where there is none. */
	function line(number) {
		return view && number >= 1 && number <= view.state.doc.lines ? view.state.doc.line(number).text : null;
	}
	/** Writes each line anew, so that it can be undone at once. */
	function rewrite(write) {
		if (!view) return;
		const { doc } = view.state;
		const lines = doc.toJSON();
		const changes = [];
		let from = 0;
		write(lines).forEach((insert, at) => {
			const to = from + lines[at].length;
			if (insert !== lines[at]) changes.push({
				from,
				to,
				insert
			});
			from = to + 1;
		});
		view.dispatch({ changes });
	}
	/** Inserts at the cursor. */
	function insert(piece) {
		view?.dispatch(view.state.replaceSelection(piece));
		view?.focus();
	}
	/** The line of the cursor, from 1. */
	function at() {
		return view ? view.state.doc.lineAt(view.state.selection.main.head).number : 0;
	}
	/** All lines, without their ends. */
	function all() {
		return view ? view.state.doc.toJSON() : [];
	}
	/** Puts lines in the place of others, and shows them. */
	function replaceLines(first, count, lines) {
		if (!view || count < 1) return;
		const { doc } = view.state;
		const [from, to] = [doc.line(first).from, doc.line(first + count - 1).to];
		const insert = view.state.toText(lines.replace(/\r?\n$/, ""));
		view.dispatch({
			changes: {
				from,
				to,
				insert
			},
			selection: {
				anchor: from,
				head: from + insert.length
			},
			effects: EditorView.scrollIntoView(from, {
				y: "start",
				yMargin: 60
			})
		});
		view.focus();
	}
	/** Inserts whole lines behind a line, and shows them. */
	function insertBehind(line, lines) {
		if (!view) return;
		const { doc } = view.state;
		const at = line < 1 ? 0 : doc.line(Math.min(line, doc.lines)).to;
		const piece = lines.replace(/\r?\n$/, "");
		const from = line < 1 ? 0 : at + 1;
		view.dispatch({
			changes: {
				from: at,
				insert: line < 1 ? `${piece}\n` : `\n${piece}`
			},
			selection: {
				anchor: from,
				head: from + piece.length
			},
			effects: EditorView.scrollIntoView(from, {
				y: "start",
				yMargin: 60
			})
		});
		view.focus();
	}
	function find() {
		if (view) openSearchPanel(view);
	}
	function toLine() {
		if (view) gotoLine(view);
	}
	function back() {
		if (view) undo(view);
	}
	function again() {
		if (view) redo(view);
	}
	function show(line) {
		if (!view || line < 1 || line > view.state.doc.lines) return;
		const at = view.state.doc.line(line).from;
		view.dispatch({
			selection: { anchor: at },
			effects: EditorView.scrollIntoView(at, { y: "center" })
		});
		view.focus();
	}
	var $$exports = {
		value,
		isLong,
		check,
		leave,
		reopen,
		line,
		rewrite,
		insert,
		at,
		all,
		replaceLines,
		insertBehind,
		find,
		toLine,
		back,
		again,
		show
	};
	var div = root();
	var div_1 = $.child(div);
	$.bind_this(div_1, ($$value) => $.set(host, $$value), () => $.get(host));
	var node = $.sibling(div_1, 2);
	var consequent = ($$anchor) => {
		Keypad($$anchor, {
			view: () => view,
			online: numberLine
		});
	};
	$.if(node, ($$render) => {
		if (prefs.keypad && !readonly()) $$render(consequent);
	});
	$.reset(div);
	$.append($$anchor, div);
	return $.pop($$exports);
}
export { Editor as default };
