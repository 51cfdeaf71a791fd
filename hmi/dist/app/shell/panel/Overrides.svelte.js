import { t } from "../../lib/i18n/index.svelte.js";
import Key from "../../lib/parts/Key.svelte.js";
import { percent } from "../../lib/numbers.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { rapids } from "../keys.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/panel/Overrides.svelte
var root = $.from_html(`<div class="override s-16erbn2"><span class="label s-16erbn2"> </span> <button type="button" class="s-16erbn2">−</button> <input type="range" min="0" step="1" class="s-16erbn2"/> <button type="button" class="s-16erbn2">+</button> <output class="number s-16erbn2"> <small class="s-16erbn2">%</small></output></div>`);
var root_1 = $.from_html(`<span class="number"> </span>`);
var root_2 = $.from_html(`<!> <!> <div class="override s-16erbn2"><span class="label s-16erbn2"> </span> <div class="rapids s-16erbn2"></div></div>`, 1);
function Overrides($$anchor, $$props) {
	$.push($$props, true);
	const slider = ($$anchor, name = $.noop, label = $.noop, position = $.noop, last = $.noop, shown = $.noop) => {
		var div = root();
		var span = $.child(div);
		var text = $.only_child(span, true);
		var button = $.sibling(span, 2);
		var input = $.sibling(button, 2);
		$.remove_input_defaults(input);
		var button_1 = $.sibling(input, 2);
		var output = $.sibling(button_1, 2);
		var text_1 = $.child(output, true);
		$.next();
		$.reset(output);
		$.reset(div);
		$.template_effect(($0, $1) => {
			$.set_attribute(div, "data-override", name());
			$.set_text(text, label());
			button.disabled = !machine.inCommand;
			$.set_attribute(button, "aria-label", $0);
			$.set_attribute(input, "max", last());
			$.set_value(input, position());
			input.disabled = !machine.inCommand;
			$.set_attribute(input, "aria-label", label());
			$.set_attribute(input, "aria-valuetext", `${shown()} %`);
			button_1.disabled = !machine.inCommand;
			$.set_attribute(button_1, "aria-label", $1);
			$.set_text(text_1, shown());
		}, [() => t("panel.less", { what: label() }), () => t("panel.more", { what: label() })]);
		$.delegated("click", button, () => turn(name(), position() - 1, last()));
		$.delegated("input", input, (event) => turn(name(), Number(event.currentTarget.value), last()));
		$.delegated("click", button_1, () => turn(name(), position() + 1, last()));
		$.append($$anchor, div);
	};
	const status = $.derived(() => machine.status);
	const feed = $.derived(() => $.get(status)?.panel.SWITCH_FEED ?? 10);
	const spindle = $.derived(() => $.get(status)?.panel.SWITCH_SPINDLE ?? 5);
	function turn(name, position, last) {
		machine.tell({
			do: "switch",
			switch: name,
			position: Math.max(0, Math.min(last, position))
		});
	}
	var fragment = root_2();
	var node = $.first_child(fragment);
	{
		let $0 = $.derived(() => t("panel.feed"));
		let $1 = $.derived(() => percent($.get(status)?.feed.feed_override ?? 0));
		slider(node, () => "SWITCH_FEED", () => $.get($0), () => $.get(feed), () => 20, () => $.get($1));
	}
	var node_1 = $.sibling(node, 2);
	{
		let $0 = $.derived(() => t("panel.spindle"));
		let $1 = $.derived(() => percent($.get(status)?.spindle.spindle_override ?? 0));
		slider(node_1, () => "SWITCH_SPINDLE", () => $.get($0), () => $.get(spindle), () => 7, () => $.get($1));
	}
	var div_1 = $.sibling(node_1, 2);
	var span_1 = $.child(div_1);
	var text_2 = $.only_child(span_1, true);
	var div_2 = $.sibling(span_1, 2);
	$.each(div_2, 21, () => rapids, (rapid) => rapid.signal, ($$anchor, rapid) => {
		{
			let $0 = $.derived(() => t("panel.rapid_of", { value: $.get(rapid).label }));
			Key($$anchor, {
				get signal() {
					return $.get(rapid).signal;
				},
				get lamp() {
					return $.get(rapid).lamp;
				},
				get label() {
					return $.get($0);
				},
				children: ($$anchor, $$slotProps) => {
					var span_2 = root_1();
					var text_3 = $.only_child(span_2, true);
					$.template_effect(() => $.set_text(text_3, $.get(rapid).label));
					$.append($$anchor, span_2);
				},
				$$slots: { default: true }
			});
		}
	});
	$.reset(div_2);
	$.reset(div_1);
	$.template_effect(($0) => $.set_text(text_2, $0), [() => t("panel.rapid")]);
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["click", "input"]);
export { Overrides as default };
