// src/pages/help/calculate.ts
function tokens(text) {
	const found = [];
	const pattern = /\s*(?:(\d+(?:[.,]\d*)?|[.,]\d+)|([a-zπ√]+)|([-+*/^()×÷−]))/giy;
	let at = 0;
	while (at < text.trimEnd().length) {
		pattern.lastIndex = at;
		const match = pattern.exec(text);
		if (!match) return null;
		at = pattern.lastIndex;
		if (match[1] !== void 0) found.push({
			kind: "number",
			value: Number(match[1].replace(",", "."))
		});
		else if (match[2] !== void 0) found.push({
			kind: "name",
			text: match[2].toLowerCase()
		});
		else found.push({
			kind: "sign",
			text: match[3].replace("×", "*").replace("÷", "/").replace("−", "-")
		});
	}
	return found;
}
var rad = Math.PI / 180;
var functions = {
	sin: (value) => Math.sin(value * rad),
	cos: (value) => Math.cos(value * rad),
	tan: (value) => Math.tan(value * rad),
	asin: (value) => Math.asin(value) / rad,
	acos: (value) => Math.acos(value) / rad,
	atan: (value) => Math.atan(value) / rad,
	sqrt: Math.sqrt,
	"√": Math.sqrt,
	abs: Math.abs
};
/** Brackets and signs within each other, at most. */
var DEEPEST = 64;
/** The value of a sum; null where it has none. */
function calculate(text) {
	const all = tokens(text);
	if (!all || all.length === 0) return null;
	let at = 0;
	let deep = 0;
	const sign = () => {
		const token = all[at];
		return token?.kind === "sign" ? token.text : "";
	};
	const sum = () => {
		let value = product();
		for (let next = sign(); next === "+" || next === "-"; next = sign()) {
			at++;
			value = next === "+" ? value + product() : value - product();
		}
		return value;
	};
	const product = () => {
		let value = power();
		for (let next = sign(); next === "*" || next === "/"; next = sign()) {
			at++;
			value = next === "*" ? value * power() : value / power();
		}
		return value;
	};
	const power = () => {
		if (++deep > DEEPEST) return NaN;
		let value;
		if (sign() === "-" || sign() === "+") {
			const minus = sign() === "-";
			at++;
			value = power();
			if (minus) value = -value;
		} else {
			value = one();
			if (sign() === "^") {
				at++;
				value **= power();
			}
		}
		deep--;
		return value;
	};
	const one = () => {
		const token = all[at++];
		if (token?.kind === "number") return token.value;
		if (token?.kind === "name") {
			if (token.text === "pi" || token.text === "π") return Math.PI;
			const call = functions[token.text];
			return call ? call(one()) : NaN;
		}
		if (token?.text === "(") {
			if (++deep > DEEPEST) return NaN;
			const value = sum();
			deep--;
			if (sign() !== ")") return NaN;
			at++;
			return value;
		}
		return NaN;
	};
	const value = sum();
	return at === all.length && Number.isFinite(value) ? value : null;
}
export { calculate };
