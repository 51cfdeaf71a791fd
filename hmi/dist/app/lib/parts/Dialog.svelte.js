import { t } from "../i18n/index.svelte.js";
import { machine } from "../state/machine.svelte.js";
import Button from "./Button.svelte.js";
import StopButton from "./StopButton.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Dialog.svelte
var root = $.from_html(`<footer class="s-vocvxm"><!></footer>`);
var root_1 = $.from_html(`<header class="s-vocvxm"><h2 class="grow"> </h2> <span class="close s-vocvxm"><!></span> <!></header> <div class="body scroll s-vocvxm"><!></div> <!>`, 1);
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
	var consequent_2 = ($$anchor) => {
		var fragment = root_1();
		var header = $.first_child(fragment);
		var h2 = $.child(header);
		var text = $.only_child(h2, true);
		var span = $.sibling(h2, 2);
		var node_1 = $.child(span);
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
		$.reset(span);
		var node_2 = $.sibling(span, 2);
		var consequent = ($$anchor) => {
			StopButton($$anchor, {
				flat: true,
				"data-testid": "dialog-emergency"
			});
		};
		$.if(node_2, ($$render) => {
			if (!machine.gate) $$render(consequent);
		});
		$.reset(header);
		var div = $.sibling(header, 2);
		var node_3 = $.child(div);
		$.snippet(node_3, () => $$props.children);
		$.reset(div);
		var node_4 = $.sibling(div, 2);
		var consequent_1 = ($$anchor) => {
			var footer = root();
			var node_5 = $.child(footer);
			$.snippet(node_5, () => $$props.actions);
			$.reset(footer);
			$.append($$anchor, footer);
		};
		$.if(node_4, ($$render) => {
			if ($$props.actions) $$render(consequent_1);
		});
		$.template_effect(() => $.set_text(text, $$props.title));
		$.append($$anchor, fragment);
	};
	$.if(node, ($$render) => {
		if (open()) $$render(consequent_2);
	});
	$.reset(dialog_1);
	$.bind_this(dialog_1, ($$value) => $.set(dialog, $$value), () => $.get(dialog));
	$.template_effect(() => {
		$.set_attribute(dialog_1, "aria-label", $$props.title);
		classes = $.set_class(dialog_1, 1, "s-vocvxm", null, classes, { wide: wide() });
	});
	$.event("close", dialog_1, () => open(false));
	$.append($$anchor, dialog_1);
	$.pop();
}
export { Dialog as default };
