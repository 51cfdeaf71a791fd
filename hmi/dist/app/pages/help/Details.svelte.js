import { http } from "../../lib/api/http.js";
import { language, t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import { go } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Explained from "./Explained.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/help/Details.svelte
var root = $.from_html(`<p> </p>`);
var root_1 = $.from_html(`<h2><span class="code"> </span> </h2> <!> <div class="row wrap"><!> <!></div>`, 1);
var root_2 = $.from_html(`<div class="detail stack scroll" data-testid="help-detail"><!></div>`);
function Details($$anchor, $$props) {
	$.push($$props, true);
	/** What stands here while there is none. */
	let about = $.state(null);
	$.user_effect(() => {
		const one = $$props.entry;
		$.set(about, null);
		if (one && one.kind !== "signal") http.explain(one.key, machine.dialect, language()).then((now) => one === $$props.entry ? $.set(about, now) : null, () => void 0);
	});
	var div = root_2();
	var node = $.child(div);
	var consequent_3 = ($$anchor) => {
		const computed_const = $.derived(() => {
			return $$props.entry;
		});
		var fragment = root_1();
		var h2 = $.first_child(fragment);
		var span = $.child(h2);
		var text = $.only_child(span, true);
		var text_1 = $.sibling(span);
		$.reset(h2);
		var node_1 = $.sibling(h2, 2);
		var consequent = ($$anchor) => {
			Explained($$anchor, { get about() {
				return $.get(about);
			} });
		};
		var alternate = ($$anchor) => {
			var p = root();
			var text_2 = $.only_child(p, true);
			$.template_effect(() => $.set_text(text_2, $$props.entry.text));
			$.append($$anchor, p);
		};
		$.if(node_1, ($$render) => {
			if ($.get(about)?.found) $$render(consequent);
			else $$render(alternate, -1);
		});
		var div_1 = $.sibling(node_1, 2);
		var node_2 = $.child(div_1);
		var consequent_1 = ($$anchor) => {
			Button($$anchor, {
				icon: "system",
				onclick: () => go("offsets", "parameters", $.get(computed_const).key),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_3 = $.text();
					$.template_effect(($0) => $.set_text(text_3, $0), [() => t("offsets.parameters")]);
					$.append($$anchor, text_3);
				},
				$$slots: { default: true }
			});
		};
		$.if(node_2, ($$render) => {
			if ($.get(computed_const).kind === "parameter") $$render(consequent_1);
		});
		var node_3 = $.sibling(node_2, 2);
		var consequent_2 = ($$anchor) => {
			Button($$anchor, {
				icon: "diagnosis",
				onclick: () => go("diagnosis", "signals", $.get(computed_const).key),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_4 = $.text();
					$.template_effect(($0) => $.set_text(text_4, $0), [() => t("diagnosis.signals")]);
					$.append($$anchor, text_4);
				},
				$$slots: { default: true }
			});
		};
		$.if(node_3, ($$render) => {
			if ($.get(computed_const).kind === "signal") $$render(consequent_2);
		});
		$.reset(div_1);
		$.template_effect(() => {
			$.set_text(text, $.get(computed_const).key);
			$.set_text(text_1, ` ${$$props.entry.title ?? ""}`);
		});
		$.append($$anchor, fragment);
	};
	var alternate_1 = ($$anchor) => {
		var fragment_6 = $.comment();
		var node_4 = $.first_child(fragment_6);
		$.snippet(node_4, () => $$props.children);
		$.append($$anchor, fragment_6);
	};
	$.if(node, ($$render) => {
		if ($$props.entry) $$render(consequent_3);
		else $$render(alternate_1, -1);
	});
	$.reset(div);
	$.append($$anchor, div);
	$.pop();
}
export { Details as default };
