import { t } from "../../lib/i18n/index.svelte.js";
import Page from "../../lib/parts/Page.svelte.js";
import { route } from "../../lib/routing.svelte.js";
import Active from "./Active.svelte.js";
import History from "./History.svelte.js";
import Log from "./Log.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/alarms/Alarms.svelte
function Alarms($$anchor, $$props) {
	$.push($$props, true);
	const tabs = $.derived(() => [
		"active",
		"history",
		"log"
	].map((id) => ({
		id,
		label: t(`alarms.${id}`)
	})));
	const active = $.derived(() => $.get(tabs).some((tab) => tab.id === route.tab) ? route.tab : "active");
	Page($$anchor, {
		page: "alarms",
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
				Active($$anchor, {});
			};
			var consequent_1 = ($$anchor) => {
				History($$anchor, {});
			};
			var alternate = ($$anchor) => {
				Log($$anchor, {});
			};
			$.if(node, ($$render) => {
				if ($.get(active) === "active") $$render(consequent);
				else if ($.get(active) === "history") $$render(consequent_1, 1);
				else $$render(alternate, -1);
			});
			$.append($$anchor, fragment_1);
		},
		$$slots: { default: true }
	});
	$.pop();
}
export { Alarms as default };
