import Icon from "./Icon.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Button.svelte
var rest_excludes = /* @__PURE__ */ new Set([
	"$$slots",
	"$$events",
	"$$legacy",
	"children",
	"icon",
	"kind",
	"busy",
	"pressed"
]);
var root = $.from_html(`<span><!></span>`);
var root_1 = $.from_html(`<button><!> <!></button>`);
function Button($$anchor, $$props) {
	$.push($$props, true);
	let kind = $.prop($$props, "kind", 3, "plain"), busy = $.prop($$props, "busy", 3, false), rest = $.rest_props($$props, rest_excludes);
	var button = root_1();
	$.attribute_effect(button, () => ({
		type: "button",
		...rest,
		class: `button ${kind() ?? ""}`,
		"aria-pressed": $$props.pressed,
		"aria-busy": busy(),
		disabled: $$props.disabled || busy(),
		[$.CLASS]: { alone: !$$props.children }
	}), void 0, void 0, void 0, "s-18aa7ws");
	var node = $.child(button);
	var consequent = ($$anchor) => {
		Icon($$anchor, { get name() {
			return $$props.icon;
		} });
	};
	$.if(node, ($$render) => {
		if ($$props.icon) $$render(consequent);
	});
	var node_1 = $.sibling(node, 2);
	var consequent_1 = ($$anchor) => {
		var span = root();
		var node_2 = $.child(span);
		$.snippet(node_2, () => $$props.children);
		$.reset(span);
		$.append($$anchor, span);
	};
	$.if(node_1, ($$render) => {
		if ($$props.children) $$render(consequent_1);
	});
	$.reset(button);
	$.append($$anchor, button);
	$.pop();
}
export { Button as default };
