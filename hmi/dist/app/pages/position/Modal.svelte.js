import { t } from "../../lib/i18n/index.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import { href } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/position/Modal.svelte
var root = $.from_html(`<a class="s-lo14b6"> </a>`);
var root_1 = $.from_html(`<span class="s-lo14b6"> </span>`);
var root_2 = $.from_html(`<div class="switches s-lo14b6"></div>`);
var root_3 = $.from_html(`<div class="codes code s-lo14b6"></div> <!> <!>`, 1);
function Modal($$anchor, $$props) {
	$.push($$props, true);
	/** Values in force beside the codes. */
	const codes = $.derived(() => machine.status.program.g_codes);
	const switches = $.derived(() => machine.status.switches);
	/** Those that bear on what is done: all that are on, but programs are closed while their switch is off. */
	const on = $.derived(() => Object.keys($.get(switches)).filter((name) => $.get(switches)[name] === (name !== "programs")));
	{
		let $0 = $.derived(() => t("position.modal"));
		Card($$anchor, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var fragment_1 = root_3();
				var div = $.first_child(fragment_1);
				$.each(div, 21, () => $.get(codes), $.index, ($$anchor, code) => {
					var a = root();
					var text = $.only_child(a, true);
					$.template_effect(($0) => {
						$.set_attribute(a, "href", $0);
						$.set_text(text, $.get(code));
					}, [() => href("help", "codes", $.get(code))]);
					$.append($$anchor, a);
				});
				$.reset(div);
				var node = $.sibling(div, 2);
				$.snippet(node, () => $$props.children ?? $.noop);
				var node_1 = $.sibling(node, 2);
				var consequent = ($$anchor) => {
					var div_1 = root_2();
					$.each(div_1, 20, () => $.get(on), (name) => name, ($$anchor, name) => {
						var span = root_1();
						var text_1 = $.only_child(span, true);
						$.template_effect(($0) => $.set_text(text_1, $0), [() => t(`position.${name}`)]);
						$.append($$anchor, span);
					});
					$.reset(div_1);
					$.append($$anchor, div_1);
				};
				$.if(node_1, ($$render) => {
					if ($.get(on).length) $$render(consequent);
				});
				$.append($$anchor, fragment_1);
			},
			$$slots: { default: true }
		});
	}
	$.pop();
}
export { Modal as default };
