import { machine } from "./machine.svelte.js";
import * as $ from "svelte/internal/client";
// src/lib/state/restart.svelte.ts
var wanted = $.state(null);
var asked = $.state(false);
var restart = {
	get asked() {
		return $.get(asked);
	},
	get line() {
		return $.get(wanted);
	},
	/** Asks how: from a line on, or where the run was interrupted. */
	ask(line) {
		$.set(wanted, line);
		$.set(asked, true);
	},
	close() {
		$.set(asked, false);
	},
	/** Has the control search the block. */
	search(how) {
		return machine.tell({
			do: "restart",
			line: $.get(wanted),
			...how
		});
	},
	/** Forgets what is prepared. */
	async forget() {
		$.set(asked, false);
		await machine.tell({ do: "cancel_restart" });
	}
};
export { restart };
