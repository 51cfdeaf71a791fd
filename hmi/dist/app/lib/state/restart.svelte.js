import { t } from "../i18n/index.svelte.js";
import { again } from "./again.js";
import { machine } from "./machine.svelte.js";
import * as $ from "svelte/internal/client";
// src/lib/state/restart.svelte.ts
var wanted = $.state(null);
var asked = $.state(false);
function called(of) {
	const group = /^G(\d+)$/.exec(of);
	if (group) return t("restart.of_group", { number: group[1] });
	const [what = "", axis = ""] = of.split(".");
	return t(`restart.of_${what}`, { axis });
}
var restart = {
	/** Whether somebody is about to prepare one. */
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
	/** Tells what is prepared until the answer is called. What differs changes as the operator makes the machine as the program
	has it: it is asked for again and again. */
	follow(told) {
		return again(300, async (wanted) => {
			const reply = await machine.ask({ do: "restarts" }).catch(() => null);
			if (wanted() && reply?.reply === "restarts") told(reply);
		});
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
export { called, restart };
