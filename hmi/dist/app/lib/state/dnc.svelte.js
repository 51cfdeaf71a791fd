import { http } from "../api/http.js";
import { machine } from "./machine.svelte.js";
import * as $ from "svelte/internal/client";
// src/lib/state/dnc.svelte.ts
var file = $.state(null);
var coming = $.state(null);
var abort = null;
var dnc = {
	get file() {
		return $.get(file);
	},
	get coming() {
		return $.get(coming);
	},
	/** Asks how far it is. */
	async look() {
		try {
			$.set(file, await http.dnc());
		} catch {}
	},
	/** Brings a file. */
	async send(chosen) {
		abort?.abort();
		const mine = abort = new AbortController();
		$.set(coming, {
			name: chosen.name,
			bytes: chosen.size,
			sent: 0
		});
		try {
			const come = await http.bringDnc(chosen, mine.signal, (sent) => {
				if (abort === mine) $.set(coming, {
					name: chosen.name,
					bytes: chosen.size,
					sent
				});
			});
			if (abort === mine) $.set(file, come);
		} catch (refused) {
			if (!mine.signal.aborted) machine.refused(refused);
		}
		if (abort === mine) (($$value) => {
			var $$array = $.to_array($$value, 2);
			$.set(coming, $$array[0]);
			abort = $$array[1];
		})([null, null]);
	},
	async stop() {
		if (abort) {
			abort.abort();
			(($$value) => {
				var $$array_1 = $.to_array($$value, 2);
				$.set(coming, $$array_1[0]);
				abort = $$array_1[1];
			})([null, null]);
			return;
		}
		try {
			$.set(file, await http.stopDnc());
		} catch (refused) {
			machine.refused(refused);
		}
	}
};
export { dnc };
