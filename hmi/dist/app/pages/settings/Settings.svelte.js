import { t } from "../../lib/i18n/index.svelte.js";
import Page from "../../lib/parts/Page.svelte.js";
import { route } from "../../lib/routing.svelte.js";
import Centring from "./Centring.svelte.js";
import Data from "./Data.svelte.js";
import General from "./General.svelte.js";
import MachineZero from "./MachineZero.svelte.js";
import Probe from "./Probe.svelte.js";
import Rights from "./Rights.svelte.js";
import ToolLength from "./ToolLength.svelte.js";
import Zeros from "./Zeros.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/settings/Settings.svelte
function Settings($$anchor, $$props) {
	$.push($$props, true);
	const tabs = $.derived(() => [
		"zeros",
		"centring",
		"probe",
		"tool",
		"machine_zero",
		"general",
		"data",
		"rights"
	].map((id) => ({
		id,
		label: t(`settings.${id}`)
	})));
	const active = $.derived(() => $.get(tabs).some((tab) => tab.id === route.tab) ? route.tab : "zeros");
	Page($$anchor, {
		page: "settings",
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
				Zeros($$anchor, {});
			};
			var consequent_1 = ($$anchor) => {
				Centring($$anchor, {});
			};
			var consequent_2 = ($$anchor) => {
				Probe($$anchor, {});
			};
			var consequent_3 = ($$anchor) => {
				ToolLength($$anchor, {});
			};
			var consequent_4 = ($$anchor) => {
				MachineZero($$anchor, {});
			};
			var consequent_5 = ($$anchor) => {
				General($$anchor, {});
			};
			var consequent_6 = ($$anchor) => {
				Data($$anchor, {});
			};
			var alternate = ($$anchor) => {
				Rights($$anchor, {});
			};
			$.if(node, ($$render) => {
				if ($.get(active) === "zeros") $$render(consequent);
				else if ($.get(active) === "centring") $$render(consequent_1, 1);
				else if ($.get(active) === "probe") $$render(consequent_2, 2);
				else if ($.get(active) === "tool") $$render(consequent_3, 3);
				else if ($.get(active) === "machine_zero") $$render(consequent_4, 4);
				else if ($.get(active) === "general") $$render(consequent_5, 5);
				else if ($.get(active) === "data") $$render(consequent_6, 6);
				else $$render(alternate, -1);
			});
			$.append($$anchor, fragment_1);
		},
		$$slots: { default: true }
	});
	$.pop();
}
export { Settings as default };
