import { number, outline, word } from "./geometry.js";
import { angle, isBoss, isHole, measure, span, toward } from "./items.js";
import { holeDiameter } from "./plan.js";
// src/lib/cycles/section.ts
/** How close the tool comes at rapid where a form has no distance for it, mm (4.1.2). */
var NEAR = 1;
/** Drills, whose tip is a point. */
var POINTED = [
	"G281",
	"G282",
	"G283"
];
/** The place of what is the tool's, and how it moves. */
var OF_TOOL = {
	T: "shaft",
	D: "shaft",
	S: "shaft",
	FZ: "down",
	F: "along",
	t: "floor",
	KF: "out"
};
/** The width of the section: that of the shape across its middle. */
function width(of) {
	if (isHole(of)) return holeDiameter(of);
	if (of.has("L")) return Math.abs(number(of.values, "L"));
	if (of.has("R")) return 2 * number(of.values, "R");
	const points = (of.request.profile?.contours ?? []).flatMap(outline);
	return points.length ? span(points) : 40;
}
function roomOf(of) {
	const v = of.values;
	const full = Math.max(width(of), .1);
	const surface = number(v, "Z");
	const safety = number(v, "ZS", surface + 5);
	const up = safety < surface || safety === surface && number(v, "P") < 0 ? -1 : 1;
	const depth = word(v, "mode") === "angle" ? number(v, "phi") / 2 / Math.tan(number(v, "alpha", 90) * Math.PI / 360) : Math.abs(number(v, "P"));
	const tall = Math.max(depth + Math.abs(safety - surface), 2);
	const half = Math.min(full, tall * 3) / 2;
	const near = surface + up * Math.min(number(v, "DP", NEAR), Math.abs(safety - surface));
	const edge = half + Math.max(half * .7, tall * .25);
	return {
		surface,
		safety,
		floor: surface - up * depth,
		near,
		depth,
		up,
		half,
		edge
	};
}
function part(of, { surface, floor, up, half, edge, depth, safety }) {
	const walls = isBoss(of) ? [
		[-edge, floor],
		[-half, floor],
		[-half, surface],
		[half, surface],
		[half, floor],
		[edge, floor]
	] : of.form.id === "G290" ? [[-edge, floor], [edge, floor]] : of.form.id === "G281" ? [
		[-edge, surface],
		[-half, surface],
		[0, floor],
		[half, surface],
		[edge, surface]
	] : [
		[-edge, surface],
		[-half, surface],
		[-half, floor],
		[half, floor],
		[half, surface],
		[edge, surface]
	];
	const below = floor - up * Math.max(depth + Math.abs(safety - surface), 2) * .25;
	return [{
		kind: "area",
		points: [
			...walls,
			[edge, below],
			[-edge, below]
		],
		look: "material"
	}, {
		kind: "line",
		points: walls,
		look: "part"
	}];
}
function planes(of, { surface, safety, floor, near, edge }) {
	const level = (field, z, look) => ({
		kind: "line",
		points: [[-edge, z], [edge, z]],
		look,
		field
	});
	const at = edge * 1.08;
	const items = [
		level("Z", surface, "level"),
		level("ZS", safety, "safety"),
		level("DP", near, "level"),
		measure("P", [at, surface], [at, floor]),
		measure("ZS", [at, 0], [at, safety], edge * .16),
		measure("Z", [at, 0], [at, surface], edge * .3)
	];
	if (of.has("DP")) items.push(measure("DP", [-edge * .9, surface], [-edge * .9, near]));
	if (of.has("ZR")) {
		const back = number(of.values, "ZR", near);
		items.push(level("ZR", back, "safety"), measure("ZR", [at, 0], [at, back], edge * .44));
	}
	return items;
}
/** Levels of passes in depth (4.12), and for pecks how far the tool is drawn back (4.4). */
function levels(of, { surface, near, depth, up, half, edge }) {
	const v = of.values;
	const field = [
		"rough.I",
		"rough.I1",
		"I"
	].find(of.has);
	if (!field) return [];
	const items = [];
	const boss = isBoss(of);
	const open = boss || of.form.id === "G290";
	const longest = of.request.tools[0]?.cutting_length ?? 0;
	const wanted = Math.abs(number(v, field)) || longest || depth;
	const reach = Math.max(0, depth - number(v, "finish.deltaz"));
	const count = Math.min(60, Math.max(1, Math.ceil(reach / Math.max(wanted, .001) - 1e-9)));
	const each = number(v, field) < 0 || isHole(of) ? wanted : reach / count;
	for (let i = 1; i < count; i += 1) {
		const z = surface - up * Math.min(reach, each * i);
		const inside = open ? [[-edge, z], [boss ? -half : edge, z]] : [[-half, z], [half, z]];
		items.push({
			kind: "line",
			points: inside,
			look: "level",
			field
		});
	}
	const first = surface - up * Math.min(each, reach);
	const x = open ? -edge * .8 : -half * .55;
	items.push(measure(field, [x, surface], [x, first]));
	if (of.has("semi.I2")) {
		const semi = surface - up * Math.min(Math.abs(number(v, "semi.I2")), depth);
		items.push({
			kind: "line",
			points: [[half * .7, semi], [half, semi]],
			look: "level",
			field: "semi.I2"
		});
		items.push(measure("semi.I2", [half * .8, surface], [half * .8, semi]));
	}
	if (of.form.id === "G283") {
		const back = number(v, "B") > 0 ? first + up * number(v, "B") : near;
		items.push(measure("B", [half * .55, first], [half * .55, back]));
	}
	return items;
}
/** Stock on floor and wall, and the passes along the wall. */
function stock(of, { surface, floor, depth, up, half, edge }) {
	const v = of.values;
	const items = [];
	const into = isBoss(of) ? 1 : -1;
	if (of.has("finish.deltaz")) {
		const z = floor + up * number(v, "finish.deltaz");
		items.push({
			kind: "line",
			points: [[-half, z], [half, z]],
			look: "stock",
			field: "finish.deltaz"
		});
		items.push(measure("finish.deltaz", [half * .45, floor], [half * .45, z]));
	}
	const wall = ["finish.delta", "delta"].find(of.has);
	if (wall && !isHole(of)) {
		const x = -half - into * number(v, wall);
		const z = surface - up * depth * .6;
		items.push({
			kind: "line",
			points: [[x, surface], [x, floor]],
			look: "stock",
			field: wall
		});
		items.push(measure(wall, [-half, z], [x, z]));
	}
	const across = (z, field) => ({
		kind: "line",
		points: [[half - edge * .05, z], [half + edge * .05, z]],
		look: "level",
		field
	});
	if (of.has("finish.N")) {
		const count = Math.min(60, Math.max(1, Math.round(number(v, "finish.N"))));
		for (let i = 1; i <= count; i += 1) items.push(across(surface - up * depth * i / count, "finish.N"));
		items.push({
			kind: "label",
			field: "finish.N",
			at: [half + edge * .05, surface - up * depth / count / 2]
		});
	}
	if (of.has("finish.eps")) {
		const z = surface - up * number(v, "finish.eps");
		items.push(across(surface, "finish.eps"), across(z, "finish.eps"));
		items.push(measure("finish.eps", [half, surface], [half, z]));
	}
	return items;
}
/** Angles at which the tool enters: in roughing from the surface, in finishing down to the floor; 0 is straight down
*  (4.12). */
function entries(of, { surface, floor, depth, up, half }) {
	const radius = Math.min(half, depth) * .7;
	const steep = (field) => number(of.values, field) || 90;
	const items = [];
	const ramp = (field, at, flat, degrees) => {
		items.push({
			kind: "line",
			points: [at, toward(at, degrees, radius)],
			look: "level",
			field
		});
		items.push(angle(field, at, flat, degrees, radius));
	};
	if (of.has("rough.beta")) ramp("rough.beta", [0, surface], 0, -up * steep("rough.beta"));
	if (of.has("finish.theta")) ramp("finish.theta", [0, floor], 180, 180 - up * steep("finish.theta"));
	return items;
}
/** The hole that is drilled first into a pocket, with planes of its own or those of the pocket (4.15). */
function drilling(of, { surface, safety, floor, up, half }) {
	const v = of.values;
	const x = half * .8;
	const radius = half * .05;
	const top = number(v, "drill.Z", surface);
	const bottom = top - up * Math.abs(number(v, "drill.P", (surface - floor) * up));
	const near = top + up * number(v, "drill.DP", NEAR);
	const at = (aside) => x + radius * aside;
	const hole = [
		[at(-1), top],
		[at(-1), bottom],
		[at(1), bottom],
		[at(1), top]
	];
	const items = [
		measure("drill.Z", [at(-2), 0], [at(-2), top]),
		measure("drill.ZS", [at(-3), 0], [at(-3), number(v, "drill.ZS", safety)]),
		measure("drill.ZR", [at(-4), 0], [at(-4), number(v, "drill.ZR", near)]),
		measure("drill.DP", [at(2), top], [at(2), near]),
		measure("drill.P", [at(2), top], [at(2), bottom]),
		measure("drill.I", [x, top], [x, top - up * number(v, "drill.I")])
	];
	if (number(v, "drill.T") > 0) items.push({
		kind: "line",
		points: hole,
		look: "stock",
		field: "drill.P"
	});
	return items;
}
/** The tool above what it does, with what is its own. */
function tool(of, { surface, safety, floor, depth, up, half }) {
	const v = of.values;
	const radius = Math.min(of.tool / 2, half);
	const left = isBoss(of) ? -half - radius * 1.2 : 0;
	const shaft = safety + up * (Math.max(depth + Math.abs(safety - surface), 2) * .3);
	const shoulder = safety + (POINTED.includes(of.form.id) ? up * radius * .6 : 0);
	const [west, east] = [left - radius, left + radius];
	const items = [{
		kind: "line",
		points: [
			[west, shaft],
			[west, shoulder],
			[left, safety],
			[east, shoulder],
			[east, shaft]
		],
		look: "tool"
	}];
	if (of.form.id === "G299") {
		const pitch = Math.abs(number(v, "B"));
		const count = Math.min(60, Math.max(1, Math.round(number(v, "N"))));
		for (let i = 0; i < count; i += 1) {
			const z = safety + up * pitch * i;
			items.push({
				kind: "line",
				points: [[east, z], [east + radius * .2, z]],
				look: "tool",
				field: "N"
			});
		}
		items.push({
			kind: "label",
			field: "N",
			at: [east + radius * .2, safety + up * pitch * (count - 1) / 2]
		});
	}
	const places = {
		shaft: [left, shaft],
		down: [left, (safety + surface) / 2],
		along: [left, surface - up * depth * .5],
		floor: [left, floor],
		out: [east, (safety + surface) / 2]
	};
	for (const { name } of of.form.parameters) {
		const place = OF_TOOL[name.split(".").at(-1)];
		if (place) items.push({
			kind: "label",
			field: name,
			at: places[place]
		});
	}
	return items;
}
/** The angle of a punch as its cone is drawn (4.2), and the pitch of a helix (4.5, 4.7). */
function ofHoles(of, { floor, depth, up, half }) {
	if (of.form.id === "G281") {
		const open = Math.atan2(half, depth) * 180 / Math.PI;
		return [angle("alpha", [0, floor], up * (90 - open), up * (90 + open), depth * .6)];
	}
	if (of.form.id === "G298" || of.form.id === "G299") return [measure("B", [0, floor], [0, floor + up * Math.abs(number(of.values, "B"))])];
	return [];
}
function section(of) {
	const room = roomOf(of);
	const pieces = [
		part,
		planes,
		levels,
		stock,
		entries,
		ofHoles,
		tool
	];
	if (of.has("drill.P")) pieces.push(drilling);
	return pieces.flatMap((piece) => piece(of, room));
}
export { section };
