// src/pages/diagnosis/addresses.ts
/** First bytes and numbers of bytes. */
var ROOMS = {
	X: [[0, 128]],
	Y: [[0, 128]],
	F: [[0, 768]],
	G: [[0, 768]],
	R: [[0, 8e3], [9e3, 118]],
	K: [[0, 100]],
	T: [[0, 500]],
	C: [[0, 400]],
	D: [[0, 1e4]],
	A: [[0, 250]]
};
var AREAS = Object.keys(ROOMS);
/** Addresses of all bytes of an area. */
function bytesOf(area) {
	return ROOMS[area].flatMap(([first, count]) => Array.from({ length: count }, (_, index) => `${area}${first + index}`));
}
/** A byte or a bit as the control calls it: `x0020.3` is X20.3. Null where there is none. */
function addressOf(text) {
	const match = /^([XYFGRKTCDA])0*(\d{1,5})(?:\.([0-7]))?$/.exec(text.trim().toUpperCase());
	if (!match) return null;
	const byte = Number(match[2]);
	return ROOMS[match[1]].some(([first, count]) => byte >= first && byte < first + count) ? `${match[1]}${byte}${match[3] ? `.${match[3]}` : ""}` : null;
}
export { AREAS, addressOf, bytesOf };
