import { t } from "../../lib/i18n/index.svelte.js";
import Page from "../../lib/parts/Page.svelte.js";
import { route } from "../../lib/routing.svelte.js";
import Directory from "./Directory.svelte.js";
import Dnc from "./Dnc.svelte.js";
import Edit from "./Edit.svelte.js";
import Mdi from "./Mdi.svelte.js";
import RunView from "./RunView.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/program/Program.svelte
function Program($$anchor, $$props) {
	$.push($$props, true);
	const tabs = $.derived(() => [
		"run",
		"edit",
		"mdi",
		"directory",
		"dnc"
	].map((id) => ({
		id,
		label: t(`program.${id}`)
	})));
	const active = $.derived(() => $.get(tabs).some((tab) => tab.id === route.tab) ? route.tab : "run");
	Page($$anchor, {
		page: "program",
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
				RunView($$anchor, {});
			};
			var consequent_1 = ($$anchor) => {
				Edit($$anchor, {});
			};
			var consequent_2 = ($$anchor) => {
				Mdi($$anchor, {});
			};
			var consequent_3 = ($$anchor) => {
				Dnc($$anchor, {});
			};
			var alternate = ($$anchor) => {
				Directory($$anchor, {});
			};
			$.if(node, ($$render) => {
				if ($.get(active) === "run") $$render(consequent);
				else if ($.get(active) === "edit") $$render(consequent_1, 1);
				else if ($.get(active) === "mdi") $$render(consequent_2, 2);
				else if ($.get(active) === "dnc") $$render(consequent_3, 3);
				else $$render(alternate, -1);
			});
			$.append($$anchor, fragment_1);
		},
		$$slots: { default: true }
	});
	$.pop();
}
export { Program as default };
