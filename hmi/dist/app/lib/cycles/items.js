import { number } from "./geometry.js";
// src/lib/cycles/items.ts
/** What stands in a fresh form. */
function fresh(fields) {
	const values = {};
	for (const field of fields) if (field.standard !== null) values[field.name] = field.standard;
	return values;
}
/** Diameter of the tool of a stage, mm. */
function toolDiameter(request) {
	const stage = [
		"rough.T",
		"T",
		"finish.T"
	].map((name) => request.values[name]).find((value) => Number(value) > 0);
	return request.tools.find((tool) => tool.number === stage)?.diameter || 8;
}
function subject(form, request) {
	const names = new Set(form.parameters.map((field) => field.name));
	return {
		form,
		request,
		values: {
			...fresh(form.parameters),
			...request.values
		},
		has: (name) => names.has(name),
		tool: toolDiameter(request)
	};
}
var isBoss = ({ form }) => form.group === "bosses";
var isHole = ({ form }) => form.group === "axis";
/** The size by which measures stand aside, mm. */
function span(points) {
	const xs = points.map((p) => p[0]);
	const ys = points.map((p) => p[1]);
	return Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys), 4);
}
function measure(field, from, to, aside = 0) {
	return {
		kind: "measure",
		field,
		from,
		to,
		aside
	};
}
/** An angle at a point, degrees. */
function angle(field, at, from, to, radius) {
	return {
		kind: "angle",
		field,
		at,
		from,
		to,
		radius
	};
}
/** Both coordinates of a point, from the zero point. */
function coordinates([x, y], at, aside) {
	return [measure(x, [0, at[1]], at, -aside), measure(y, [at[0], 0], at, aside)];
}
/** The point at a distance from another in a direction, degrees. */
function toward(from, degrees, by) {
	const angle = degrees * Math.PI / 180;
	return [from[0] + by * Math.cos(angle), from[1] + by * Math.sin(angle)];
}
/** Whether a field that is named stands in the drawing although it is not in focus: what is a length or an angle of a
*  stage that has a tool. */
function stands(item, values) {
	const stage = item.field.includes(".") ? item.field.split(".")[0] : "";
	return item.kind !== "label" && number(values, item.field) !== 0 && values[`${stage}.T`] !== 0;
}
export { angle, coordinates, fresh, isBoss, isHole, measure, span, stands, subject, toolDiameter, toward };
