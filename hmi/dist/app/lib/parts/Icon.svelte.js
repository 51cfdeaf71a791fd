import { icons } from "./icons.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Icon.svelte
var root = $.from_svg(`<svg viewBox="0 0 24 24" aria-hidden="true"><path></path></svg>`);
function Icon($$anchor, $$props) {
	$.push($$props, true);
	let size = $.prop($$props, "size", 3, "1.25em"), fill = $.prop($$props, "fill", 3, false);
	var svg = root();
	let classes;
	var path = $.only_child(svg);
	$.template_effect(() => {
		$.set_attribute(svg, "width", size());
		$.set_attribute(svg, "height", size());
		classes = $.set_class(svg, 0, "s-1qa08u2", null, classes, { fill: fill() });
		$.set_attribute(path, "d", icons[$$props.name]);
	});
	$.append($$anchor, svg);
	$.pop();
}
export { Icon as default };
