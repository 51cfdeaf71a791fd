import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/help/Explained.svelte
var root = $.from_html(`<p class="muted s-eg72h1"> </p>`);
var root_1 = $.from_html(`<pre class="s-eg72h1"> </pre> <!>`, 1);
function Explained($$anchor, $$props) {
	$.push($$props, true);
	var fragment = root_1();
	var pre = $.first_child(fragment);
	var text = $.only_child(pre, true);
	var node = $.sibling(pre, 2);
	var consequent = ($$anchor) => {
		var p = root();
		var text_1 = $.only_child(p, true);
		$.template_effect(() => $.set_text(text_1, $$props.about.source));
		$.append($$anchor, p);
	};
	$.if(node, ($$render) => {
		if ($$props.about.source) $$render(consequent);
	});
	$.template_effect(() => $.set_text(text, $$props.about.text));
	$.append($$anchor, fragment);
	$.pop();
}
export { Explained as default };
