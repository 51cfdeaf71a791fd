// src/lib/ladder/ladder.ts
var BASIC = /* @__PURE__ */ new Set([
	"RD",
	"RD.NOT",
	"AND",
	"AND.NOT",
	"OR",
	"OR.NOT",
	"RD.STK",
	"RD.NOT.STK",
	"AND.STK",
	"OR.STK",
	"WRT",
	"WRT.NOT",
	"SET",
	"RST"
]);
var FUNCTIONS = new Set("END1 END2 TMR DEC CTR ROT COD MOVE COM JMP PARI DCNV COMP COIN DSCH XMOV ADD SUB MUL DIV NUME TMRB DECB ROTB CODB COME JMPE DCNVB COMPB SFT DSCHB XMOVB ADDB SUBB MULB DIVB NUMEB MOVB MOVW MOVN MOVD TMRC CTRC DIFU DIFD EOR AND OR NOT END CALL CALLU JMPB LBL NOP SP SPE JMPC".split(" "));
function linesOf(text) {
	return text.split("\n").map((whole, index) => {
		const at = whole.indexOf(";");
		return {
			words: (at < 0 ? whole : whole.slice(0, at)).trim().split(/\s+/).filter(Boolean),
			comment: at < 0 ? "" : whole.slice(at + 1).trim(),
			number: index + 1
		};
	});
}
function join(kind, a, b) {
	const parts = (node) => node.kind === kind ? node.parts : [node];
	return {
		kind,
		parts: [...parts(a), ...parts(b)]
	};
}
/** What a ladder says of itself: the first words of the remark that it begins with; empty where there is none. */
function headOf(text) {
	for (const { words, comment } of linesOf(text)) {
		if (words.length) return "";
		if (comment) return comment;
	}
	return "";
}
/** Reads a ladder; `meanings` of signals take the place of its own remarks. What it cannot make sense of it leaves out: the control checks ladders, not the drawing. */
function readLadder(text, meanings = /* @__PURE__ */ new Map()) {
	const symbols = /* @__PURE__ */ new Map();
	const rungs = [];
	let stack = [];
	let rung = null;
	let index = 0;
	let comment = "";
	const lines = linesOf(text);
	for (const { words, comment: remark } of lines) if (words[1] === "=" && words[0] && words[2]) symbols.set(words[0], {
		address: words[2],
		meaning: meanings.get(words[0]) || remark
	});
	const meaning = (name) => symbols.get(name)?.meaning ?? "";
	const contact = (name, not) => ({
		kind: "contact",
		name,
		not,
		index,
		meaning: meaning(name)
	});
	const finish = () => {
		if (rung && rung.outputs.length) rungs.push({
			...rung,
			conditions: rung.conditions.length ? rung.conditions : stack
		});
		rung = null;
		stack = [];
	};
	const current = (line) => {
		rung ??= {
			conditions: [],
			outputs: [],
			comment,
			line
		};
		comment = "";
		return rung;
	};
	for (const { words, comment: remark, number } of lines) {
		const [first = "", operand = ""] = words;
		if (!first) {
			const words = remark.replace(/[-=*]{4,}/g, "").trim();
			if (words) comment = comment ? `${comment} ${words}` : words;
			else if (!remark) comment = "";
			continue;
		}
		if (words[1] === "=") {
			comment = "";
			continue;
		}
		const code = first.toUpperCase();
		const isFunction = FUNCTIONS.has(code) && !(BASIC.has(code) && !/^\d/.test(operand)) || code === "SUB" && /^\d/.test(operand);
		if (!BASIC.has(code) && !isFunction) {
			const last = rung?.outputs.at(-1);
			if (last?.kind === "function") last.text += ` ${words.filter((word) => word.toUpperCase() !== "PRM").join(" ")}`;
			continue;
		}
		if (isFunction) {
			const into = current(number);
			into.conditions = [...stack];
			into.outputs.push({
				kind: "function",
				text: words.join(" "),
				name: code,
				not: false,
				index,
				meaning: remark
			});
		} else if (code === "RD" || code === "RD.NOT") {
			finish();
			const into = current(number);
			if (remark) into.comment ||= remark;
			stack = [contact(operand, code === "RD.NOT")];
		} else if (code === "RD.STK" || code === "RD.NOT.STK") stack.push(contact(operand, code === "RD.NOT.STK"));
		else if (code.startsWith("WRT") || code === "SET" || code === "RST") {
			const into = current(number);
			if (!into.conditions.length) into.conditions = [...stack];
			const text = code === "SET" ? "S" : code === "RST" ? "R" : "";
			into.outputs.push({
				kind: "coil",
				text,
				name: operand,
				not: code === "WRT.NOT",
				index,
				meaning: meaning(operand)
			});
		} else {
			const top = stack.pop();
			if (code === "AND.STK" || code === "OR.STK") {
				const below = stack.pop();
				if (top && below) stack.push(code === "AND.STK" ? join("series", below, top) : {
					kind: "parallel",
					parts: [below, top],
					index
				});
				else if (top) stack.push(top);
			} else {
				const one = contact(operand, code.endsWith(".NOT"));
				if (!top) stack.push(one);
				else if (code.startsWith("AND")) stack.push(join("series", top, one));
				else if (top.kind === "parallel" && top.parts.every((part) => part.kind === "contact")) stack.push({
					kind: "parallel",
					parts: [...top.parts, one],
					index
				});
				else stack.push({
					kind: "parallel",
					parts: [top, one],
					index
				});
			}
		}
		index++;
	}
	finish();
	return {
		rungs,
		symbols,
		instructions: index
	};
}
/** All signals that a rung names. */
function signalsOf(rung) {
	const names = /* @__PURE__ */ new Set();
	const visit = (node) => {
		if (node.kind === "contact") names.add(node.name);
		else node.parts.forEach(visit);
	};
	rung.conditions.forEach(visit);
	for (const output of rung.outputs) if (output.kind === "coil") names.add(output.name);
	return [...names];
}
export { headOf, readLadder, signalsOf };
