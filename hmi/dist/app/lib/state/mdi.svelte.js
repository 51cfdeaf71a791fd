import { machine } from "./machine.svelte.js";
import * as $ from "svelte/internal/client";
// src/lib/state/mdi.svelte.ts
var held = $.state(null);
var draft = $.state(null);
var block = $.state("");
var mdi = {
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
		$.set(block, typed, true);
	},
	get isUnsent() {
		return $.get(draft) !== null || $.get(block).trim() !== "";
	},
	/** Whether cycle start runs what is shown. */
	get isShown() {
		return $.get(held) !== null && !this.isUnsent;
	},
	type(text) {
		$.set(draft, text === $.get(held)?.text ? null : text);
	},
	/** What was not sent is given up. */
	drop() {
		$.set(draft, null);
		$.set(block, "");
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
		if ($.get(draft) === reply.text) $.set(draft, null);
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
		if ($.get(block) === sent) $.set(block, "");
		return true;
	}
};
export { mdi };
