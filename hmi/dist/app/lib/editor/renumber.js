// src/lib/editor/renumber.ts
/** Numbers the blocks of a program anew, and follows with the GOTOs that name them. Comments, program numbers, empty
lines and lines of `%` get none. */
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
	return lines.map((line, index) => {
		if (!wants[index]) return line;
		const number = next;
		next += step;
		const [, skip = "", rest = ""] = /^(\s*(?:\/\d?\s*)?)(?:N\s*\d+\s*)?(.*)$/i.exec(line) ?? [];
		return `${skip}N${number} ${follow(rest, numbers)}`;
	});
}
/** Jumps of a block. */
function follow(block, numbers) {
	return block.replace(/\b(GOTO\s*)(\d+)/gi, (all, word, number) => {
		const now = numbers.get(Number(number));
		return now === void 0 ? all : `${word}${now}`;
	});
}
export { renumber };
