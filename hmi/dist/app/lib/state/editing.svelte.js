import * as $ from "svelte/internal/client";
// src/lib/state/editing.svelte.ts
var open = $.state(null);
var drafts = $.state(/* @__PURE__ */ new Map());
var wanted = $.state(null);
var pending = $.state(null);
var opened = $.state(null);
var editing = {
	get program() {
		return $.get(open)?.program ?? null;
	},
	/** The line of its cursor, from 1. */
	get line() {
		return $.get(open)?.line ?? 0;
	},
	/** What stands in the editor and not yet in the memory; null where both are the same. */
	draft(program) {
		return $.get(drafts).get(program) ?? null;
	},
	/** Programs of which something is not stored yet. */
	get unsaved() {
		return [...$.get(drafts).keys()];
	},
	leave(program, line, draft) {
		$.set(open, {
			program,
			line
		});
		const now = new Map($.get(drafts));
		if (draft === null) now.delete(program);
		else now.set(program, draft);
		$.set(drafts, now);
	},
	/** A line of a program, from 1, is to be shown; the editor goes there when it shows the program. */
	goTo(program, line) {
		$.set(wanted, {
			program,
			line
		});
	},
	/** Takes the line of a program that is to be shown; 0 where none is. One of another program is not shown any more. */
	takeLine(program) {
		const line = $.get(wanted)?.program === program ? $.get(wanted).line : 0;
		if ($.get(wanted)) $.set(wanted, null);
		return line;
	},
	/** A program is gone, or is called something else: its draft goes with it. */
	moved(program, to) {
		const draft = $.get(drafts).get(program);
		if (draft === void 0) return;
		const now = new Map($.get(drafts));
		now.delete(program);
		if (to !== null) now.set(to, draft);
		$.set(drafts, now);
	},
	/** Text for a program, in place of lines of it where there are such; the editor takes it up when it shows it. */
	put(program, text, instead = []) {
		$.set(pending, {
			program,
			text,
			instead
		});
	},
	/** The lines in whose place the text that waits goes. */
	get instead() {
		return $.get(pending)?.instead ?? [];
	},
	/** The cycle that is filled in anew; null where a new one is. */
	get opened() {
		return $.get(opened);
	},
	open(cycle) {
		$.set(opened, cycle);
	},
	/** Whether text waits for a program. */
	waits(program) {
		return $.get(pending)?.program === program;
	},
	/** Takes the text that waits. */
	take() {
		const { text } = $.get(pending) ?? { text: "" };
		$.set(pending, null);
		return text;
	}
};
/** The line, from 1, at which lines stand in a text, those nearest to where they were; 0 where they do not. */
function placeOf(text, lines, near) {
	let best = 0;
	for (let at = 0; at + lines.length <= text.length && lines.length > 0; at++) {
		if (text[at] !== lines[0] || !lines.every((line, index) => text[at + index] === line)) continue;
		if (best === 0 || Math.abs(at + 1 - near) < Math.abs(best - near)) best = at + 1;
	}
	return best;
}
/** A line without its remarks. */
var code = (line) => line.replace(/\([^)]*\)|[;'].*$/g, "");
/** The line behind which text goes into a program: that of the cursor, but never behind the end of the program, where
nothing is run. Without a cursor before the end. */
function lineFor(program, cursor) {
	const lines = program.split(/\r?\n/);
	const end = lines.findIndex((line) => /(^|[^A-Z0-9])M0*(30|2|99)([^0-9]|$)/i.test(code(line)));
	const last = end >= 0 ? end : lines.length - (lines.at(-1) === "" ? 1 : 0);
	return cursor > 0 ? Math.min(cursor, last) : last;
}
/** Codes of which one of a row is in force: planes, units, absolute or incremental, feed a minute or a revolution, offset of
the radius. G70 and G71 are units too. */
var ROWS = [
	[
		"17",
		"18",
		"19"
	],
	[
		"20",
		"21",
		"70",
		"71"
	],
	["90", "91"],
	["94", "95"],
	[
		"40",
		"41",
		"42"
	]
];
var SAME = {
	70: "20",
	71: "21"
};
/** The code of each row that stands last in a text; '' where there is none. */
function lastCodes(text) {
	const found = text.split(/\r?\n/).flatMap((line) => [...code(line).matchAll(/G0*(\d+(?:\.\d+)?)/gi)].map((one) => one[1]));
	return ROWS.map((row) => found.findLast((one) => row.includes(one)) ?? "");
}
/** Codes that are in force above a place and are not any more behind text that is put there. */
function codesLost(above, put) {
	const behind = lastCodes(put);
	const same = (one) => SAME[one] ?? one;
	return lastCodes(above).filter((one, row) => one && behind[row] && same(one) !== same(behind[row])).map((one) => `G${one}`);
}
export { codesLost, editing, lineFor, placeOf };
