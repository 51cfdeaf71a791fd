import { t } from "../../lib/i18n/index.svelte.js";
import Page from "../../lib/parts/Page.svelte.js";
import { route } from "../../lib/routing.svelte.js";
import Browse from "./Browse.svelte.js";
import Calculator from "./Calculator.svelte.js";
import Codes from "./Codes.svelte.js";
import Operations from "./Operations.svelte.js";
import Search from "./Search.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/help/Help.svelte
function Help($$anchor, $$props) {
	$.push($$props, true);
	const tabs = $.derived(() => [
		"search",
		"operations",
		"codes",
		"parameters",
		"alarms",
		"variables",
		"addresses",
		"calculator"
	].map((id) => ({
		id,
		label: t(`help.${id}`)
	})));
	const active = $.derived(() => $.get(tabs).some((tab) => tab.id === route.tab) ? route.tab : "search");
	Page($$anchor, {
		page: "help",
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
				Search($$anchor, {});
			};
			var consequent_1 = ($$anchor) => {
				Operations($$anchor, {});
			};
			var consequent_2 = ($$anchor) => {
				Codes($$anchor, {});
			};
			var consequent_3 = ($$anchor) => {
				Browse($$anchor, { kinds: ["parameter"] });
			};
			var consequent_4 = ($$anchor) => {
				Browse($$anchor, { kinds: ["alarm"] });
			};
			var consequent_5 = ($$anchor) => {
				Browse($$anchor, { kinds: ["variable"] });
			};
			var consequent_6 = ($$anchor) => {
				Browse($$anchor, { kinds: ["signal", "address"] });
			};
			var alternate = ($$anchor) => {
				Calculator($$anchor, {});
			};
			$.if(node, ($$render) => {
				if ($.get(active) === "search") $$render(consequent);
				else if ($.get(active) === "operations") $$render(consequent_1, 1);
				else if ($.get(active) === "codes") $$render(consequent_2, 2);
				else if ($.get(active) === "parameters") $$render(consequent_3, 3);
				else if ($.get(active) === "alarms") $$render(consequent_4, 4);
				else if ($.get(active) === "variables") $$render(consequent_5, 5);
				else if ($.get(active) === "addresses") $$render(consequent_6, 6);
				else $$render(alternate, -1);
			});
			$.append($$anchor, fragment_1);
		},
		$$slots: { default: true }
	});
	$.pop();
}
export { Help as default };
