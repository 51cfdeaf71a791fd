import { href, route } from "../routing.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Tabs.svelte
var root = $.from_html(`<a> </a>`);
var root_1 = $.from_html(`<nav class="tabs scroll s-stzfmh"></nav>`);
function Tabs($$anchor, $$props) {
	$.push($$props, true);
	var nav = root_1();
	$.each(nav, 21, () => $$props.tabs, (tab) => tab.id, ($$anchor, tab) => {
		var a = root();
		let classes;
		var text = $.only_child(a, true);
		$.template_effect(($0) => {
			$.set_attribute(a, "href", $0);
			$.set_attribute(a, "aria-current", $$props.active === $.get(tab).id && route.page === $$props.page ? "page" : void 0);
			classes = $.set_class(a, 1, "s-stzfmh", null, classes, { active: $$props.active === $.get(tab).id });
			$.set_text(text, $.get(tab).label);
		}, [() => href($$props.page, $.get(tab).id)]);
		$.append($$anchor, a);
	});
	$.reset(nav);
	$.append($$anchor, nav);
	$.pop();
}
export { Tabs as default };
