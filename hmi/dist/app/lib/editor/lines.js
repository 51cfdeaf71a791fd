// src/lib/editor/lines.ts
var MARK = "﻿";
/** The lines of a text, ended in any way that the editor knows. One kind of line feeds, with a carriage return each or
with none, is split at much faster than by an expression, which counts in a program of 10 MB. */
function linesOf(text) {
	const mark = text.startsWith(MARK);
	const body = mark ? text.slice(1) : text;
	for (const end of ["\n", "\r\n"]) {
		if (!body.includes(end)) continue;
		const lines = body.split(end);
		if (lines.every((line) => !line.includes("\r") && !line.includes("\n"))) return {
			mark,
			lines,
			end,
			others: /* @__PURE__ */ new Map()
		};
	}
	const ends = body.match(/\r\n?|\n/g) ?? [];
	const count = (end) => ends.filter((one) => one === end).length;
	const end = [
		"\n",
		"\r\n",
		"\r"
	].reduce((most, one) => count(one) > count(most) ? one : most);
	const others = new Map([...ends.entries()].filter(([, one]) => one !== end));
	return {
		mark,
		lines: body.split(/\r\n?|\n/),
		end,
		others
	};
}
/** The text of lines. */
function textOf({ mark, lines, end, others }) {
	const body = others.size === 0 ? lines.join(end) : lines.map((line, at) => at < lines.length - 1 ? line + (others.get(at) ?? end) : line).join("");
	return mark ? MARK + body : body;
}
export { linesOf, textOf };
