import { t } from "../../lib/i18n/index.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import Key from "../../lib/parts/Key.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { increments } from "../keys.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/panel/AxisKeys.svelte
var root = $.from_html(`<b class="s-t7jqnm"> </b>`);
var root_1 = $.from_html(`<span></span>`);
var root_2 = $.from_html(`<!><span> </span>`, 1);
var root_3 = $.from_html(`<div class="column s-t7jqnm"><!> <!></div>`);
var root_4 = $.from_html(`<!><!>`, 1);
var root_5 = $.from_html(`<div class="steps s-t7jqnm"></div>`);
var root_6 = $.from_html(`<span class="number"> </span>`);
var root_7 = $.from_html(`<p class="muted s-t7jqnm"> </p>`);
var root_8 = $.from_html(`<div class="pad s-t7jqnm"><div class="cross s-t7jqnm"><span></span><!><span></span> <!> <!> <!> <span></span><!><span></span></div> <!></div> <!> <div class="steps s-t7jqnm" role="group"></div> <!>`, 1);
function AxisKeys($$anchor, $$props) {
	$.push($$props, true);
	const axis = ($$anchor, key = $.noop, sign = $.noop) => {
		var fragment = $.comment();
		var node = $.first_child(fragment);
		var consequent = ($$anchor) => {
			const name = $.derived(() => `${key().letter}${sign()}`);
			{
				let $0 = $.derived(() => sign() === "+" ? key().plus : key().minus);
				let $1 = $.derived(() => t("panel.move", { axis: $.get(name) }));
				let $2 = $.derived(() => sign() === "+" ? key().zero : "");
				let $3 = $.derived(() => !$.get(manual));
				Key($$anchor, {
					get signal() {
						return $.get($0);
					},
					get label() {
						return $.get($1);
					},
					kind: "jog",
					get beside() {
						return $.get($2);
					},
					get disabled() {
						return $.get($3);
					},
					children: ($$anchor, $$slotProps) => {
						var b = root();
						var text = $.only_child(b, true);
						$.template_effect(() => $.set_text(text, $.get(name)));
						$.append($$anchor, b);
					},
					$$slots: { default: true }
				});
			}
		};
		var alternate = ($$anchor) => {
			var span = root_1();
			$.append($$anchor, span);
		};
		$.if(node, ($$render) => {
			if (key()) $$render(consequent);
			else $$render(alternate, -1);
		});
		$.append($$anchor, fragment);
	};
	const $$d = $.derived(() => $$props.axes.slice(0, 4)), $$array = $.derived(() => $.to_array($.get($$d))), first = $.derived(() => $.get($$array)[0]), second = $.derived(() => $.get($$array)[1]), others = $.derived(() => $.get($$array).slice(2));
	const more = $.derived(() => $$props.axes.slice(4));
	const wheels = $.derived(() => machine.mode === "handle");
	const MOST_OF_WHEEL = 2;
	const inForce = $.derived(() => $$props.step !== null && $.get(wheels) ? Math.min($$props.step, MOST_OF_WHEEL) : $$props.step);
	const manual = $.derived(() => [
		"jog",
		"step",
		"home"
	].includes(machine.mode ?? ""));
	var fragment_2 = root_8();
	var div = $.first_child(fragment_2);
	var div_1 = $.child(div);
	var node_1 = $.sibling($.child(div_1));
	axis(node_1, () => $.get(second), () => "+");
	var node_2 = $.sibling(node_1, 3);
	axis(node_2, () => $.get(first), () => "−");
	var node_3 = $.sibling(node_2, 2);
	{
		let $0 = $.derived(() => t("panel.rapid"));
		Key(node_3, {
			signal: "KEY_RAPID",
			lamp: "LAMP_RAPID",
			get label() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var fragment_3 = root_2();
				var node_4 = $.first_child(fragment_3);
				Icon(node_4, { name: "right" });
				var span_1 = $.sibling(node_4);
				var text_1 = $.only_child(span_1, true);
				$.template_effect(($0) => $.set_text(text_1, $0), [() => t("panel.rapid")]);
				$.append($$anchor, fragment_3);
			},
			$$slots: { default: true }
		});
	}
	var node_5 = $.sibling(node_3, 2);
	axis(node_5, () => $.get(first), () => "+");
	axis($.sibling(node_5, 3), () => $.get(second), () => "−");
	$.next();
	$.reset(div_1);
	var node_7 = $.sibling(div_1, 2);
	$.each(node_7, 17, () => $.get(others), (other) => other.plus, ($$anchor, other) => {
		var div_2 = root_3();
		var node_8 = $.child(div_2);
		axis(node_8, () => $.get(other), () => "+");
		var node_9 = $.sibling(node_8, 2);
		axis(node_9, () => $.get(other), () => "−");
		$.reset(div_2);
		$.append($$anchor, div_2);
	});
	$.reset(div);
	var node_10 = $.sibling(div, 2);
	var consequent_1 = ($$anchor) => {
		var div_3 = root_5();
		$.each(div_3, 21, () => $.get(more), (other) => other.plus, ($$anchor, other) => {
			var fragment_4 = root_4();
			var node_11 = $.first_child(fragment_4);
			axis(node_11, () => $.get(other), () => "−");
			var node_12 = $.sibling(node_11);
			axis(node_12, () => $.get(other), () => "+");
			$.append($$anchor, fragment_4);
		});
		$.reset(div_3);
		$.append($$anchor, div_3);
	};
	$.if(node_10, ($$render) => {
		if ($.get(more).length) $$render(consequent_1);
	});
	var div_4 = $.sibling(node_10, 2);
	$.each(div_4, 23, () => increments, (increment) => increment.signal, ($$anchor, increment, index) => {
		{
			let $0 = $.derived(() => $.get(inForce) === $.get(index));
			let $1 = $.derived(() => $.get(wheels) && $.get(index) > MOST_OF_WHEEL);
			let $2 = $.derived(() => t("panel.increment_of", { value: $.get(increment).label }));
			Key($$anchor, {
				get signal() {
					return $.get(increment).signal;
				},
				get chosen() {
					return $.get($0);
				},
				get disabled() {
					return $.get($1);
				},
				get label() {
					return $.get($2);
				},
				children: ($$anchor, $$slotProps) => {
					var span_2 = root_6();
					var text_2 = $.only_child(span_2, true);
					$.template_effect(() => $.set_text(text_2, $.get(increment).label));
					$.append($$anchor, span_2);
				},
				$$slots: { default: true }
			});
		}
	});
	$.reset(div_4);
	var node_13 = $.sibling(div_4, 2);
	var consequent_2 = ($$anchor) => {
		var p = root_7();
		var text_3 = $.only_child(p, true);
		$.template_effect(($0) => $.set_text(text_3, $0), [() => t("panel.axes_hint")]);
		$.append($$anchor, p);
	};
	$.if(node_13, ($$render) => {
		if (!$.get(manual)) $$render(consequent_2);
	});
	$.template_effect(($0) => $.set_attribute(div_4, "aria-label", $0), [() => t("panel.increment")]);
	$.append($$anchor, fragment_2);
	$.pop();
}
export { AxisKeys as default };
