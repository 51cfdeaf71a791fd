import { t } from "../lib/i18n/index.svelte.js";
import Icon from "../lib/parts/Icon.svelte.js";
import { machine } from "../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/Banner.svelte
var root = $.from_html(`<div class="banner lost s-juni7l" role="alert"><!><span> </span></div>`);
var root_1 = $.from_html(`<div class="banner s-juni7l"><!><span> </span></div>`);
function Banner($$anchor, $$props) {
	$.push($$props, true);
	var fragment = $.comment();
	var node = $.first_child(fragment);
	var consequent = ($$anchor) => {};
	var consequent_1 = ($$anchor) => {
		var div = root();
		var node_1 = $.child(div);
		Icon(node_1, { name: "link" });
		var span = $.sibling(node_1);
		var text = $.only_child(span, true);
		$.reset(div);
		$.template_effect(($0) => $.set_text(text, $0), [() => t("app.lost_text")]);
		$.append($$anchor, div);
	};
	var consequent_2 = ($$anchor) => {
		var div_1 = root_1();
		var node_2 = $.child(div_1);
		Icon(node_2, { name: "eye" });
		var span_1 = $.sibling(node_2);
		var text_1 = $.only_child(span_1, true);
		$.reset(div_1);
		$.template_effect(($0) => $.set_text(text_1, $0), [() => t("app.watching_text")]);
		$.append($$anchor, div_1);
	};
	$.if(node, ($$render) => {
		if (machine.gate) $$render(consequent);
		else if (machine.link !== "open") $$render(consequent_1, 1);
		else if (machine.holder !== null && !machine.inCommand) $$render(consequent_2, 2);
	});
	$.append($$anchor, fragment);
	$.pop();
}
export { Banner as default };
