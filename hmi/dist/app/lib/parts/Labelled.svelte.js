import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Labelled.svelte
var root = $.from_html(`<span class="hint s-l0mzc1"> </span>`);
var root_1 = $.from_html(`<label class="s-l0mzc1"><span class="name s-l0mzc1"> </span> <!> <!></label>`);
function Labelled($$anchor, $$props) {
	let hint = $.prop($$props, "hint", 3, "");
	var label_1 = root_1();
	var span = $.child(label_1);
	var text = $.only_child(span, true);
	var node = $.sibling(span, 2);
	$.snippet(node, () => $$props.children);
	var node_1 = $.sibling(node, 2);
	var consequent = ($$anchor) => {
		var span_1 = root();
		var text_1 = $.only_child(span_1, true);
		$.template_effect(() => $.set_text(text_1, hint()));
		$.append($$anchor, span_1);
	};
	$.if(node_1, ($$render) => {
		if (hint()) $$render(consequent);
	});
	$.reset(label_1);
	$.template_effect(() => $.set_text(text, $$props.label));
	$.append($$anchor, label_1);
}
export { Labelled as default };
