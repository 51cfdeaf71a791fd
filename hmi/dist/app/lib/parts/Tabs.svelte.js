import { href, route } from "../routing.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Tabs.svelte
var root = $.from_html(`<a> </a>`);
var root_1 = $.from_html(`<div class="frame s-jx3l4b"><nav class="tabs s-jx3l4b"></nav></div>`);
function Tabs($$anchor, $$props) {
	$.push($$props, true);
	var div = root_1();
	var nav = $.child(div);
	$.each(nav, 21, () => $$props.tabs, (tab) => tab.id, ($$anchor, tab) => {
		var a = root();
		let classes;
		var text = $.only_child(a, true);
		$.template_effect(($0) => {
			$.set_attribute(a, "href", $0);
			$.set_attribute(a, "aria-current", $$props.active === $.get(tab).id && route.page === $$props.page ? "page" : void 0);
			classes = $.set_class(a, 1, "s-jx3l4b", null, classes, { active: $$props.active === $.get(tab).id });
			$.set_text(text, $.get(tab).label);
		}, [() => href($$props.page, $.get(tab).id)]);
		$.append($$anchor, a);
	});
	$.reset(nav);
	$.reset(div);
	$.append($$anchor, div);
	$.pop();
}
export { Tabs as default };
