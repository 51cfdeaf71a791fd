// src/lib/editor/renumber.ts
/** Numbers the blocks of a program anew, and follows with the jumps that name them. Comments, program numbers, empty
lines and lines of `%` get none. Jumps whose target is computed stay as they are, and are counted. */
function renumber(lines, first, step) {
	const numbers = /* @__PURE__ */ new Map();
	let next = first;
	const bare = (line) => line.replace(/\([^)]*\)/g, "").trim();
	const wants = lines.map((line) => {
		const body = bare(line);
		return body !== "" && !body.startsWith("%") && !/^[O:;]/i.test(body);
	});
	lines.forEach((line, index) => {
		if (!wants[index]) return;
		const old = /^(\s*\/?\d?\s*)N\s*(\d+)/i.exec(line);
		if (old && !numbers.has(Number(old[2]))) numbers.set(Number(old[2]), next);
		next += step;
	});
	next = first;
	let computed = 0;
	return {
		lines: lines.map((line, index) => {
			if (!wants[index]) return line;
			const number = next;
			next += step;
			const [, skip = "", rest = ""] = /^(\s*(?:\/\d?\s*)?)(?:N\s*\d+\s*)?(.*)$/i.exec(line) ?? [];
			const followed = follow(rest, numbers);
			computed += followed.computed;
			return `${skip}N${number} ${followed.block}`;
		}),
		computed
	};
}
/** What is no code: it stays as it is. */
var REMARK = /\([^)]*\)|;.*$/g;
/** `GOTO 10`, and `$GOTO N10` of the Fagor; or what is computed. */
var GOTO = /\([^)]*\)|;.*$|(\bGOTO\s*(?:N\s*)?)(\d+|[^\s\d])/gi;
/** The target of a jump of macro A. */
var TARGET = /\([^)]*\)|;.*$|((?<![A-Z])P\s*)(\d+|[^\s\d])/gi;
/** Whether a block is a jump of macro A: G65 H80 to H86 (GSK990MC 4.9.4). */
function jumpsByMacro(block) {
	const code = block.replace(REMARK, " ");
	return /(?<![A-Z])G\s*0*65(?![\d.])/i.test(code) && /(?<![A-Z])H\s*0*8[0-6](?!\d)/i.test(code);
}
/** A block whose jumps name the new numbers, and how many jumps are computed. */
function follow(block, numbers) {
	let computed = 0;
	const put = (all, word, target) => {
		if (word === void 0) return all;
		if (!/\d/.test(target)) {
			computed++;
			return all;
		}
		const now = numbers.get(Number(target));
		return now === void 0 ? all : `${word}${now}`;
	};
	return {
		block: block.replace(jumpsByMacro(block) ? TARGET : GOTO, put),
		computed
	};
}
export { renumber };
