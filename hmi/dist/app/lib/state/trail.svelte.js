import { Trail } from "../graphics/trail.js";
import { machine } from "./machine.svelte.js";
import { prefs } from "./prefs.svelte.js";
import * as $ from "svelte/internal/client";
// src/lib/state/trail.svelte.ts
var drawn = new Trail();
var any = $.state(false);
var idle = false;
function take({ position, program_mode, activity }) {
	const runs = activity === "running";
	if (runs && idle && prefs.drawing.erases) clear();
	idle = activity === "idle" || idle && !runs;
	if (!prefs.drawing.trail || runs && program_mode === "auto") {
		drawn.lift();
		return;
	}
	const { X = 0, Y = 0, Z = 0 } = position.machine;
	if (drawn.add(X, Y, Z)) $.set(any, true);
}
function clear() {
	drawn.clear();
	$.set(any, false);
}
var trail = {
	/** Follows the machine; for an effect. */
	follow: () => machine.watch(take),
	clear,
	/** Whether there is something to see. */
	get any() {
		return $.get(any);
	},
	get drawn() {
		return drawn;
	}
};
export { trail };
