import * as $ from "svelte/internal/client";
// src/lib/state/prefs.svelte.ts
var LANGUAGES = [
	"en",
	"zh",
	"ru",
	"es",
	"tr"
];
var KEY = "ferrocut.panel";
function fromBrowser() {
	for (const wanted of navigator.languages) {
		const short = wanted.slice(0, 2).toLowerCase();
		const found = LANGUAGES.find((language) => language === short);
		if (found) return found;
	}
	return "en";
}
function read() {
	const standard = {
		language: fromBrowser(),
		theme: "system",
		coordinates: "absolute",
		panel: innerWidth > 1100,
		keypad: matchMedia("(pointer: coarse)").matches,
		drawing: {
			erases: true,
			trail: true,
			range: null,
			frame: null
		},
		welcomed: false
	};
	try {
		const kept = JSON.parse(localStorage.getItem(KEY) ?? "{}");
		if (kept.language && !LANGUAGES.includes(kept.language)) delete kept.language;
		return {
			...standard,
			...kept,
			drawing: {
				...standard.drawing,
				...kept.drawing
			}
		};
	} catch {
		return standard;
	}
}
var prefs = $.proxy(read());
/** Keeps what changes, and puts theme and language into the page. */
function keepPrefs() {
	const system = matchMedia("(prefers-color-scheme: light)");
	const show = () => {
		const theme = prefs.theme === "system" ? system.matches ? "light" : "dark" : prefs.theme;
		document.documentElement.dataset.theme = theme;
	};
	system.addEventListener("change", show);
	$.effect_root(() => {
		$.user_effect(() => {
			show();
			document.documentElement.lang = prefs.language;
			try {
				localStorage.setItem(KEY, JSON.stringify(prefs));
			} catch {}
		});
	});
}
export { LANGUAGES, keepPrefs, prefs };
