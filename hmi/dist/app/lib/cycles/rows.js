import { distance, number } from "./geometry.js";
import { angle, coordinates, measure, toward } from "./items.js";
// src/lib/cycles/rows.ts
/** Most points of a figure that are drawn. */
var MOST_POINTS = 500;
/** The key of a field of positions. */
var key = (name) => `positions.${name}`;
var given = (values, name) => typeof values[name] === "number" ? values[name] : void 0;
var most = (count) => Math.max(1, Math.min(MOST_POINTS, Math.round(count)));
var degrees = (from, to) => Math.atan2(to[1] - from[1], to[0] - from[0]) * 180 / Math.PI;
/** Distance of neighbours and how many there are, of two that are given. */
function steps(length, distance, count) {
	if (length !== void 0 && distance) {
		const n = Math.round(Math.abs(length / distance)) + 1;
		return [length / Math.max(1, n - 1), n];
	}
	if (length !== void 0 && count !== void 0) return [length / Math.max(1, count - 1), count];
	return [distance ?? 0, count ?? 1];
}
/** Length, distance and count of a row, the length farther aside. */
function rowMarks([length, distance, count], [from, second, last], aside) {
	return [
		measure(key(length), from, last, aside * 1.4),
		measure(key(distance), from, second, aside),
		{
			kind: "label",
			field: key(count),
			at: last
		}
	];
}
function line(v, from, room) {
	const [xn, yn] = [given(v, "XN"), given(v, "YN")];
	const end = xn !== void 0 && yn !== void 0 ? [xn, yn] : null;
	const [step, count] = steps(end ? distance(from, end) : given(v, "L"), given(v, "I"), given(v, "N"));
	const turned = end ? degrees(from, end) : number(v, "alpha");
	const points = Array.from({ length: most(count) }, (_, i) => toward(from, turned, step * i));
	const last = points.at(-1);
	return {
		points,
		marks: [
			...rowMarks([
				"L",
				"I",
				"N"
			], [
				from,
				points[1] ?? from,
				last
			], room * .6),
			angle(key("alpha"), from, 0, turned, Math.max(Math.abs(step), room) * .7),
			{
				kind: "mark",
				field: key("XN"),
				at: last
			},
			...coordinates([key("XN"), key("YN")], last, room * .04)
		]
	};
}
function arc(v, from, room) {
	const [radius, first] = [given(v, "R"), given(v, "alpha")];
	const [xa, ya] = [given(v, "XA"), given(v, "YA")];
	const arm = radius !== void 0 && first !== void 0 ? toward([0, 0], first, radius) : null;
	const center = xa !== void 0 && ya !== void 0 ? [xa, ya] : arm ? [from[0] - arm[0], from[1] - arm[1]] : from;
	const begins = arm ? [center[0] + arm[0], center[1] + arm[1]] : from;
	const start = degrees(center, begins);
	const reach = distance(begins, center);
	const [count, between, last] = [
		given(v, "N"),
		given(v, "beta"),
		given(v, "tau")
	];
	const span = (sense) => {
		const turn = (((last ?? 0) - start) * sense % 360 + 360) % 360;
		return sense * (turn < 1e-9 ? 360 : turn);
	};
	let [step, n] = [between ?? 0, count ?? 1];
	if (between === void 0 && last !== void 0) step = span(1) / Math.max(1, n - 1);
	else if (count === void 0 && between && last !== void 0) n = Math.abs(span(Math.sign(between)) / between) + 1;
	const end = start + step * (most(n) - 1);
	const points = Array.from({ length: reach > 0 ? most(n) : 1 }, (_, i) => i === 0 ? from : toward(center, start + step * i, reach));
	return {
		points,
		marks: [
			{
				kind: "mark",
				field: key("XA"),
				at: center
			},
			...coordinates([key("XA"), key("YA")], center, room * .04),
			measure(key("R"), center, begins),
			angle(key("alpha"), center, 0, start, reach * .3),
			angle(key("tau"), center, 0, end, reach * .5),
			angle(key("beta"), center, start, start + step, reach * .75),
			{
				kind: "label",
				field: key("N"),
				at: points.at(-1)
			}
		]
	};
}
/** Rows and columns; of a rectangle those at its edge alone. */
function rows(v, from, room, edgeAlone) {
	const [dx, nx] = steps(given(v, "LX"), given(v, "IX"), given(v, "NX"));
	const [dy, ny] = steps(given(v, "LY"), given(v, "IY"), given(v, "NY"));
	const [lastX, lastY] = [most(nx) - 1, most(ny) - 1];
	const a = number(v, "alpha");
	const b = a + number(v, "beta", 90);
	const place = (i, j) => toward(toward(from, a, dx * i), b, dy * j);
	const points = [];
	for (let j = 0; j <= lastY; j += 1) for (let i = 0; i <= lastX && points.length < MOST_POINTS; i += 1) if (j === 0 || j === lastY || i === 0 || i === lastX || !edgeAlone) points.push(place(i, j));
	const radius = Math.max(Math.abs(dx), Math.abs(dy), room) * .7;
	return {
		points,
		marks: [
			...rowMarks([
				"LX",
				"IX",
				"NX"
			], [
				from,
				place(1, 0),
				place(lastX, 0)
			], -room * .6),
			...rowMarks([
				"LY",
				"IY",
				"NY"
			], [
				from,
				place(0, 1),
				place(0, lastY)
			], room * .6),
			angle(key("alpha"), from, 0, a, radius),
			angle(key("beta"), from, a, b, radius * .6)
		]
	};
}
/** A figure from a cycle's own point, its measures aside of shapes of a size. */
function figure(positions, from, room = 0) {
	if (!positions) return {
		points: [from],
		marks: []
	};
	const v = positions.values;
	switch (positions.kind) {
		case "LINE": return line(v, from, room);
		case "ARC": return arc(v, from, room);
		case "RECT":
		case "GRID": return rows(v, from, room, positions.kind === "RECT");
		default: {
			const marks = positions.points.map((at, i) => ({
				kind: "label",
				field: key(`P${i + 2}`),
				at
			}));
			return {
				points: [from, ...positions.points],
				marks
			};
		}
	}
}
export { figure, key };
