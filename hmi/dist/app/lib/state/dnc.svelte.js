import { Refused } from "../api/socket.js";
import { t } from "../i18n/index.svelte.js";
import { machine } from "./machine.svelte.js";
import { notify } from "./notices.svelte.js";
import * as $ from "svelte/internal/client";
// src/lib/state/dnc.svelte.ts
var PART = 131072;
var AGAIN = 200;
var NO_ROOM_YET = "FC-1418";
var file = $.state(null);
var sent = $.state(0);
var sending = $.state(false);
var waiting = $.state(false);
var turn = 0;
function decoderFor(beginning) {
	try {
		new TextDecoder("utf-8", { fatal: true }).decode(beginning, { stream: true });
		return new TextDecoder("utf-8");
	} catch {
		return new TextDecoder("gb18030");
	}
}
/** Whether a part may be said again: there was no room for it yet, or it was never said, since there is no connection
or command has not come back yet after one was lost. */
function isToBeSaidAgain(refused) {
	if (!(refused instanceof Refused) || refused.open) return false;
	return refused.alarm?.id === NO_ROOM_YET || refused.code === "no_connection" || refused.code === "not_in_command" && machine.regains;
}
/** Sends a part as soon as there is room for it and a connection; false where nobody wants it sent any more. */
async function part(text, first, last, mine) {
	while (mine === turn) try {
		await machine.ask({
			do: "dnc",
			text,
			first,
			last
		});
		$.set(waiting, false);
		return true;
	} catch (refused) {
		if (!isToBeSaidAgain(refused)) throw refused;
		$.set(waiting, machine.link !== "open");
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
	/** Whether it waits for the connection to come back. */
	get waiting() {
		return $.get(sending) && $.get(waiting);
	},
	async send(chosen) {
		const mine = ++turn;
		(($$value) => {
			var $$array = $.to_array($$value, 4);
			$.set(file, $$array[0]);
			$.set(sent, $$array[1], true);
			$.set(sending, $$array[2], true);
			$.set(waiting, $$array[3], true);
		})([
			chosen,
			0,
			true,
			false
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
			if (refused instanceof Refused && refused.open) notify({
				kind: "warning",
				title: t("program.dnc_broken"),
				text: t("program.dnc_broken_text")
			});
			else machine.refused(refused);
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
