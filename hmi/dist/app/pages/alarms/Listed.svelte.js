import { t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/alarms/Listed.svelte
var root = $.from_html(`<!> <!>`, 1);
var root_1 = $.from_html(`<th> </th>`);
var root_2 = $.from_html(`<table class="table s-bs45du"><thead><tr></tr></thead><tbody><!></tbody></table> <!>`, 1);
function Listed($$anchor, $$props) {
	$.push($$props, true);
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var node = $.first_child(fragment_1);
			$.snippet(node, () => $$props.tools ?? $.noop);
			var node_1 = $.sibling(node, 2);
			{
				let $0 = $.derived(() => machine.level > 3 || $$props.count === 0);
				let $1 = $.derived(() => t("alarms.clear_right"));
				Button(node_1, {
					kind: "danger",
					icon: "trash",
					get disabled() {
						return $.get($0);
					},
					get title() {
						return $.get($1);
					},
					onclick: () => void $$props.clear(),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text = $.text();
						$.template_effect(($0) => $.set_text(text, $0), [() => t("alarms.clear")]);
						$.append($$anchor, text);
					},
					$$slots: { default: true }
				});
			}
			$.append($$anchor, fragment_1);
		};
		Card($$anchor, {
			get title() {
				return $$props.title;
			},
			fill: true,
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_3 = $.comment();
				var node_2 = $.first_child(fragment_3);
				var consequent = ($$anchor) => {
					Empty($$anchor, {
						icon: "alarms",
						get title() {
							return $$props.none.title;
						},
						get text() {
							return $$props.none.text;
						}
					});
				};
				var alternate = ($$anchor) => {
					var fragment_5 = root_2();
					var table = $.first_child(fragment_5);
					var thead = $.child(table);
					var tr = $.child(thead);
					$.each(tr, 20, () => $$props.heads, (head) => head, ($$anchor, head) => {
						var th = root_1();
						var text_1 = $.only_child(th, true);
						$.template_effect(() => $.set_text(text_1, head));
						$.append($$anchor, th);
					});
					$.reset(tr);
					$.reset(thead);
					var tbody = $.sibling(thead);
					var node_3 = $.child(tbody);
					$.snippet(node_3, () => $$props.rows);
					$.reset(tbody);
					$.reset(table);
					var node_4 = $.sibling(table, 2);
					$.snippet(node_4, () => $$props.children);
					$.template_effect(() => $.set_attribute(table, "data-testid", $$props.id));
					$.append($$anchor, fragment_5);
				};
				$.if(node_2, ($$render) => {
					if ($$props.none && $$props.count === 0) $$render(consequent);
					else $$render(alternate, -1);
				});
				$.append($$anchor, fragment_3);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.pop();
}
export { Listed as default };
