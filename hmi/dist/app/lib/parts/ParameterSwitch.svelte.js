import { t } from "../i18n/index.svelte.js";
import { machine } from "../state/machine.svelte.js";
import Button from "./Button.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/ParameterSwitch.svelte
var PARAMETERS_OPEN = "gsk990mc:0100";
var root = $.from_html(`<!> <!>`, 1);
function ParameterSwitch($$anchor, $$props) {
	$.push($$props, true);
	const open = $.derived(() => machine.status?.switches.parameters ?? null);
	const stands = $.derived(() => machine.status?.alarms.some((alarm) => alarm.id === "gsk990mc:0100") ?? false);
	var fragment = $.comment();
	var node = $.first_child(fragment);
	var consequent_1 = ($$anchor) => {
		var fragment_1 = root();
		var node_1 = $.first_child(fragment_1);
		{
			let $0 = $.derived(() => machine.status?.mode !== "mdi");
			Button(node_1, {
				get pressed() {
					return $.get(open);
				},
				get disabled() {
					return $.get($0);
				},
				"data-testid": "parameter-switch",
				onclick: () => void machine.tell({
					do: "parameter_switch",
					on: !$.get(open)
				}),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text = $.text();
					$.template_effect(($0) => $.set_text(text, $0), [() => t("offsets.switch")]);
					$.append($$anchor, text);
				},
				$$slots: { default: true }
			});
		}
		var node_2 = $.sibling(node_1, 2);
		var consequent = ($$anchor) => {
			Button($$anchor, {
				icon: "check",
				"data-testid": "accept-parameter-switch",
				onclick: () => void machine.tell({ do: "accept_parameter_switch" }),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_1 = $.text();
					$.template_effect(($0) => $.set_text(text_1, $0), [() => t("offsets.accept")]);
					$.append($$anchor, text_1);
				},
				$$slots: { default: true }
			});
		};
		$.if(node_2, ($$render) => {
			if ($.get(stands)) $$render(consequent);
		});
		$.append($$anchor, fragment_1);
	};
	$.if(node, ($$render) => {
		if ($.get(open) !== null) $$render(consequent_1);
	});
	$.append($$anchor, fragment);
	$.pop();
}
export { PARAMETERS_OPEN, ParameterSwitch as default };
