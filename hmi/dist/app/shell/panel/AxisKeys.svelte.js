import { t } from "../../lib/i18n/index.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import Key from "../../lib/parts/Key.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { increments } from "../keys.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/panel/AxisKeys.svelte
var root = $.from_html(`<b class="s-t7jqnm"> </b>`);
var root_1 = $.from_html(`<!><span> </span>`, 1);
var root_2 = $.from_html(`<div class="column s-t7jqnm"><!> <!></div>`);
var root_3 = $.from_html(`<span class="number"> </span>`);
var root_4 = $.from_html(`<p class="muted s-t7jqnm"> </p>`);
var root_5 = $.from_html(`<div class="pad s-t7jqnm"><div class="cross s-t7jqnm"><span></span><!><span></span> <!> <!> <!> <span></span><!><span></span></div> <div class="column s-t7jqnm"><!> <!></div> <!></div> <div class="steps s-t7jqnm" role="group"></div> <!>`, 1);
function AxisKeys($$anchor, $$props) {
	$.push($$props, true);
	const axis = ($$anchor, name = $.noop, sign = $.noop) => {
		{
			let $0 = $.derived(() => `KEY_${name()}${sign()}`);
			let $1 = $.derived(() => t("panel.move", { axis: `${name()}${sign() === "-" ? "−" : "+"}` }));
			let $2 = $.derived(() => !$.get(manual));
			Key($$anchor, {
				get signal() {
					return $.get($0);
				},
				get label() {
					return $.get($1);
				},
				kind: "jog",
				get disabled() {
					return $.get($2);
				},
				children: ($$anchor, $$slotProps) => {
					var b = root();
					var text = $.only_child(b);
					$.template_effect(() => $.set_text(text, `${name() ?? ""}${sign() === "-" ? "−" : "+"}`));
					$.append($$anchor, b);
				},
				$$slots: { default: true }
			});
		}
	};
	const axes = $.derived(() => machine.axes);
	const others = $.derived(() => $.get(axes).filter((axis) => axis === "A"));
	const manual = $.derived(() => [
		"jog",
		"step",
		"home"
	].includes(machine.mode ?? ""));
	var fragment_1 = root_5();
	var div = $.first_child(fragment_1);
	var div_1 = $.child(div);
	var node = $.sibling($.child(div_1));
	axis(node, () => "Y", () => "+");
	var node_1 = $.sibling(node, 3);
	axis(node_1, () => "X", () => "-");
	var node_2 = $.sibling(node_1, 2);
	{
		let $0 = $.derived(() => t("panel.rapid"));
		Key(node_2, {
			signal: "KEY_RAPID",
			lamp: "LAMP_RAPID",
			get label() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var fragment_2 = root_1();
				var node_3 = $.first_child(fragment_2);
				Icon(node_3, { name: "right" });
				var span = $.sibling(node_3);
				var text_1 = $.only_child(span, true);
				$.template_effect(($0) => $.set_text(text_1, $0), [() => t("panel.rapid")]);
				$.append($$anchor, fragment_2);
			},
			$$slots: { default: true }
		});
	}
	var node_4 = $.sibling(node_2, 2);
	axis(node_4, () => "X", () => "+");
	axis($.sibling(node_4, 3), () => "Y", () => "-");
	$.next();
	$.reset(div_1);
	var div_2 = $.sibling(div_1, 2);
	var node_6 = $.child(div_2);
	axis(node_6, () => "Z", () => "+");
	axis($.sibling(node_6, 2), () => "Z", () => "-");
	$.reset(div_2);
	var node_8 = $.sibling(div_2, 2);
	$.each(node_8, 16, () => $.get(others), (name) => name, ($$anchor, name) => {
		var div_3 = root_2();
		var node_9 = $.child(div_3);
		axis(node_9, () => name, () => "+");
		var node_10 = $.sibling(node_9, 2);
		axis(node_10, () => name, () => "-");
		$.reset(div_3);
		$.append($$anchor, div_3);
	});
	$.reset(div);
	var div_4 = $.sibling(div, 2);
	$.each(div_4, 23, () => increments, (increment) => increment.signal, ($$anchor, increment, index) => {
		{
			let $0 = $.derived(() => $$props.step === $.get(index));
			let $1 = $.derived(() => t("panel.increment_of", { value: $.get(increment).label }));
			Key($$anchor, {
				get signal() {
					return $.get(increment).signal;
				},
				get chosen() {
					return $.get($0);
				},
				get label() {
					return $.get($1);
				},
				children: ($$anchor, $$slotProps) => {
					var span_1 = root_3();
					var text_2 = $.only_child(span_1, true);
					$.template_effect(() => $.set_text(text_2, $.get(increment).label));
					$.append($$anchor, span_1);
				},
				$$slots: { default: true }
			});
		}
	});
	$.reset(div_4);
	var node_11 = $.sibling(div_4, 2);
	var consequent = ($$anchor) => {
		var p = root_4();
		var text_3 = $.only_child(p, true);
		$.template_effect(($0) => $.set_text(text_3, $0), [() => t("panel.axes_hint")]);
		$.append($$anchor, p);
	};
	$.if(node_11, ($$render) => {
		if (!$.get(manual)) $$render(consequent);
	});
	$.template_effect(($0) => $.set_attribute(div_4, "aria-label", $0), [() => t("panel.increment")]);
	$.append($$anchor, fragment_1);
	$.pop();
}
export { AxisKeys as default };
