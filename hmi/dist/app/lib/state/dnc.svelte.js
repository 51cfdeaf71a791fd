import { Refused } from "../api/socket.js";
import { t } from "../i18n/index.svelte.js";
import { machine } from "./machine.svelte.js";
import { notify } from "./notices.svelte.js";
import * as $ from "svelte/internal/client";
// src/lib/state/dnc.svelte.ts
var PART = 131072;
var AGAIN = 200;
var NO_ROOM_YET = "FC-1418";
var utf8 = new TextEncoder();
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
/** What the control has of the program, once there is a connection; null where it has none. */
async function taken(mine) {
	while (mine === turn) try {
		const reply = await machine.ask({ do: "status" });
		return reply.reply === "status" ? reply.dnc : null;
	} catch (refused) {
		if (!(refused instanceof Refused) || !(refused.open || refused.code === "no_connection")) throw refused;
		await new Promise((resolve) => setTimeout(resolve, AGAIN));
	}
	return null;
}
/** Sends a part as soon as there is room for it and a connection; false where nobody wants it sent any more. `before`
are the bytes of the program that went before it. */
async function part(text, before, last, mine) {
	while (mine === turn) try {
		await machine.ask({
			do: "dnc",
			text,
			first: before === 0,
			last
		});
		$.set(waiting, false);
		return true;
	} catch (refused) {
		$.set(waiting, machine.link !== "open");
		if (refused instanceof Refused && refused.open) {
			const now = await taken(mine);
			$.set(waiting, false);
			if (now?.taken === before + utf8.encode(text).length && text.endsWith(now.tail.slice(-text.length))) return true;
			if (before > 0 && now?.taken !== before) throw refused;
		} else if (!isToBeSaidAgain(refused)) throw refused;
		await new Promise((resolve) => setTimeout(resolve, AGAIN));
	}
	return false;
}
/** The text of a file, in parts, the last one told. */
async function* parts(chosen) {
	let decoder = null;
	for (let at = 0; at === 0 || at < chosen.size; at += PART) {
		const bytes = await chosen.slice(at, at + PART).arrayBuffer();
		const last = at + PART >= chosen.size;
		decoder ??= decoderFor(bytes);
		yield {
			text: decoder.decode(bytes, { stream: !last }),
			end: Math.min(chosen.size, at + PART),
			last
		};
	}
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
	/** Sends a file; `onward` what the control has not got yet of it. */
	async send(chosen, onward = false) {
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
			const there = onward ? await taken(mine) : null;
			if (onward && !there?.awaited) throw new Refused("dnc_over", null);
			let before = 0;
			for await (const { text, end, last } of parts(chosen)) {
				const bytes = utf8.encode(text);
				const missing = (there?.taken ?? 0) - before;
				if (missing >= bytes.length && bytes.length > 0) {
					if (last || missing === bytes.length && !text.endsWith(there.tail.slice(-text.length))) throw new Refused("dnc_foreign", null);
				} else {
					const had = missing > 0 ? new TextDecoder("utf-8", { ignoreBOM: true }).decode(bytes.subarray(0, missing)) : "";
					if (had && !had.endsWith(there.tail.slice(-had.length))) throw new Refused("dnc_foreign", null);
					if (!await part(text.slice(had.length), before + Math.max(0, missing), last, mine)) return;
				}
				before += bytes.length;
				$.set(sent, end, true);
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
