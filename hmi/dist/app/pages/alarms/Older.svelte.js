import { number, t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/alarms/Older.svelte
var root = $.from_html(`<p class="row wrap s-1w91kp1"><span class="muted"> </span> <!></p>`);
function Older($$anchor, $$props) {
	$.push($$props, true);
	let most = $.prop($$props, "most", 15);
	var fragment = $.comment();
	var node = $.first_child(fragment);
	var consequent_1 = ($$anchor) => {
		var p = root();
		var span = $.child(p);
		var text = $.only_child(span, true);
		var node_1 = $.sibling(span, 2);
		var consequent = ($$anchor) => {
			Button($$anchor, {
				icon: "down",
				onclick: () => most(Math.min($$props.last, most() + $$props.step)),
				"data-testid": "older",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_1 = $.text();
					$.template_effect(($0) => $.set_text(text_1, $0), [() => t("alarms.older")]);
					$.append($$anchor, text_1);
				},
				$$slots: { default: true }
			});
		};
		$.if(node_1, ($$render) => {
			if ($$props.count >= most() && most() < $$props.last) $$render(consequent);
		});
		$.reset(p);
		$.template_effect(($0) => $.set_text(text, $0), [() => t("alarms.entries", {
			count: $$props.count,
			n: number($$props.count)
		})]);
		$.append($$anchor, p);
	};
	$.if(node, ($$render) => {
		if ($$props.count > 0) $$render(consequent_1);
	});
	$.append($$anchor, fragment);
	$.pop();
}
export { Older as default };
