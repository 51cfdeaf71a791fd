import { t } from "../i18n/index.svelte.js";
import { dismiss, notices } from "../state/notices.svelte.js";
import Icon from "./Icon.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Notices.svelte
var root = $.from_html(`<span class="code muted s-w4p2my"> </span>`);
var root_1 = $.from_html(`<p class="s-w4p2my"> </p>`);
var root_2 = $.from_html(`<div><!> <div class="grow"><strong> </strong> <!> <!></div> <button type="button" class="s-w4p2my"><!></button></div>`);
var root_3 = $.from_html(`<div class="notices s-w4p2my" role="status" aria-live="polite"></div>`);
function Notices($$anchor, $$props) {
	$.push($$props, true);
	const icons = {
		info: "help",
		done: "check",
		warning: "alarms"
	};
	var div = root_3();
	$.each(div, 21, () => notices.list, (notice) => notice.id, ($$anchor, notice) => {
		var div_1 = root_2();
		var node = $.child(div_1);
		Icon(node, { get name() {
			return icons[$.get(notice).kind];
		} });
		var div_2 = $.sibling(node, 2);
		var strong = $.child(div_2);
		var text = $.only_child(strong, true);
		var node_1 = $.sibling(strong, 2);
		var consequent = ($$anchor) => {
			var span = root();
			var text_1 = $.only_child(span, true);
			$.template_effect(() => $.set_text(text_1, $.get(notice).code));
			$.append($$anchor, span);
		};
		$.if(node_1, ($$render) => {
			if ($.get(notice).code) $$render(consequent);
		});
		var node_2 = $.sibling(node_1, 2);
		var consequent_1 = ($$anchor) => {
			var p = root_1();
			var text_2 = $.only_child(p, true);
			$.template_effect(() => $.set_text(text_2, $.get(notice).text));
			$.append($$anchor, p);
		};
		$.if(node_2, ($$render) => {
			if ($.get(notice).text) $$render(consequent_1);
		});
		$.reset(div_2);
		var button = $.sibling(div_2, 2);
		var node_3 = $.child(button);
		Icon(node_3, { name: "close" });
		$.reset(button);
		$.reset(div_1);
		$.template_effect(($0) => {
			$.set_class(div_1, 1, `notice ${$.get(notice).kind ?? ""}`, "s-w4p2my");
			$.set_text(text, $.get(notice).title);
			$.set_attribute(button, "aria-label", $0);
		}, [() => t("app.close")]);
		$.delegated("click", button, () => dismiss($.get(notice).id));
		$.append($$anchor, div_1);
	});
	$.reset(div);
	$.append($$anchor, div);
	$.pop();
}
$.delegate(["click"]);
export { Notices as default };
