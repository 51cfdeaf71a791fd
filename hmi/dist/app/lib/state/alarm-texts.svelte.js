import { http } from "../api/http.js";
import { has, language, t } from "../i18n/index.svelte.js";
import { machine } from "./machine.svelte.js";
import * as $ from "svelte/internal/client";
import { SvelteMap } from "svelte/reactivity";
// src/lib/state/alarm-texts.svelte.ts
var texts = new SvelteMap();
var asked = /* @__PURE__ */ new Set();
function alarmText(alarm) {
	const lang = language();
	const key = `${lang} ${alarm.id} ${JSON.stringify(alarm.values)}`;
	const known = texts.get(key);
	if (known) return known;
	if (!asked.has(key)) {
		asked.add(key);
		http.alarm(alarm.id, alarm.values, lang).then((text) => texts.set(key, text), () => asked.delete(key));
	}
	return {
		id: alarm.id,
		text: "",
		help: ""
	};
}
/** What the ladder remarks on its messages, by their names. */
var remarks = $.state({});
/** Of which language and ladder they were asked. */
var askedOf = "";
/** What a message of the ladder says: of one that brought its own, its remark; its name where it has none. */
function messageText(name) {
	if (has(`message.${name}`)) return t(`message.${name}`);
	const lang = language();
	const wanted = `${lang} ${machine.changed("ladder")}`;
	if (machine.link === "open" && wanted !== askedOf) {
		askedOf = wanted;
		machine.ask({
			do: "signal_table",
			area: "A",
			language: lang
		}).then((reply) => {
			if (reply.reply === "signal_table" && askedOf === wanted) $.set(remarks, Object.fromEntries(reply.signals.map((one) => [one.name, one.meaning])));
		}, () => {
			if (askedOf === wanted) askedOf = "";
		});
	}
	return $.get(remarks)[name] || name;
}
/** The number of what the machine said through its ladder, in the history. */
var SAID = "FC-1446";
/** What stands in the history: of a message what it says, where the ladder that runs still knows it. */
function pastText(alarm) {
	const about = alarmText(alarm);
	const name = alarm.id === SAID ? alarm.values.name ?? "" : "";
	const says = name && messageText(name);
	return says && says !== name ? {
		...about,
		text: says
	} : about;
}
export { alarmText, messageText, pastText };
