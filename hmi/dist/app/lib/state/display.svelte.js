import { route } from "../routing.svelte.js";
import { followParameters } from "./again.js";
import { machine } from "./machine.svelte.js";
import * as $ from "svelte/internal/client";
// src/lib/state/display.svelte.ts
var STEPS = {
	position: "NO25.0",
	program: "NO25.1",
	offsets: "NO25.2",
	settings: "NO25.4",
	diagnosis: "NO25.6",
	alarms: "NO25.7",
	plc: "NO26.6",
	help: "NO26.7"
};
var ALARM_OPENS = "NO24.6";
var SHOWS_MODAL = "NO23.6";
var EDIT_OPENS = "NO26.0";
var PROGRAM_IN_EDIT = "NO26.1";
var PROGRAM_IN_MDI = "NO26.2";
var names = [
	...Object.values(STEPS),
	ALARM_OPENS,
	SHOWS_MODAL,
	EDIT_OPENS,
	PROGRAM_IN_EDIT,
	PROGRAM_IN_MDI
];
var bits = $.state({});
var parts = $.state({
	page: "",
	ids: [],
	active: ""
});
var is = (name) => $.get(bits)[name] === 1;
var display = {
	follow: () => followParameters(names, (values) => $.set(bits, values)),
	get alarmOpens() {
		return is(ALARM_OPENS);
	},
	/** Whether the key of the mode EDIT shows the program. */
	get editOpens() {
		return is(EDIT_OPENS);
	},
	/** Whether the codes in force stand beside the running program. */
	get showsModal() {
		return $.get(bits)[SHOWS_MODAL] !== 0;
	},
	/** A page says which parts it has. */
	has(page, ids, active) {
		$.set(parts, {
			page,
			ids,
			active
		});
	},
	/** Where the key of a page leads: to the page, or from it to its next part. */
	to(page) {
		if (page !== route.page || page !== $.get(parts).page) {
			if (page === "program" && machine.mode === "edit" && is(PROGRAM_IN_EDIT)) return [page, "edit"];
			if (page === "program" && machine.mode === "mdi" && is(PROGRAM_IN_MDI)) return [page, "mdi"];
			return [page];
		}
		const { ids, active } = $.get(parts);
		if (ids.length === 0 || !is(STEPS[page] ?? "")) return [
			page,
			active,
			route.item
		].filter(Boolean);
		return [page, ids[(ids.indexOf(active) + 1) % ids.length]];
	}
};
export { display };
