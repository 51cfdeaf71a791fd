import { Connection, Refused } from "../api/socket.js";
import { HttpError, http } from "../api/http.js";
import { has, language, t } from "../i18n/index.svelte.js";
import { notify } from "./notices.svelte.js";
import * as $ from "svelte/internal/client";
// src/lib/state/machine.svelte.ts
var link = $.state("connecting");
var greeting = $.state(null);
var version = $.state(null);
var status = $.state(null);
var inCommand = $.state(false);
var holder = $.state(null);
var rights = $.state(0);
var messages = $.state([]);
var programMessage = $.state("");
var changes = $.proxy({});
var hearers = /* @__PURE__ */ new Set();
var watchers = /* @__PURE__ */ new Set();
function heard(event) {
	switch (event.event) {
		case "command":
			$.set(inCommand, event.you);
			$.set(holder, event.holder);
			keepCommand(event.you, event.holder);
			return;
		case "refused":
			tellAlarm(event.alarm);
			break;
		case "message":
			$.set(programMessage, event.text);
			break;
		case "machine_message":
			$.set(messages, event.on ? [...$.get(messages).filter((name) => name !== event.name), event.name] : $.get(messages).filter((name) => name !== event.name));
			break;
		case "changed":
			changes[event.item] = (changes[event.item] ?? 0) + 1;
			break;
		case "activity": if (event.activity === "idle") $.set(programMessage, "");
	}
	for (const hear of hearers) hear(event);
}
/** Who commanded before a reload or a lost connection takes command again, if nobody else did. */
var COMMANDED = "ferrocut.commanded";
var again = sessionStorage.getItem(COMMANDED) !== null;
function keepCommand(you, by) {
	if (you) {
		again = false;
		sessionStorage.setItem(COMMANDED, "");
	} else if (by !== null) {
		again = false;
		sessionStorage.removeItem(COMMANDED);
	}
}
function takeAgain() {
	if (!again) return;
	again = false;
	connection.ask({ do: "take_command" }).catch(() => void 0);
}
async function tellAlarm(alarm) {
	try {
		const { text, help } = await http.alarm(alarm.id, alarm.values, language());
		notify({
			kind: "warning",
			title: text,
			text: help,
			code: alarm.id
		});
	} catch {
		notify({
			kind: "warning",
			title: alarm.id
		});
	}
}
var protocol = location.protocol === "https:" ? "wss:" : "ws:";
var connection = new Connection(`${protocol}//${location.host}/api/socket`, {
	state(now) {
		$.set(link, now);
		if (now === "lost") {
			again ||= $.get(inCommand);
			$.set(inCommand, false);
			$.set(holder, null);
		}
	},
	hello(now) {
		$.set(greeting, now);
		$.set(rights, now.session?.level ?? 0);
		takeAgain();
		connection.ask({ do: "version" }).then((reply) => {
			if (reply.reply === "version") $.set(version, reply);
		}, () => void 0);
	},
	event: heard,
	status(now) {
		$.set(status, now);
		for (const watch of watchers) watch(now);
	},
	end(reason) {
		if (reason !== "closed") notify({
			kind: "warning",
			title: t("app.ended"),
			text: reason
		});
	}
});
/** Tells the user what was refused: by the control with an alarm, or with the text of its code where there is one. */
function tellRefused(refused) {
	if (!(refused instanceof Refused || refused instanceof HttpError)) notify({
		kind: "warning",
		title: t("error.failed"),
		text: String(refused)
	});
	else if (refused.alarm) tellAlarm(refused.alarm);
	else {
		const key = `error.${refused.code}`;
		notify({
			kind: "warning",
			title: has(key) ? t(key) : t("error.failed"),
			text: refused instanceof Refused ? refused.detail : has(key) ? "" : refused.message
		});
	}
}
var machine = {
	get link() {
		return $.get(link);
	},
	get hello() {
		return $.get(greeting);
	},
	get version() {
		return $.get(version);
	},
	/** The latest status; null before the first. It comes 50 times a second and is never changed in place. */
	get status() {
		return $.get(status);
	},
	/** Whether this browser commands. */
	get inCommand() {
		return $.get(inCommand);
	},
	/** The connection that commands. */
	get holder() {
		return $.get(holder);
	},
	/** Messages of the ladder that stand. */
	get messages() {
		return $.get(messages);
	},
	/** What the program says. */
	get programMessage() {
		return $.get(programMessage);
	},
	/** The level whose rights this browser has: 5 is the operator. The level of the status is that of all who gave their
	password over the socket, and says nothing of a session. */
	get level() {
		return $.get(rights) || 5;
	},
	/** Letters of the axes. */
	get axes() {
		return $.get(version)?.axes ?? Object.keys($.get(status)?.position.machine ?? {});
	},
	get dialect() {
		return $.get(version)?.dialect ?? "gsk990mc";
	},
	/** How often an item of the memory was changed: to be read where it must be shown anew. */
	changed(item) {
		return changes[item] ?? 0;
	},
	start() {
		http.session().then(() => connection.open(), () => connection.open());
		const letGo = () => connection.releaseAll();
		addEventListener("blur", letGo);
		addEventListener("pagehide", letGo);
		document.addEventListener("visibilitychange", () => {
			if (document.visibilityState === "hidden") letGo();
		});
	},
	/** Connects anew, such as after a log-in. */
	reconnect() {
		connection.close();
		connection.open();
	},
	/** Gives command away: a reload does not take it again. */
	giveCommand() {
		sessionStorage.removeItem(COMMANDED);
		this.tell({ do: "give_command" });
	},
	/** Takes the rights of a level. */
	async logIn(level, password) {
		$.set(rights, (await http.logIn(level, password)).level);
	},
	/** Gives up the rights that were logged in with. */
	async logOut() {
		try {
			await http.logOut();
			await http.session();
		} catch (failed) {
			tellRefused(failed);
		}
		this.reconnect();
	},
	/** Says a command; the answer, or `Refused`. */
	ask(wish) {
		return connection.ask(wish);
	},
	/** Says a command and tells the user where it is refused. Whether it was done. */
	async tell(wish) {
		try {
			await connection.ask(wish);
			return true;
		} catch (refused) {
			tellRefused(refused);
			return false;
		}
	},
	/** Asks for data of one kind; null, and the user was told, where it is refused. */
	async fetch(kind, wish) {
		try {
			const reply = await connection.ask(wish);
			return reply.reply === kind ? reply : null;
		} catch (refused) {
			if (!(refused instanceof Refused && refused.code === "no_connection")) tellRefused(refused);
			return null;
		}
	},
	hold(key) {
		connection.hold(key).catch((refused) => {
			connection.release(key)?.catch(() => void 0);
			tellRefused(refused);
		});
	},
	release(key) {
		connection.release(key)?.catch(() => void 0);
	},
	/** Hears events until the answer is called. */
	hear(hearer) {
		hearers.add(hearer);
		return () => hearers.delete(hearer);
	},
	/** Hears each status until the answer is called: for what draws itself. */
	watch(watcher) {
		watchers.add(watcher);
		return () => watchers.delete(watcher);
	},
	refused: tellRefused,
	/** Tells the user that a command was not even sent. */
	refuse(code) {
		tellRefused(new Refused(code, null));
	}
};
export { machine };
