// src/lib/graphics/path.ts
var HEAD = 64;
/** What is thrown for bytes that are none; nobody reads it. */
var NO_PATH = "FCP1";
/** Reads a path; the arrays are views of the buffer. Throws where it is none. */
function readPath(buffer) {
	const view = new DataView(buffer);
	if (buffer.byteLength < HEAD || view.getUint32(0, true) !== 827343686) throw new Error(NO_PATH);
	const count = view.getUint32(4, true);
	const flags = view.getUint32(8, true);
	if (buffer.byteLength < HEAD + count * 21) throw new Error(NO_PATH);
	const box = Array.from({ length: 6 }, (_, at) => view.getFloat64(16 + at * 8, true));
	let at = HEAD;
	const points = new Float32Array(buffer, at, 3 * count);
	at += 12 * count;
	const times = new Float32Array(buffer, at, count);
	at += 4 * count;
	const lines = new Uint32Array(buffer, at, count);
	at += 4 * count;
	const kinds = new Uint8Array(buffer, at, count);
	return {
		count,
		alarm: (flags & 1) !== 0,
		short: (flags & 2) !== 0,
		box: {
			low: [
				box[0],
				box[1],
				box[2]
			],
			high: [
				box[3],
				box[4],
				box[5]
			]
		},
		points,
		times,
		lines,
		kinds
	};
}
/** The segments of a path as pairs of points, with so many points left out between two: for the eye of somebody who
turns it. Ends of rapids and jumps stay. */
function segments(path, every) {
	const { count, kinds } = path;
	const pairs = new Uint32Array(2 * Math.max(0, count - 1));
	let used = 0;
	let last = 0;
	for (let at = 1; at < count; at++) {
		const kind = kinds[at];
		if (kind === 0) {
			last = at;
			continue;
		}
		if ((at + 1 < count ? kinds[at + 1] : 0) !== kind || at - last >= every) {
			pairs[used++] = last;
			pairs[used++] = at;
			last = at;
		}
	}
	return pairs.slice(0, used);
}
/** The last point that is reached at a time. */
function at(path, time) {
	let low = 0;
	let high = path.count - 1;
	while (low < high) {
		const middle = low + high + 1 >> 1;
		if ((path.times[middle] ?? 0) <= time) low = middle;
		else high = middle - 1;
	}
	return low;
}
/** The height at which the most is cut, in level lines and arcs; null where nothing is. */
function busiest({ points, kinds, count }) {
	/** Heights that are told apart, mm. */
	const STEP = .01;
	const cut = /* @__PURE__ */ new Map();
	let best = null;
	for (let at = 1; at < count; at++) {
		if (kinds[at] < 2) continue;
		const [a, b] = [3 * (at - 1), 3 * at];
		const level = Math.round(points[b + 2] / STEP);
		if (level !== Math.round(points[a + 2] / STEP)) continue;
		const now = (cut.get(level) ?? 0) + Math.hypot(points[b] - points[a], points[b + 1] - points[a + 1]);
		cut.set(level, now);
		if (best === null || now > cut.get(best)) best = level;
	}
	return best === null ? null : best * STEP;
}
/** How far ahead of the last place the tool is looked for before the whole path is. */
var AHEAD = 4e3;
/** The point whose segment the tool is on: of those of the line being run the nearest one, ahead of where it was. */
function follow(path, line, tool, from) {
	let best = -1;
	let least = Infinity;
	const look = (first, last) => {
		for (let index = Math.max(1, first); index < Math.min(last, path.count); index++) {
			if (path.lines[index] !== line || path.kinds[index] === 0) continue;
			const distance = toSegment(path.points, index, tool);
			if (distance < least - 1e-4) {
				least = distance;
				best = index;
			}
		}
	};
	look(from, from + AHEAD);
	if (best < 0) look(1, path.count);
	return best < 0 ? from : best;
}
function toSegment(points, index, tool) {
	let along = 0;
	let length = 0;
	const a = 3 * (index - 1);
	const b = 3 * index;
	for (let axis = 0; axis < 3; axis++) {
		const way = points[b + axis] - points[a + axis];
		along += way * (tool[axis] - points[a + axis]);
		length += way * way;
	}
	const part = length === 0 ? 0 : Math.max(0, Math.min(1, along / length));
	let sum = 0;
	for (let axis = 0; axis < 3; axis++) {
		const place = points[a + axis] + part * (points[b + axis] - points[a + axis]);
		sum += (tool[axis] - place) ** 2;
	}
	return Math.sqrt(sum);
}
/** mm of a px of the page (CSS: 96 of them are an inch). */
var MM = 25.4 / 96;
/** mm that the shorter side of a drawing shows so that a whole box is seen from every side. */
var spanOf = ({ low, high }) => Math.max(1, Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2])) * 1.15;
/** The middle of a box, mm. */
var middle = ({ low, high }) => [
	(low[0] + high[0]) / 2,
	(low[1] + high[1]) / 2,
	(low[2] + high[2]) / 2
];
export { MM, at, busiest, follow, middle, readPath, segments, spanOf };
