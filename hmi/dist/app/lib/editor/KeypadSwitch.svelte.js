import { t } from "../i18n/index.svelte.js";
import Button from "../parts/Button.svelte.js";
import { prefs } from "../state/prefs.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/editor/KeypadSwitch.svelte
function KeypadSwitch($$anchor, $$props) {
	$.push($$props, true);
	{
		let $0 = $.derived(() => t("editor.keypad"));
		let $1 = $.derived(() => t("editor.keypad"));
		Button($$anchor, {
			icon: "keyboard",
			get pressed() {
				return prefs.keypad;
			},
			get "aria-label"() {
				return $.get($0);
			},
			get title() {
				return $.get($1);
			},
			onclick: () => prefs.keypad = !prefs.keypad,
			"data-testid": "keypad-toggle"
		});
	}
	$.pop();
}
export { KeypadSwitch as default };
