import { circle, number, outline, rectangle, turned, word } from "./geometry.js";
import { angle, coordinates, isBoss, isHole, measure, span, toward } from "./items.js";
import { figure } from "./rows.js";
// src/lib/cycles/plan.ts
var MIDDLE = ["XC", "YC"];
var ENTRY = ["X1", "Y1"];
var POINT = ["X", "Y"];
/** The fields of a cycle's point. */
function origin(of) {
	const found = [
		MIDDLE,
		ENTRY,
		POINT
	].find(([x]) => of.has(x));
	return found ? [...found] : null;
}
/** The diameter of a hole, mm. */
function holeDiameter(of) {
	return number(of.values, "phi", of.tool);
}
var isRectangle = (of) => of.has("L") && of.has("H");
/** A rectangle as if it were neither turned nor had corners. */
var flat = (of) => rectangle({
	...of.values,
	corner: "sharp",
	alpha: 0
});
function center(points) {
	const xs = points.map((p) => p[0]);
	const ys = points.map((p) => p[1]);
	return [(Math.min(...xs) + Math.max(...xs)) / 2, (Math.min(...ys) + Math.max(...ys)) / 2];
}
/** The point outside a rectangle or circle by a distance, in the middle of the side that looks in a direction. */
function outside(of, at, degrees, by) {
	if (!isRectangle(of)) return toward(at, degrees, number(of.values, "R") + by);
	const [one, , other] = flat(of);
	const half = Math.abs(degrees % 180 === 0 ? other[0] - one[0] : other[1] - one[1]) / 2;
	return turned(toward(center([one, other]), degrees, half + by), at, number(of.values, "alpha"));
}
/** A rectangle, larger all round. */
function grown(of, at, by) {
	const [one, , other] = flat(of);
	const [a, b] = [Math.min(one[0], other[0]) - by, Math.max(one[0], other[0]) + by];
	const [c, d] = [Math.min(one[1], other[1]) - by, Math.max(one[1], other[1]) + by];
	return [
		[a, c],
		[b, c],
		[b, d],
		[a, d],
		[a, c]
	].map((p) => turned(p, at, number(of.values, "alpha")));
}
/** The shape of a cycle's own; profiles have none. */
function shape(of, at) {
	if (isRectangle(of)) return rectangle(of.values);
	if (of.has("R")) return circle(at, number(of.values, "R"));
	return isHole(of) ? circle(at, holeDiameter(of) / 2) : null;
}
function rectangleMarks(of, at) {
	const v = of.values;
	const turn = (p) => turned(p, at, number(v, "alpha"));
	const [a, b, c, d] = flat(of);
	const size = span([a, c]);
	const aside = size * .1;
	const items = [measure("L", turn(a), turn(b), -aside), measure("H", turn(b), turn(c), -aside)];
	if (of.has("alpha")) items.push(angle("alpha", at, 0, number(v, "alpha"), size * .3));
	if (of.has("r")) {
		const along = Math.sign(c[0] - d[0]) * number(v, "r");
		items.push(measure("r", turn(d), turn([d[0] + along, d[1]]), aside * .5));
	}
	return items;
}
function circleMarks(of, at) {
	const items = [measure("R", at, toward(at, 0, number(of.values, "R")))];
	if (of.has("r")) {
		const emptied = number(of.values, "r");
		items.push({
			kind: "line",
			points: circle(at, emptied),
			look: "stock",
			field: "r"
		});
		items.push(measure("r", at, toward(at, -90, emptied)));
	}
	return items;
}
/** A measure between two radii about a point. */
function spoke(field, at, degrees, from, to) {
	return measure(field, toward(at, degrees, from), toward(at, degrees, to));
}
/** A thread between its crest and its root (4.7). */
function threadMarks(of, at) {
	const v = of.values;
	const outer = holeDiameter(of) / 2;
	const inner = Math.max(0, outer - number(v, "K"));
	const [crest, root, into] = word(v, "side", "internal") === "internal" ? [
		inner,
		outer,
		1
	] : [
		outer,
		inner,
		-1
	];
	return [
		{
			kind: "line",
			points: circle(at, inner),
			look: "stock",
			field: "K"
		},
		spoke("K", at, 0, inner, outer),
		spoke("step", at, 60, crest, crest + into * number(v, "step")),
		spoke("delta", at, 120, root, root - into * number(v, "delta")),
		spoke("DS", at, 210, root, root - into * number(v, "DS")),
		angle("alpha", at, 0, number(v, "alpha"), outer)
	];
}
function holeMarks(of, at) {
	const v = of.values;
	const radius = holeDiameter(of) / 2;
	const items = [];
	const across = (field, half, aside) => measure(field, [at[0] - half, at[1]], [at[0] + half, at[1]], aside);
	if (of.has("phi")) items.push(across("phi", radius, -radius * 1.3));
	if (of.has("phiK")) {
		const drilled = number(v, "phiK") / 2;
		items.push({
			kind: "line",
			points: circle(at, drilled),
			look: "stock",
			field: "phiK"
		}, across("phiK", drilled, 0));
	}
	if (of.has("K")) items.push(...threadMarks(of, at));
	if (of.has("beta")) items.push(angle("beta", at, 0, number(v, "beta"), radius * .8));
	if (of.has("dx")) {
		const corner = [at[0] + number(v, "dx"), at[1]];
		items.push(measure("dx", at, corner, of.tool * .2));
		items.push(measure("dy", corner, [corner[0], at[1] + number(v, "dy")], of.tool * .2));
	}
	return items;
}
/** The side beyond which the tool runs on a face, or over which it comes into a slot; degrees (4.19, 4.22). */
var OPEN = {
	bidir_y: 90,
	unidir_y: 90,
	spiral_y: 90,
	through_y: 90,
	corner_ll: 180,
	corner_ul: 180
};
function overrun(of, at) {
	const degrees = OPEN[word(of.values, "strategy") || word(of.values, "kind")] ?? 0;
	const edge = outside(of, at, degrees, 0);
	return measure("rough.E", edge, outside(of, at, degrees, number(of.values, "rough.E")), -of.tool);
}
/** A way into a profile or out of it: the circle that touches the profile at its end, on the side of a point (4.20). */
function tangent(field, of, end, before, beside) {
	const radius = number(of.values, field);
	const along = Math.atan2(end[1] - before[1], end[0] - before[0]) * 180 / Math.PI;
	const left = toward([0, 0], along + 90, 1);
	const side = left[0] * (beside[0] - end[0]) + left[1] * (beside[1] - end[1]) < 0 ? -90 : 90;
	const middle = toward(end, along + side, radius);
	return [{
		kind: "line",
		points: circle(middle, radius),
		look: "stock",
		field
	}, measure(field, middle, end)];
}
function wayMarks(of, at, profile, aside) {
	const v = of.values;
	const [first, last] = [profile[0] ?? at, profile.at(-1) ?? at];
	const exit = [number(v, "XN", last[0]), number(v, "YN", last[1])];
	return [
		...tangent("R1", of, first, profile[1] ?? first, at),
		...tangent("RN", of, last, profile.at(-2) ?? last, exit),
		{
			kind: "mark",
			field: "XN",
			at: exit
		},
		...coordinates(["XN", "YN"], exit, aside)
	];
}
function areas(of, at, shapes) {
	if (isBoss(of)) {
		const around = number(of.values, "Q");
		return [{
			kind: "area",
			points: isRectangle(of) ? grown(of, at, around) : circle(at, number(of.values, "R") + around),
			look: "cut"
		}, {
			kind: "area",
			points: shapes[0],
			look: "material"
		}];
	}
	if (of.form.profile === "points" || of.form.profile === "path") return [];
	return shapes.map((points, i) => ({
		kind: "area",
		points,
		look: i > 0 ? "material" : "cut"
	}));
}
/** Widths of passes, those of each stage beside the other's; 0 is 3/4 of the tool (4.11). */
function passes(of, from, room) {
	if (isHole(of)) return [];
	return [
		"step",
		"rough.step",
		"finish.step"
	].filter(of.has).map((field) => {
		const wide = number(of.values, field) || of.tool * .75;
		return measure(field, from, [from[0] + wide, from[1]], room * (field === "finish.step" ? -.06 : .06));
	});
}
function plan(of) {
	const v = of.values;
	const fields = origin(of);
	const at = fields ? [number(v, fields[0]), number(v, fields[1])] : [0, 0];
	const contours = (of.request.profile?.contours ?? []).map(outline).filter((points) => points.length > 1);
	const own = shape(of, at);
	const shapes = own ? [own, ...contours] : contours;
	const room = shapes.length ? span(shapes.flat()) : 20;
	const positions = figure(of.request.positions[0], at, room);
	const items = areas(of, at, shapes);
	for (const points of shapes) items.push({
		kind: "line",
		points,
		look: "part"
	});
	for (const [x, y] of positions.points.slice(1)) for (const one of shapes) items.push({
		kind: "line",
		points: one.map((p) => [p[0] + x - at[0], p[1] + y - at[1]]),
		look: "row"
	});
	if (isRectangle(of)) items.push(...rectangleMarks(of, at));
	if (of.has("R")) items.push(...circleMarks(of, at));
	if (isHole(of)) items.push(...holeMarks(of, at));
	if (of.has("Q")) items.push(measure("Q", outside(of, at, 180, 0), outside(of, at, 180, number(v, "Q"))));
	if (of.has("rough.E")) items.push(overrun(of, at));
	if (of.has("R1")) items.push(...wayMarks(of, at, contours[0] ?? [], room * .04));
	items.push(...passes(of, isBoss(of) ? outside(of, at, 0, 0) : center(shapes[0] ?? [at]), room));
	items.push(...positions.marks);
	if (fields) items.push({
		kind: "mark",
		field: fields[0],
		at
	}, ...coordinates(fields, at, room * .04));
	return items;
}
export { holeDiameter, plan };
