import { Connection, Refused } from "../api/socket.js";
import { HttpError, http } from "../api/http.js";
import { has, language, t } from "../i18n/index.svelte.js";
import { notify } from "./notices.svelte.js";
import { share } from "./share.js";
import * as $ from "svelte/internal/client";
import { SvelteMap } from "svelte/reactivity";
// src/lib/state/machine.svelte.ts
var link = $.state("connecting");
var greeting = $.state(null);
var version = $.state(null);
var latest = null;
var fields = new SvelteMap();
var status = new Proxy({}, {
	get: (_, field) => fields.get(field),
	has: (_, field) => fields.has(field)
});
var hasStatus = $.state(false);
var MEASURES = [
	"periods",
	"position",
	"feed",
	"counters",
	"spindle"
];
var turns = 0;
var Calm = class {
	#told = $.state(null);
	get told() {
		return $.get(this.#told);
	}
	set told(value) {
		$.set(this.#told, value);
	}
};
var CALM = 50;
var calm = Array.from({ length: 2 }, () => new Calm());
var isTurningPoint = (before, now) => before.activity !== now.activity || before.feed.actual !== 0 && now.feed.actual === 0;
function put(now) {
	for (const field of fields.keys()) if (!(field in now)) fields.delete(field);
	for (const [index, one] of calm.entries()) {
		const isDue = turns % CALM === index * (CALM / calm.length);
		if (!one.told || isDue || isTurningPoint(one.told, now)) one.told = now;
	}
	const turn = turns % MEASURES.length;
	turns += 1;
	for (const field in now) {
		const value = now[field];
		if (!(fields.has(field) && MEASURES.includes(field) && field !== MEASURES[turn])) fields.set(field, value);
	}
	$.set(hasStatus, true);
}
var inCommand = $.state(false);
var holder = $.state(null);
/** Those who ask for command. */
var asking = $.state([]);
/** Whether nothing is told before somebody logs in; null until the server has said so. */
var gate = $.state(null);
/** Of the session, 1 to 4; 0 for the operator. */
var rights = $.state(0);
var messages = $.state([]);
var mode = $.state(null);
var lit = [];
var lamps = $.state(/* @__PURE__ */ new Set());
/** Counts up with each event `changed`, by item; pages that show an item read it again. */
var changes = $.proxy({});
var hearers = /* @__PURE__ */ new Set();
var watchers = /* @__PURE__ */ new Set();
var isMine = (one) => one.connection === $.get(greeting)?.connection;
function heard(event) {
	switch (event.event) {
		case "command":
			if (event.you && $.get(asking).some(isMine)) notify({
				kind: "info",
				title: t("app.handed_to_you")
			});
			$.set(inCommand, event.you);
			$.set(holder, event.holder);
			$.set(asking, event.asking);
			keepCommand(event.you, event.holder);
			return;
		case "declined":
			notify({
				kind: "warning",
				title: t("app.declined")
			});
			return;
		case "refused":
			tellAlarm(event.alarm);
			break;
		case "changed": changes[event.item] = (changes[event.item] ?? 0) + 1;
	}
	for (const hear of hearers) hear(event);
}
/** Who commanded before a reload or a lost connection takes command again, if nobody else did. */
var COMMANDED = "ferrocut.commanded";
var again = sessionStorage.getItem(COMMANDED) !== null;
/** Until it is answered. */
var asks = false;
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
	asks = true;
	connection.ask({ do: "take_command" }).catch(() => void 0).finally(() => asks = false);
}
async function reasonOfAlarm(alarm) {
	try {
		const { text, help } = await http.alarm(alarm.id, alarm.values, language());
		return {
			title: text,
			text: help ?? "",
			code: alarm.id
		};
	} catch {
		return { title: alarm.id };
	}
}
/** Why: the alarm with which the control refused it, or the text of its code. */
async function reasonOf(refused) {
	if (refused instanceof TypeError) return { title: t("error.no_connection") };
	if (!(refused instanceof Refused || refused instanceof HttpError)) return { title: t("error.failed") };
	if (refused.alarm) return reasonOfAlarm(refused.alarm);
	const { code, detail } = refused;
	const key = [`error.${detail}`, `error.${code}`].find((one) => has(one));
	if (key) return { title: t(key) };
	return {
		title: t("error.failed"),
		code: code || (refused instanceof HttpError ? String(refused.status) : "")
	};
}
async function tellAlarm(alarm) {
	notify({
		kind: "warning",
		...await reasonOfAlarm(alarm)
	});
}
var protocol = location.protocol === "https:" ? "wss:" : "ws:";
var connection = new Connection(`${protocol}//${location.host}/api/socket`, {
	state(now) {
		$.set(link, now);
		if (now === "lost") {
			again ||= $.get(inCommand);
			$.set(inCommand, false);
			$.set(holder, null);
			$.set(asking, []);
			if ($.get(gate) === false) admit();
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
	status(told) {
		const now = share(latest, told);
		latest = now;
		put(now);
		$.set(messages, now.messages);
		$.set(mode, now.mode);
		if (now.lamps !== lit) {
			lit = now.lamps;
			$.set(lamps, new Set(lit));
		}
		for (const watch of watchers) watch(now);
	},
	end(reason) {
		const key = `error.${reason}`;
		if (reason !== "closed") notify({
			kind: "warning",
			title: t("app.ended"),
			text: has(key) ? t(key) : "",
			code: has(key) ? "" : reason
		});
	}
});
/** Asks who this browser is. Where it must log in first the socket is closed: the server would refuse it. */
async function admit() {
	try {
		const session = await http.session();
		$.set(gate, session.needs_log_in && session.level === 0);
	} catch {
		$.set(gate, $.get(gate) ?? false);
	}
	if (!$.get(gate)) return;
	$.set(rights, 0);
	connection.close();
	again = false;
	sessionStorage.removeItem(COMMANDED);
}
/** Tells the user what was refused. */
function tellRefused(refused) {
	reasonOf(refused).then((reason) => notify({
		kind: "warning",
		...reason
	}));
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
	/** Whether somebody must log in before the server says anything; null until that is known. */
	get gate() {
		return $.get(gate);
	},
	/** The latest status; null before the first. It comes 50 times a second and is never changed in place; parts that are as they
	were are the same objects as before. Each field is followed by itself: positions, feeds and times ten times a second
	(`watch` has each), all others as they change. */
	get status() {
		return $.get(hasStatus) ? status : null;
	},
	/** A status of the last second: for what stands behind numbers that are drawn, to be heard and not seen. Null before the first.
	Texts of one `part` follow together, those of another at another time. */
	calm(part) {
		return calm[part % calm.length].told;
	},
	/** The mode of the latest status: for what looks at that alone. */
	get mode() {
		return $.get(mode);
	},
	/** The lamps that are lit, likewise. */
	get lamps() {
		return $.get(lamps);
	},
	/** Whether this browser commands. */
	get inCommand() {
		return $.get(inCommand);
	},
	/** Whether command is asked for again after the connection was lost. */
	get regains() {
		return again || asks;
	},
	/** The connection that commands. */
	get holder() {
		return $.get(holder);
	},
	/** Those who ask for command, first come first. */
	get asking() {
		return $.get(asking);
	},
	/** Whether this browser asks for it. */
	get asksForCommand() {
		return $.get(asking).some(isMine);
	},
	/** Messages of the ladder that stand. */
	get messages() {
		return $.get(messages);
	},
	/** What the program says. */
	get programMessage() {
		return this.status?.program_message ?? "";
	},
	/** The level whose rights this browser has: 5 is the operator. The level of the status is that of all who gave their
	password over the socket, and says nothing of a session. */
	get level() {
		return $.get(rights) || 5;
	},
	/** Letters of the axes. */
	get axes() {
		return $.get(version)?.axes ?? Object.keys(this.status?.position.machine ?? {});
	},
	get dialect() {
		return $.get(version)?.dialect ?? "gsk990mc";
	},
	/** How often an item of the memory was changed: to be read where it must be shown anew. */
	changed(item) {
		return changes[item] ?? 0;
	},
	start() {
		admit().then(() => {
			if (!$.get(gate)) connection.open();
		});
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
	/** Takes the rights of a level, and connects where that had to wait for them. */
	async logIn(level, password) {
		$.set(rights, (await http.logIn(level, password)).level);
		if (!$.get(gate)) return;
		$.set(gate, false);
		connection.open();
	},
	/** Gives up the rights that were logged in with. */
	async logOut() {
		try {
			await http.logOut();
		} catch (failed) {
			tellRefused(failed);
		}
		await admit();
		if (!$.get(gate)) this.reconnect();
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
	/** Why something came to nothing. */
	reason: reasonOf,
	/** Tells the user that a command was not even sent. */
	refuse(code) {
		tellRefused(new Refused(code, null));
	}
};
export { machine };
