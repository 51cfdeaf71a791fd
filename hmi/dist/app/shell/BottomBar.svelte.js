import { t } from "../lib/i18n/index.svelte.js";
import Icon from "../lib/parts/Icon.svelte.js";
import Key from "../lib/parts/Key.svelte.js";
import StopButton from "../lib/parts/StopButton.svelte.js";
import { machine } from "../lib/state/machine.svelte.js";
import { mdi } from "../lib/state/mdi.svelte.js";
import { modes } from "./keys.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/BottomBar.svelte
var root = $.from_html(`<span class="s-d9ctwd"> </span>`);
var root_1 = $.from_html(`<!><span> </span>`, 1);
var root_2 = $.from_html(`<footer class="s-d9ctwd"><div class="modes s-d9ctwd" role="group"></div> <div class="do s-d9ctwd"><button type="button" class="reset s-d9ctwd" data-testid="reset"><!><span> </span></button> <!> <!> <!></div></footer>`);
function BottomBar($$anchor, $$props) {
	$.push($$props, true);
	var footer = root_2();
	var div = $.child(footer);
	$.each(div, 21, () => modes, (mode) => mode.signal, ($$anchor, mode) => {
		{
			let $0 = $.derived(() => t(`mode.${$.get(mode).mode}`));
			Key($$anchor, {
				get signal() {
					return $.get(mode).signal;
				},
				get lamp() {
					return $.get(mode).lamp;
				},
				get label() {
					return $.get($0);
				},
				children: ($$anchor, $$slotProps) => {
					var span = root();
					var text = $.only_child(span, true);
					$.template_effect(($0) => $.set_text(text, $0), [() => t(`mode.short_${$.get(mode).mode}`)]);
					$.append($$anchor, span);
				},
				$$slots: { default: true }
			});
		}
	});
	$.reset(div);
	var div_1 = $.sibling(div, 2);
	var button = $.child(div_1);
	var node = $.child(button);
	Icon(node, { name: "reset" });
	var span_1 = $.sibling(node);
	var text_1 = $.only_child(span_1, true);
	$.reset(button);
	var node_1 = $.sibling(button, 2);
	{
		let $0 = $.derived(() => t("panel.hold"));
		Key(node_1, {
			signal: "KEY_HOLD",
			lamp: "LAMP_HOLD",
			get label() {
				return $.get($0);
			},
			kind: "hold",
			everybody: true,
			children: ($$anchor, $$slotProps) => {
				var fragment_1 = root_1();
				var node_2 = $.first_child(fragment_1);
				Icon(node_2, { name: "pause" });
				var span_2 = $.sibling(node_2);
				var text_2 = $.only_child(span_2, true);
				$.template_effect(($0) => $.set_text(text_2, $0), [() => t("panel.hold")]);
				$.append($$anchor, fragment_1);
			},
			$$slots: { default: true }
		});
	}
	var node_3 = $.sibling(node_1, 2);
	{
		let $0 = $.derived(() => mdi.locksStart ? t("panel.start_unsent") : t("panel.start"));
		Key(node_3, {
			signal: "KEY_START",
			lamp: "LAMP_START",
			get label() {
				return $.get($0);
			},
			kind: "start",
			get disabled() {
				return mdi.locksStart;
			},
			children: ($$anchor, $$slotProps) => {
				var fragment_2 = root_1();
				var node_4 = $.first_child(fragment_2);
				Icon(node_4, {
					name: "play",
					fill: true
				});
				var span_3 = $.sibling(node_4);
				var text_3 = $.only_child(span_3, true);
				$.template_effect(($0) => $.set_text(text_3, $0), [() => mdi.locksStart ? t("panel.unsent") : t("panel.start")]);
				$.append($$anchor, fragment_2);
			},
			$$slots: { default: true }
		});
	}
	var node_5 = $.sibling(node_3, 2);
	StopButton(node_5, { "data-testid": "emergency" });
	$.reset(div_1);
	$.reset(footer);
	$.template_effect(($0, $1, $2) => {
		$.set_attribute(div, "aria-label", $0);
		button.disabled = machine.gate === true;
		$.set_attribute(button, "title", $1);
		$.set_text(text_1, $2);
	}, [
		() => t("panel.modes"),
		() => t("panel.reset"),
		() => t("panel.reset")
	]);
	$.delegated("click", button, () => void machine.tell({ do: "reset" }));
	$.append($$anchor, footer);
	$.pop();
}
$.delegate(["click"]);
export { BottomBar as default };
