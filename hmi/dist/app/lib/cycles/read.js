// src/lib/cycles/read.ts
var PARTS = {
	"#CYCLE": "",
	"#DRILL": "drill.",
	"#ROUGH": "rough.",
	"#SEMI": "semi.",
	"#FINISH": "finish."
};
var head = (line) => /^#[A-Z]+/.exec(line)?.[0] ?? "";
/** What a remark says; null where a line is none. */
function remark(line) {
	const found = /^\s*(?:\((.*)\)|'(.*))\s*$/.exec(line);
	return found ? (found[1] ?? found[2] ?? "").trim() : null;
}
/** The cycle in which a line is, from 1; null where it is in none. */
function cycleAt(lines, line) {
	for (let at = 0; at < lines.length && at < line; at++) {
		const found = own(lines, at) ?? told(lines, at);
		if (!found) continue;
		if (line <= found.to) return found;
		at = found.to - 1;
	}
	return null;
}
/** A cycle of the control that begins at a line, counted from 0. */
function own(lines, first) {
	const block = [];
	let at = /^G17 G71 G90\s*$/.test(lines[first] ?? "") ? first + 1 : first;
	for (; head(lines[at]?.trim() ?? "") === "#PROFILE"; at++) {
		while (at < lines.length && head(lines[at].trim()) !== "#ENDPROFILE") block.push(lines[at++].trim());
		block.push("#ENDPROFILE");
	}
	if (head(lines[at]?.trim() ?? "") !== "#CYCLE") return null;
	do
		block.push(lines[at++].trim());
	while ([
		"#DRILL",
		"#ROUGH",
		"#SEMI",
		"#FINISH",
		"#MULTI"
	].includes(head(lines[at]?.trim() ?? "")));
	const request = readBlock(block);
	return request && {
		from: first + 1,
		to: at,
		request
	};
}
/** One that was written in another way, with the block in remarks above it. */
function told(lines, first) {
	const title = remark(lines[first] ?? "");
	if (title === null || !/^[GP]\w+ /.test(title)) return null;
	const block = [];
	let at = first + 1;
	for (let text = remark(lines[at] ?? ""); text !== null; text = remark(lines[++at] ?? "")) block.push(text);
	const request = block.length > 0 ? readBlock(block) : null;
	if (!request) return null;
	const end = lines.findIndex((line, index) => index >= at && remark(line) === `END ${request.cycle}`);
	return end < 0 ? null : {
		from: first + 1,
		to: end + 1,
		request
	};
}
/** `A=1, P2=[3, 4]` as names with what stands behind them. */
function values(inner) {
	const found = [];
	for (const [, name, value] of inner.matchAll(/([A-Za-z]\w*)\s*=\s*(\[[^\]]*\]|[^,\]]*)/g)) found.push([name, value.trim()]);
	return found;
}
var valueOf = (text) => /^[-+]?(\d+\.?\d*|\.\d+)$/.test(text) ? Number(text) : text;
var pointOf = (text) => text.slice(1, -1).split(",").map((one) => one.trim());
/** The form of a block as `#CYCLE` has it; null where it is none. */
function readBlock(block) {
	const request = {
		cycle: "",
		values: {},
		positions: [],
		profile: null,
		depths: [],
		tools: []
	};
	const profiles = [];
	const points = {
		start: [0, 0],
		elements: [],
		entry: 0,
		exit: 0
	};
	let hasPoints = false;
	for (const line of block) {
		const name = head(line);
		const inner = line.slice(line.indexOf("[") + 1);
		const prefix = PARTS[name];
		if (name === "#PROFILE") profiles.push({
			plane: /\[(\w+)\]/.exec(line)?.[1] ?? "XY",
			contours: []
		});
		else if (name === "#ENDPROFILE") continue;
		else if (name === "#MULTI") {
			const figure = {
				kind: /^#MULTI\s+(\w+)/.exec(line)?.[1] ?? "",
				values: {},
				points: []
			};
			for (const [key, value] of values(inner)) if (!value.startsWith("[")) figure.values[key] = valueOf(value);
			else figure.points.push(pointOf(value).map(Number));
			request.positions.push(figure);
		} else if (prefix !== void 0) {
			if (prefix === "") request.cycle = /^#CYCLE\s+(\w+)/.exec(line)?.[1] ?? "";
			for (const [key, value] of line.includes("[") ? values(inner) : []) {
				if (!value.startsWith("[")) {
					request.values[prefix + key] = valueOf(value);
					continue;
				}
				const [x, y, corner, size] = pointOf(value);
				const to = [Number(x), Number(y)];
				if (hasPoints) points.elements.push({
					kind: "line",
					to,
					corner: corner === "round" || corner === "chamfer" ? {
						kind: corner,
						size: Number(size)
					} : null
				});
				else points.start = to;
				hasPoints = true;
			}
		} else {
			const last = profiles.at(-1);
			if (last && !element(last, line)) return null;
		}
	}
	if (!request.cycle) return null;
	const flat = profiles.filter(({ plane }) => plane === "XY").flatMap(({ contours }) => contours);
	if (flat.length > 0) request.profile = { contours: flat };
	else if (hasPoints) request.profile = { contours: [points] };
	for (const { plane, contours } of profiles) if (plane !== "XY" && contours[0]) request.depths.push({
		plane,
		contour: contours[0]
	});
	return request;
}
/** The words of a centre, by the axes of the plane. */
var CENTRE = {
	X: "I",
	Y: "J",
	Z: "K"
};
/** A line of a profile; whether it is one. */
function element({ plane, contours }, line) {
	const code = Number(/^G(\d+)/.exec(line)?.[1] ?? NaN);
	const word = (letter) => Number(new RegExp(`${letter}([-+]?[\\d.]+)`).exec(line)?.[1] ?? 0);
	const to = [word(plane[0]), word(plane[1])];
	const contour = contours.at(-1);
	if (code === 0) contours.push({
		start: to,
		elements: [],
		entry: 0,
		exit: 0
	});
	else if (!contour) return false;
	else if (code === 37) contour.entry = word("I");
	else if (code === 38) contour.exit = word("I");
	else if (code === 36 || code === 39) {
		const before = contour.elements.at(-1);
		if (before) before.corner = {
			kind: code === 36 ? "round" : "chamfer",
			size: word("I")
		};
	} else if (code === 1) contour.elements.push({
		kind: "line",
		to,
		corner: null
	});
	else if (code === 2 || code === 3) {
		const from = contour.elements.at(-1)?.to ?? contour.start;
		const arc = {
			kind: "arc",
			to,
			center: [from[0] + word(CENTRE[plane[0]]), from[1] + word(CENTRE[plane[1]])],
			clockwise: code === 2,
			corner: null
		};
		contour.elements.push(arc);
	} else return false;
	return true;
}
export { cycleAt, readBlock };
