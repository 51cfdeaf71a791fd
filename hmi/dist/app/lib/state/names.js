// src/lib/state/names.ts
/** Characters that any other name has at most. */
var LONGEST = 64;
var numberedName = (digits) => `O${digits.replace(/^0+(?=\d{4})/, "").padStart(4, "0")}`;
/** The name that was typed, or why it is none. */
function typedName(text) {
	const clean = text.trim();
	const digits = /^O?(\d+)$/i.exec(clean)?.[1];
	if (digits !== void 0) {
		const name = numberedName(digits);
		return name.length <= 9 ? { name } : { wrong: "digits" };
	}
	return /^[\p{L}\p{N}_-]+$/u.test(clean) && clean.length <= LONGEST ? { name: clean } : { wrong: "signs" };
}
/** The name under which a file is stored: `O` and a number where it has one, such as `O12.nc`. */
function programName(file, text) {
	const inside = /^\s*%?\s*[O:](\d{1,8})(?!\d)/i.exec(text)?.[1];
	const outside = /^O?(\d{1,8})(\.\w+)?$/i.exec(file)?.[1];
	const number = inside ?? outside;
	return number ? numberedName(number) : file.replace(/\.[^.]*$/, "");
}
/** What a new program begins with. A name that is no O number is no word of a program. */
function begun(name) {
	return `${/^O\d+$/.test(name) ? `${name}\n` : ""}\nM30\n`;
}
/** The text of a program under another name: an O number at its start follows. */
function numbered(text, name) {
	const number = /^O(\d+)$/.exec(name)?.[1];
	return number === void 0 ? text : text.replace(/^(\ufeff?\s*%?\s*[O:])\d{1,8}/i, (_, head) => head + number);
}
export { begun, numbered, programName, typedName };
