import { display } from "../state/display.svelte.js";
import Tabs from "./Tabs.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Page.svelte
var root = $.from_html(`<div class="page s-ot62sx"><!> <div class="content scroll s-ot62sx"><!></div></div>`);
function Page($$anchor, $$props) {
	$.push($$props, true);
	let tabs = $.prop($$props, "tabs", 19, () => []), active = $.prop($$props, "active", 3, "");
	$.user_effect(() => display.has($$props.page, tabs().map((tab) => tab.id), active()));
	var div = root();
	var node = $.child(div);
	var consequent = ($$anchor) => {
		Tabs($$anchor, {
			get page() {
				return $$props.page;
			},
			get tabs() {
				return tabs();
			},
			get active() {
				return active();
			}
		});
	};
	$.if(node, ($$render) => {
		if (tabs().length) $$render(consequent);
	});
	var div_1 = $.sibling(node, 2);
	var node_1 = $.child(div_1);
	$.snippet(node_1, () => $$props.children);
	$.reset(div_1);
	$.reset(div);
	$.template_effect(() => $.set_attribute(div, "data-page", $$props.page));
	$.append($$anchor, div);
	$.pop();
}
export { Page as default };
