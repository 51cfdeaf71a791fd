import { t } from "../i18n/index.svelte.js";
import Button from "./Button.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Dialog.svelte
var root = $.from_html(`<footer class="s-gfkpoe"><!></footer>`);
var root_1 = $.from_html(`<header class="s-gfkpoe"><h2> </h2> <!></header> <div class="body scroll s-gfkpoe"><!></div> <!>`, 1);
var root_2 = $.from_html(`<dialog><!></dialog>`);
function Dialog($$anchor, $$props) {
	$.push($$props, true);
	let open = $.prop($$props, "open", 15, false), wide = $.prop($$props, "wide", 3, false);
	let dialog = $.state(void 0);
	$.user_effect(() => {
		if (open() && !$.get(dialog)?.open) $.get(dialog)?.showModal();
		else if (!open() && $.get(dialog)?.open) $.get(dialog).close();
	});
	var dialog_1 = root_2();
	let classes;
	var node = $.child(dialog_1);
	var consequent_1 = ($$anchor) => {
		var fragment = root_1();
		var header = $.first_child(fragment);
		var h2 = $.child(header);
		var text = $.only_child(h2, true);
		var node_1 = $.sibling(h2, 2);
		{
			let $0 = $.derived(() => t("app.close"));
			Button(node_1, {
				kind: "quiet",
				icon: "close",
				get "aria-label"() {
					return $.get($0);
				},
				onclick: () => open(false)
			});
		}
		$.reset(header);
		var div = $.sibling(header, 2);
		var node_2 = $.child(div);
		$.snippet(node_2, () => $$props.children);
		$.reset(div);
		var node_3 = $.sibling(div, 2);
		var consequent = ($$anchor) => {
			var footer = root();
			var node_4 = $.child(footer);
			$.snippet(node_4, () => $$props.actions);
			$.reset(footer);
			$.append($$anchor, footer);
		};
		$.if(node_3, ($$render) => {
			if ($$props.actions) $$render(consequent);
		});
		$.template_effect(() => $.set_text(text, $$props.title));
		$.append($$anchor, fragment);
	};
	$.if(node, ($$render) => {
		if (open()) $$render(consequent_1);
	});
	$.reset(dialog_1);
	$.bind_this(dialog_1, ($$value) => $.set(dialog, $$value), () => $.get(dialog));
	$.template_effect(() => {
		$.set_attribute(dialog_1, "aria-label", $$props.title);
		classes = $.set_class(dialog_1, 1, "s-gfkpoe", null, classes, { wide: wide() });
	});
	$.event("close", dialog_1, () => open(false));
	$.append($$anchor, dialog_1);
	$.pop();
}
export { Dialog as default };
