import { http } from "../api/http.js";
import { has, language, t } from "../i18n/index.svelte.js";
import "svelte/internal/client";
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
/** What a message of the ladder says; its name where it is of a ladder that brought its own. */
function messageText(name) {
	return has(`message.${name}`) ? t(`message.${name}`) : name;
}
export { alarmText, messageText };
