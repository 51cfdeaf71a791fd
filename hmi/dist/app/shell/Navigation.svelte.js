import { t } from "../lib/i18n/index.svelte.js";
import Icon from "../lib/parts/Icon.svelte.js";
import { href } from "../lib/routing.svelte.js";
import { display } from "../lib/state/display.svelte.js";
import { machine } from "../lib/state/machine.svelte.js";
import { pages } from "../pages/index.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/Navigation.svelte
var root = $.from_html(`<b class="number s-k5ec52"> </b>`);
var root_1 = $.from_html(`<a><!> <span> </span> <!></a>`);
var root_2 = $.from_html(`<nav class="scroll s-k5ec52"></nav>`);
function Navigation($$anchor, $$props) {
	$.push($$props, true);
	const standing = $.derived(() => machine.status?.alarms.length ?? 0);
	var nav = root_2();
	$.each(nav, 21, () => pages, (page) => page.id, ($$anchor, page) => {
		var a = root_1();
		let classes;
		var node = $.child(a);
		Icon(node, {
			get name() {
				return $.get(page).icon;
			},
			size: "1.5rem"
		});
		var span = $.sibling(node, 2);
		var text = $.only_child(span, true);
		var node_1 = $.sibling(span, 2);
		var consequent = ($$anchor) => {
			var b = root();
			var text_1 = $.only_child(b, true);
			$.template_effect(() => $.set_text(text_1, $.get(standing)));
			$.append($$anchor, b);
		};
		$.if(node_1, ($$render) => {
			if ($.get(page).id === "alarms" && $.get(standing) > 0) $$render(consequent);
		});
		$.reset(a);
		$.template_effect(($0, $1) => {
			$.set_attribute(a, "href", $0);
			$.set_attribute(a, "aria-current", $.get(page).id === $$props.current ? "page" : void 0);
			classes = $.set_class(a, 1, "s-k5ec52", null, classes, { current: $.get(page).id === $$props.current });
			$.set_text(text, $1);
		}, [() => href(...display.to($.get(page).id)), () => t(`${$.get(page).id}.title`)]);
		$.append($$anchor, a);
	});
	$.reset(nav);
	$.template_effect(($0) => $.set_attribute(nav, "aria-label", $0), [() => t("app.pages")]);
	$.append($$anchor, nav);
	$.pop();
}
export { Navigation as default };
