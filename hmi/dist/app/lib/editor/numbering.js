// src/lib/editor/numbering.ts
/** Largest sequence number. */
var LARGEST = 99999;
/** How many lines are looked back for a number. */
var MOST = 1e4;
/** The number of a block. */
var NUMBER = /^\s*\/*\s*N(\d+)/i;
/** What a line begins with that is typed behind the line `behind`, from 1; empty where it gets no number. `at` has the
text of a line; `rest` is what is taken over from the line before. */
function numberBehind(at, behind, step, rest = "") {
	if (step <= 0 || NUMBER.test(rest)) return "";
	for (let line = behind; line >= 1 && line > behind - MOST; line--) {
		const found = NUMBER.exec(at(line) ?? "");
		if (!found) continue;
		const next = Number(found[1]) + step;
		return next > LARGEST ? "" : `N${next} `;
	}
	return `N${step} `;
}
export { numberBehind };
