import Icon from "./Icon.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Empty.svelte
var root = $.from_html(`<p class="muted s-1ma6fdf"> </p>`);
var root_1 = $.from_html(`<div class="row wrap"><!></div>`);
var root_2 = $.from_html(`<div class="empty s-1ma6fdf"><!> <h2 class="s-1ma6fdf"> </h2> <!> <!></div>`);
function Empty($$anchor, $$props) {
	let text = $.prop($$props, "text", 3, "");
	var div = root_2();
	var node = $.child(div);
	Icon(node, {
		get name() {
			return $$props.icon;
		},
		size: "2.6rem"
	});
	var h2 = $.sibling(node, 2);
	var text_1 = $.only_child(h2, true);
	var node_1 = $.sibling(h2, 2);
	var consequent = ($$anchor) => {
		var p = root();
		var text_2 = $.only_child(p, true);
		$.template_effect(() => $.set_text(text_2, text()));
		$.append($$anchor, p);
	};
	$.if(node_1, ($$render) => {
		if (text()) $$render(consequent);
	});
	var node_2 = $.sibling(node_1, 2);
	var consequent_1 = ($$anchor) => {
		var div_1 = root_1();
		var node_3 = $.child(div_1);
		$.snippet(node_3, () => $$props.children);
		$.reset(div_1);
		$.append($$anchor, div_1);
	};
	$.if(node_2, ($$render) => {
		if ($$props.children) $$render(consequent_1);
	});
	$.reset(div);
	$.template_effect(() => $.set_text(text_1, $$props.title));
	$.append($$anchor, div);
}
export { Empty as default };
