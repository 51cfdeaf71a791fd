import { Refused } from "../api/socket.js";
import { machine } from "./machine.svelte.js";
import * as $ from "svelte/internal/client";
// src/lib/state/dnc.svelte.ts
var PART = 131072;
var AGAIN = 200;
var NO_ROOM_YET = "FC-1418";
var file = $.state(null);
var sent = $.state(0);
var sending = $.state(false);
var turn = 0;
function decoderFor(beginning) {
	try {
		new TextDecoder("utf-8", { fatal: true }).decode(beginning, { stream: true });
		return new TextDecoder("utf-8");
	} catch {
		return new TextDecoder("gb18030");
	}
}
/** Sends a part as soon as there is room for it; false where nobody wants it sent any more. */
async function part(text, first, last, mine) {
	while (mine === turn) try {
		await machine.ask({
			do: "dnc",
			text,
			first,
			last
		});
		return true;
	} catch (refused) {
		if (!(refused instanceof Refused && refused.alarm?.id === NO_ROOM_YET)) throw refused;
		await new Promise((resolve) => setTimeout(resolve, AGAIN));
	}
	return false;
}
var dnc = {
	get file() {
		return $.get(file);
	},
	/** Bytes that the control has. */
	get sent() {
		return $.get(sent);
	},
	get sending() {
		return $.get(sending);
	},
	async send(chosen) {
		const mine = ++turn;
		(($$value) => {
			var $$array = $.to_array($$value, 3);
			$.set(file, $$array[0]);
			$.set(sent, $$array[1], true);
			$.set(sending, $$array[2], true);
		})([
			chosen,
			0,
			true
		]);
		try {
			let decoder = null;
			for (let at = 0; at === 0 || at < chosen.size; at += PART) {
				const bytes = await chosen.slice(at, at + PART).arrayBuffer();
				const last = at + PART >= chosen.size;
				decoder ??= decoderFor(bytes);
				if (!await part(decoder.decode(bytes, { stream: !last }), at === 0, last, mine)) return;
				$.set(sent, Math.min(chosen.size, at + PART), true);
			}
		} catch (refused) {
			machine.refused(refused);
		}
		if (mine === turn) $.set(sending, false);
	},
	/** Sends no more of it. */
	stop() {
		turn += 1;
		$.set(sending, false);
	}
};
export { dnc };
