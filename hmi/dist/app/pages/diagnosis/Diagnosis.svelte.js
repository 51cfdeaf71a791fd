import { t } from "../../lib/i18n/index.svelte.js";
import Page from "../../lib/parts/Page.svelte.js";
import { route } from "../../lib/routing.svelte.js";
import Bytes from "./Bytes.svelte.js";
import Signals from "./Signals.svelte.js";
import Timing from "./Timing.svelte.js";
import Waveform from "./Waveform.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/diagnosis/Diagnosis.svelte
function Diagnosis($$anchor, $$props) {
	$.push($$props, true);
	const tabs = $.derived(() => [
		"signals",
		"bytes",
		"waveform",
		"timing"
	].map((id) => ({
		id,
		label: t(`diagnosis.${id}`)
	})));
	const active = $.derived(() => $.get(tabs).some((tab) => tab.id === route.tab) ? route.tab : "signals");
	Page($$anchor, {
		page: "diagnosis",
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
				Signals($$anchor, {});
			};
			var consequent_1 = ($$anchor) => {
				Bytes($$anchor, {});
			};
			var consequent_2 = ($$anchor) => {
				Waveform($$anchor, {});
			};
			var alternate = ($$anchor) => {
				Timing($$anchor, {});
			};
			$.if(node, ($$render) => {
				if ($.get(active) === "signals") $$render(consequent);
				else if ($.get(active) === "bytes") $$render(consequent_1, 1);
				else if ($.get(active) === "waveform") $$render(consequent_2, 2);
				else $$render(alternate, -1);
			});
			$.append($$anchor, fragment_1);
		},
		$$slots: { default: true }
	});
	$.pop();
}
export { Diagnosis as default };
