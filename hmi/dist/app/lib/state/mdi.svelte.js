import { machine } from "./machine.svelte.js";
import * as $ from "svelte/internal/client";
// src/lib/state/mdi.svelte.ts
var held = $.state(null);
var KEY = "ferrocut.mdi-unsent";
var before = kept();
var draft = $.state(before.draft);
var block = $.state($.proxy(before.block));
function kept() {
	try {
		const { draft, block } = JSON.parse(sessionStorage.getItem(KEY) ?? "{}");
		return {
			draft: typeof draft === "string" ? draft : null,
			block: typeof block === "string" ? block : ""
		};
	} catch {
		return {
			draft: null,
			block: ""
		};
	}
}
function put(text, one) {
	if (text === $.get(draft) && one === $.get(block)) return;
	(($$value) => {
		var $$array = $.to_array($$value, 2);
		$.set(draft, $$array[0]);
		$.set(block, $$array[1], true);
	})([text, one]);
	try {
		if (text === null && one === "") sessionStorage.removeItem(KEY);
		else sessionStorage.setItem(KEY, JSON.stringify({
			draft: text,
			block: one
		}));
	} catch {}
}
var mdi = {
	/** What the control has; null until it has said so. */
	get held() {
		return $.get(held);
	},
	/** What was typed in the place of the control's text; null where nothing was. */
	get draft() {
		return $.get(draft);
	},
	/** What was typed of one block. */
	get block() {
		return $.get(block);
	},
	set block(typed) {
		put($.get(draft), typed);
	},
	get isUnsent() {
		return $.get(draft) !== null || $.get(block).trim() !== "";
	},
	/** Whether cycle start would run something else than what was typed last. */
	get locksStart() {
		return machine.mode === "mdi" && this.isUnsent;
	},
	/** Whether cycle start runs what is shown. */
	get isShown() {
		return $.get(held) !== null && !this.isUnsent;
	},
	type(text) {
		put(text === $.get(held)?.text ? null : text, $.get(block));
	},
	/** What was not sent is given up. */
	drop() {
		put(null, "");
	},
	/** What the control has may be another by now. */
	forget() {
		$.set(held, null);
	},
	async read() {
		const reply = await machine.fetch("mdi_text", { do: "mdi_text" });
		if (!reply) return;
		$.set(held, {
			text: reply.text,
			block: reply.block
		});
		if ($.get(draft) === reply.text) put(null, $.get(block));
	},
	/** Whether the control took it. */
	async send(text) {
		if (!await machine.tell({
			do: "mdi",
			text
		})) return false;
		await this.read();
		return true;
	},
	/** The same of one block; an empty one takes back the one that waits. */
	async sendBlock(sent) {
		if (!await machine.tell({
			do: "mdi_block",
			block: sent
		})) return false;
		await this.read();
		if ($.get(block) === sent) put($.get(draft), "");
		return true;
	}
};
export { mdi };
