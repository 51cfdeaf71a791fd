import { fresh } from "./items.js";
import { key } from "./rows.js";
import * as $ from "svelte/internal/client";
// src/lib/cycles/form.svelte.ts
var filled = $.proxy({});
var own = $.proxy({});
var table = $.state({});
var chosen = $.state("G287");
function contours(form) {
	const corners = [
		[-40, -25],
		[40, -25],
		[40, 25],
		[-40, 25]
	];
	const round = {
		kind: "round",
		size: 8
	};
	if (form.profile === "none") return [];
	if (form.profile === "contours" || form.profile === "depths") return [{
		start: [-40, 0],
		elements: [...corners.map((to) => ({
			kind: "line",
			to,
			corner: { ...round }
		})), {
			kind: "line",
			to: [-40, 0],
			corner: null
		}],
		entry: 0,
		exit: 0
	}];
	return [{
		start: [-40, -25],
		elements: corners.slice(1).map((to, i) => ({
			kind: "line",
			to,
			corner: i < 2 ? { ...round } : null
		})),
		entry: 0,
		exit: 0
	}];
}
var forms = {
	get chosen() {
		return $.get(chosen);
	},
	choose(id) {
		$.set(chosen, id, true);
	},
	/** The form of a cycle as filled in; none before it was begun. */
	of(form) {
		return filled[form.id];
	},
	/** Begins a form where it is not. */
	begin(form) {
		if (!(form.id in filled)) this.clear(form);
	},
	/** Begins a form anew. */
	clear(form) {
		filled[form.id] = {
			values: fresh(form.parameters),
			positions: null,
			contours: contours(form),
			depths: []
		};
	},
	/** Fills a form in as a cycle of a program is. */
	fill(form, { values, positions, profile, depths }) {
		filled[form.id] = {
			values: { ...values },
			positions: positions[0] ?? null,
			contours: profile?.contours ?? contours(form),
			depths
		};
		$.set(chosen, form.id, true);
	},
	figure(form, kind) {
		const found = form.positions.find((one) => one.kind === kind);
		return found ? {
			kind,
			values: fresh(found.parameters),
			points: []
		} : null;
	},
	/** What is known of a tool. */
	tool(number) {
		return {
			number,
			...own[number],
			diameter: own[number]?.diameter ?? $.get(table)[number] ?? 0
		};
	},
	/** What was typed of a tool; none where it is as the machine's table has it. */
	ownTool(number) {
		return own[number];
	},
	/** Something of a tool was typed; null is as the table has it. */
	setTool(number, typed) {
		const all = Object.entries({
			...own[number],
			...typed,
			number
		}).filter(([, value]) => value !== null);
		if (all.length > 1) own[number] = Object.fromEntries(all);
		else delete own[number];
	},
	/** A tool is as the table has it. */
	dropTool(number) {
		delete own[number];
	},
	/** What the machine's table has, by number. */
	setTable(diameters) {
		$.set(table, diameters);
	}
};
/** The numbers of the tools that a form calls. */
function toolsOf(values) {
	const called = [
		"T",
		"drill.T",
		"rough.T",
		"semi.T",
		"finish.T"
	].map((name) => values[name]).filter((value) => typeof value === "number");
	return [...new Set(called.filter((value) => Number.isInteger(value) && value > 0 && value < 1e4))].sort((a, b) => a - b);
}
/** What the server is asked for. */
function request(form, of) {
	const values = {};
	for (const field of form.parameters) {
		const value = of.values[field.name];
		if (value !== void 0 && value !== "") values[field.name] = value;
	}
	if (form.profile !== "depths" || of.depths.length === 0) for (const name of [
		"Z1",
		"Z2",
		"Z3",
		"Z4"
	]) delete values[name];
	else of.depths.forEach((_, i) => values[`Z${i + 1}`] ??= `DEPTH${i + 1}`);
	return {
		cycle: form.id,
		values,
		positions: of.positions && form.positions.length ? [of.positions] : [],
		profile: form.profile === "none" ? null : { contours: of.contours },
		depths: form.profile === "depths" ? of.depths : [],
		tools: toolsOf(values).flatMap((number) => forms.ownTool(number) ?? [])
	};
}
/** A field of positions under the key that findings and drawings have for it. */
var placed = (field) => ({
	...field,
	name: key(field.name)
});
/** Every field of a form and of its positions, with what is filled in. */
function drawn(form, of) {
	const figure = form.positions.find((one) => one.kind === of.positions?.kind);
	const positions = Object.entries(of.positions?.values ?? {}).map(([name, value]) => [key(name), value]);
	return {
		fields: [...form.parameters, ...(figure?.parameters ?? []).map(placed)],
		values: {
			...of.values,
			...Object.fromEntries(positions)
		}
	};
}
/** The axis whose position a field may take, counted from 0; none where it is no position (3.3). */
function axisOf(field) {
	if (field.kind !== "length" || field.stage !== "cycle") return null;
	if ([
		"X",
		"XC",
		"X1",
		"XN",
		"XA"
	].includes(field.name)) return 0;
	if ([
		"Y",
		"YC",
		"Y1",
		"YN",
		"YA"
	].includes(field.name)) return 1;
	if ([
		"Z",
		"ZS",
		"ZR"
	].includes(field.name)) return 2;
	return null;
}
export { axisOf, drawn, forms, placed, request, toolsOf };
