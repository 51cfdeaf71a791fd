import { http } from "../api/http.js";
import { Refused } from "../api/socket.js";
import { isSameProgram } from "../numbers.js";
import { machine } from "./machine.svelte.js";
import { untrack } from "svelte";
import * as $ from "svelte/internal/client";
// src/lib/state/programs.svelte.ts
var LONG = 5e5;
var list = $.state(null);
var most = $.state(null);
var room = $.state(null);
var programs = {
	get list() {
		return $.get(list);
	},
	get most() {
		return $.get(most);
	},
	get room() {
		return $.get(room);
	},
	async refresh() {
		const reply = await machine.fetch("programs", { do: "programs" });
		if (reply) $.set(list, reply.programs), $.set(most, reply.most), $.set(room, reply.room);
	},
	/** The program that a name means to the control, if there is one. */
	named(name) {
		return $.get(list)?.find((one) => isSameProgram(one.name, name));
	},
	/** When a program was changed, ms; null where there is none, or nobody knows. */
	async changedAt(program) {
		await this.refresh();
		return untrack(() => $.get(list))?.find((one) => one.name === program)?.changed || null;
	},
	/** The text of a program. */
	async read(program) {
		if (untrack(() => $.get(list)) === null) await this.refresh();
		if ((untrack(() => $.get(list))?.find((one) => one.name === program)?.bytes ?? 0) < LONG) try {
			const reply = await machine.ask({
				do: "read",
				program
			});
			if (reply.reply === "program") return reply.text;
		} catch (refused) {
			if (!(refused instanceof Refused) || refused.alarm || refused.code === "no_connection") throw refused;
		}
		return http.program(program);
	},
	/** Stores a program: over the socket, or as a file where it is too long for a line. */
	async store(program, text) {
		const longest = machine.hello?.longest_line ?? 4e6;
		if (text.length * 1.1 + 200 < longest) return machine.tell({
			do: "store",
			program,
			text
		});
		return this.bring(program, text);
	},
	/** Stores a file as a program. Of the encodings that shops have its own is found. */
	async bring(program, file) {
		try {
			await http.upload(program, file);
			return true;
		} catch (failed) {
			machine.refused(failed);
			return false;
		}
	}
};
export { programs };
