// src/lib/numbers.ts
/** A measure with so many digits behind the point. What rounds to zero has no sign. */
function fixed(value, digits = 3) {
	if (value === null || value === void 0 || !Number.isFinite(value)) return "–";
	const text = Math.abs(value).toFixed(digits);
	return value < 0 && Number(text) !== 0 ? `−${text}` : text;
}
/** A factor in per cent, without the sign. */
function percent(factor) {
	return Math.round(factor * 100).toString();
}
/** Seconds as hours, minutes and seconds. */
function duration(seconds) {
	const whole = Math.max(0, Math.floor(seconds));
	const two = (value) => value.toString().padStart(2, "0");
	return `${two(Math.floor(whole / 3600))}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}`;
}
/** Bytes in the unit that gives up to four digits. */
function bytes(count) {
	if (count < 1e4) return `${count} B`;
	if (count < 1e7) return `${(count / 1024).toFixed(0)} KiB`;
	if (count < 1e10) return `${(count / 1024 / 1024).toFixed(1)} MiB`;
	return `${(count / 1024 ** 3).toFixed(1)} GiB`;
}
/** A number as a person types it: with point or comma, with either minus. Null where it is none. */
function typed(text) {
	const clean = text.trim().replace("−", "-").replace(",", ".");
	if (!/^[+-]?(\d+\.?\d*|\.\d+)$/.test(clean)) return null;
	return Number(clean);
}
/** Positions lie within it, mm and degrees (GSK990MC part 1, 1.2); zeros and relative coordinates beyond it are refused. */
var PLACE = 99999.999;
/** The range of a value, as it stands under a field. Empty where there is none. */
function rangeText(minimum, maximum) {
	const [low, high] = [minimum, maximum].map((value) => String(value).replace("-", "−"));
	if (minimum === -Infinity) return maximum === Infinity ? "" : `≤ ${high}`;
	return maximum === Infinity ? `≥ ${low}` : `${low} … ${high}`;
}
/** The value behind the letter of an axis, as `X`, `X10` or `x-2,5`: without digits it is 0. Null where it is no such text. */
function behindLetter(text, letter) {
	const clean = text.trim();
	if (clean.slice(0, letter.length).toUpperCase() !== letter.toUpperCase()) return null;
	const value = clean.slice(letter.length).trim();
	return value === "" ? 0 : typed(value);
}
/** The work coordinate system that `G56`, `P6` or `54` (one of the first six by its number) asks for. Null where it is none. */
function systemNamed(text) {
	const match = /^(?:G?\s*(5[4-9])|(?:G?\s*54\s*)?P\s*0*([1-9]\d?))$/i.exec(text.trim());
	if (!match) return null;
	if (match[1]) return `G${match[1]}`;
	return Number(match[2]) <= 50 ? `G54 P${Number(match[2])}` : null;
}
/** The number of a row, alone or behind one of the letters: `12`, `H12`, `#500`. Null where it is none from `low` to `high`. */
function numberNamed(text, letters, low, high) {
	const match = /^([^\d\s]?)\s*(\d{1,9})$/.exec(text.trim().toUpperCase());
	if (!match || !letters.includes(match[1])) return null;
	const number = Number(match[2]);
	return number >= low && number <= high ? number : null;
}
/** The first number of the page that has a number, where pages of so many begin at `from`. */
function firstOfPage(number, from, page) {
	return number - (number - from) % page;
}
/** Whether two names mean one program: O1 is O0001, and letters are large or small. */
function isSameProgram(one, other) {
	const plain = (name) => name.toUpperCase().replace(/^O0*(?=\d+$)/, "O");
	return plain(one) === plain(other);
}
export { PLACE, behindLetter, bytes, duration, firstOfPage, fixed, isSameProgram, numberNamed, percent, rangeText, systemNamed, typed };
