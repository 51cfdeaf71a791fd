import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Card.svelte
var root = $.from_html(`<div class="row wrap"><!></div>`);
var root_1 = $.from_html(`<header class="s-11jt8f9"><h2> </h2> <!></header>`);
var root_2 = $.from_html(`<section><!> <div><!></div></section>`);
function Card($$anchor, $$props) {
	let title = $.prop($$props, "title", 3, ""), flush = $.prop($$props, "flush", 3, false), fill = $.prop($$props, "fill", 3, false);
	var section = root_2();
	let classes;
	var node = $.child(section);
	var consequent_1 = ($$anchor) => {
		var header = root_1();
		var h2 = $.child(header);
		var text = $.only_child(h2, true);
		var node_1 = $.sibling(h2, 2);
		var consequent = ($$anchor) => {
			var div = root();
			var node_2 = $.child(div);
			$.snippet(node_2, () => $$props.actions);
			$.reset(div);
			$.append($$anchor, div);
		};
		$.if(node_1, ($$render) => {
			if ($$props.actions) $$render(consequent);
		});
		$.reset(header);
		$.template_effect(() => $.set_text(text, title()));
		$.append($$anchor, header);
	};
	$.if(node, ($$render) => {
		if (title() || $$props.actions) $$render(consequent_1);
	});
	var div_1 = $.sibling(node, 2);
	let classes_1;
	var node_3 = $.child(div_1);
	$.snippet(node_3, () => $$props.children);
	$.reset(div_1);
	$.reset(section);
	$.template_effect(() => {
		classes = $.set_class(section, 1, "card s-11jt8f9", null, classes, { fill: fill() });
		classes_1 = $.set_class(div_1, 1, "body s-11jt8f9", null, classes_1, {
			flush: flush(),
			scroll: fill()
		});
	});
	$.append($$anchor, section);
}
export { Card as default };
