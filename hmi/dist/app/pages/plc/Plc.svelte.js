import { t } from "../../lib/i18n/index.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import Page from "../../lib/parts/Page.svelte.js";
import { route } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Data from "./Data.svelte.js";
import Edit from "./Edit.svelte.js";
import Info from "./Info.svelte.js";
import Monitor from "./Monitor.svelte.js";
import Trace from "./Trace.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/plc/Plc.svelte
function Plc($$anchor, $$props) {
	$.push($$props, true);
	const tabs = $.derived(() => [
		"monitor",
		"data",
		"edit",
		"trace",
		"info"
	].map((id) => ({
		id,
		label: t(`plc.${id}`)
	})));
	const active = $.derived(() => $.get(tabs).some((tab) => tab.id === route.tab) ? route.tab : "monitor");
	Page($$anchor, {
		page: "plc",
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
				{
					let $0 = $.derived(() => t("plc.none"));
					let $1 = $.derived(() => t("plc.none_text"));
					Empty($$anchor, {
						icon: "plc",
						get title() {
							return $.get($0);
						},
						get text() {
							return $.get($1);
						}
					});
				}
			};
			var consequent_1 = ($$anchor) => {
				Monitor($$anchor, {});
			};
			var consequent_2 = ($$anchor) => {
				Data($$anchor, {});
			};
			var consequent_3 = ($$anchor) => {
				Edit($$anchor, {});
			};
			var consequent_4 = ($$anchor) => {
				Info($$anchor, {});
			};
			var alternate = ($$anchor) => {
				Trace($$anchor, {});
			};
			$.if(node, ($$render) => {
				if (machine.hello?.panel?.ladder === false) $$render(consequent);
				else if ($.get(active) === "monitor") $$render(consequent_1, 1);
				else if ($.get(active) === "data") $$render(consequent_2, 2);
				else if ($.get(active) === "edit") $$render(consequent_3, 3);
				else if ($.get(active) === "info") $$render(consequent_4, 4);
				else $$render(alternate, -1);
			});
			$.append($$anchor, fragment_1);
		},
		$$slots: { default: true }
	});
	$.pop();
}
export { Plc as default };
