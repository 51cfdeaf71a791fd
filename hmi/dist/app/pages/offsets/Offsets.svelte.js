import { t } from "../../lib/i18n/index.svelte.js";
import Page from "../../lib/parts/Page.svelte.js";
import { route } from "../../lib/routing.svelte.js";
import Parameters from "./Parameters.svelte.js";
import Pitch from "./Pitch.svelte.js";
import Tools from "./Tools.svelte.js";
import Variables from "./Variables.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/offsets/Offsets.svelte
function Offsets($$anchor, $$props) {
	$.push($$props, true);
	const tabs = $.derived(() => [
		"tools",
		"parameters",
		"variables",
		"pitch"
	].map((id) => ({
		id,
		label: t(`offsets.${id}`)
	})));
	const active = $.derived(() => $.get(tabs).some((tab) => tab.id === route.tab) ? route.tab : "tools");
	Page($$anchor, {
		page: "offsets",
		get tabs() {
			return $.get(tabs);
		},
		get active() {
			return $.get(active);
		},
		children: ($$anchor, $$slotProps) => {
			var fragment_1 = $.comment();
			var node = $.first_child(fragment_1);
			var consequent = ($$anchor) => {
				Tools($$anchor, {});
			};
			var consequent_1 = ($$anchor) => {
				Parameters($$anchor, {});
			};
			var consequent_2 = ($$anchor) => {
				Variables($$anchor, {});
			};
			var alternate = ($$anchor) => {
				Pitch($$anchor, {});
			};
			$.if(node, ($$render) => {
				if ($.get(active) === "tools") $$render(consequent);
				else if ($.get(active) === "parameters") $$render(consequent_1, 1);
				else if ($.get(active) === "variables") $$render(consequent_2, 2);
				else $$render(alternate, -1);
			});
			$.append($$anchor, fragment_1);
		},
		$$slots: { default: true }
	});
	$.pop();
}
export { Offsets as default };
