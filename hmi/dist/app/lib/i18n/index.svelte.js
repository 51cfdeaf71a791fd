import { prefs } from "../state/prefs.svelte.js";
import { text } from "./plural.js";
import { unitKey } from "./units.js";
import { __vitePreload } from "../../_virtual/_vite/preload-helper.js";
import * as $ from "svelte/internal/client";
// src/lib/i18n/index.svelte.ts
var loaders = {
	en: () => __vitePreload(() => import("../../locales/en/index.js"), []),
	zh: () => __vitePreload(() => import("../../locales/zh/index.js"), []),
	ru: () => __vitePreload(() => import("../../locales/ru/index.js"), []),
	es: () => __vitePreload(() => import("../../locales/es/index.js"), []),
	tr: () => __vitePreload(() => import("../../locales/tr/index.js"), [])
};
var loaded = $.state({
	language: "en",
	catalogue: {}
});
async function load(language) {
	const { default: catalogue } = await loaders[language]();
	if (prefs.language === language) $.set(loaded, {
		language,
		catalogue
	});
}
/** The text of a key, such as `position.title`. */
function t(key, values) {
	return text($.get(loaded).catalogue, $.get(loaded).language, key, values);
}
/** The sign of a unit as the control's tables write it, in the user's language; one that has no text stays as it is. */
function unit(sign) {
	const key = unitKey(sign);
	return has(key) ? t(key) : sign;
}
/** Whether there is a text. */
function has(key) {
	return key in $.get(loaded).catalogue;
}
/** The language whose texts are shown. */
function language() {
	return $.get(loaded).language;
}
var numbers = /* @__PURE__ */ new Map();
/** A number of the user's language, for texts; measures are shown by `$lib/numbers`. */
function number(value, digits = 0) {
	const key = `${$.get(loaded).language}.${digits}`;
	let format = numbers.get(key);
	if (!format) {
		format = new Intl.NumberFormat($.get(loaded).language, {
			minimumFractionDigits: digits,
			maximumFractionDigits: digits
		});
		numbers.set(key, format);
	}
	return format.format(value);
}
/** A time of day with its date, from ms since 1970. */
function moment(ms) {
	return ms > 0 ? new Intl.DateTimeFormat($.get(loaded).language, {
		dateStyle: "short",
		timeStyle: "medium"
	}).format(ms) : "–";
}
export { has, language, load, moment, number, t, unit };
