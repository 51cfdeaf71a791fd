import { t } from "../../lib/i18n/index.svelte.js";
import { PLACE } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/position/Relative.svelte
var root = $.from_html(`<div class="tools s-1afj24c"><!> <!> <span class="value s-1afj24c"><!></span></div>`);
function Relative($$anchor, $$props) {
	$.push($$props, true);
	var div = root();
	var node = $.child(div);
	{
		let $0 = $.derived(() => `zero-${$$props.axis}`);
		Button(node, {
			onclick: () => void machine.tell({
				do: "relative",
				axis: $$props.axis,
				to: "zero"
			}),
			get "data-testid"() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text = $.text();
				$.template_effect(() => $.set_text(text, `${$$props.axis ?? ""} = 0`));
				$.append($$anchor, text);
			},
			$$slots: { default: true }
		});
	}
	var node_1 = $.sibling(node, 2);
	Button(node_1, {
		onclick: () => void machine.tell({
			do: "relative",
			axis: $$props.axis,
			to: "half"
		}),
		children: ($$anchor, $$slotProps) => {
			$.next();
			var text_1 = $.text();
			$.template_effect(() => $.set_text(text_1, `${$$props.axis ?? ""} / 2`));
			$.append($$anchor, text_1);
		},
		$$slots: { default: true }
	});
	var span = $.sibling(node_1, 2);
	var node_2 = $.child(span);
	{
		let $0 = $.derived(() => -PLACE);
		let $1 = $.derived(() => t("position.set", { axis: $$props.axis }));
		NumberField(node_2, {
			value: null,
			empty: true,
			get minimum() {
				return $.get($0);
			},
			get maximum() {
				return PLACE;
			},
			get label() {
				return $.get($1);
			},
			onvalue: (value) => {
				if (value !== null) machine.tell({
					do: "relative",
					axis: $$props.axis,
					to: { value }
				});
			}
		});
	}
	$.reset(span);
	$.reset(div);
	$.append($$anchor, div);
	$.pop();
}
export { Relative as default };
