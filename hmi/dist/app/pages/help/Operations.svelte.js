import { t } from "../../lib/i18n/index.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import { href } from "../../lib/routing.svelte.js";
import { notHere, operations } from "./operations.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/help/Operations.svelte
var root = $.from_html(`<div class="s-1iqu4us"><dt class="s-1iqu4us"><a class="s-1iqu4us"> <!></a></dt> <dd class="s-1iqu4us"> </dd></div>`);
var root_1 = $.from_html(`<div class="s-1iqu4us"><dt class="s-1iqu4us"> <small class="muted number"> </small></dt> <dd class="s-1iqu4us"> </dd></div>`);
var root_2 = $.from_html(`<h2 class="s-1iqu4us"> </h2> <dl class="s-1iqu4us"></dl>`, 1);
var root_3 = $.from_html(`<input type="search"/> <div class="scroll all s-1iqu4us"><dl class="s-1iqu4us"></dl> <!></div>`, 1);
function Operations($$anchor, $$props) {
	$.push($$props, true);
	let filter = $.state("");
	const sought = $.derived(() => $.get(filter).trim().toLowerCase());
	const has = (...texts) => texts.join(" ").toLowerCase().includes($.get(sought));
	const shown = $.derived(() => operations.filter(([id]) => has(t(`operations.${id}`), t(`operations.${id}_how`))));
	const missing = $.derived(() => notHere.filter(([id]) => has(t(`operations.not_${id}`), t(`operations.not_${id}_why`))));
	var fragment = root_3();
	var input = $.first_child(fragment);
	$.remove_input_defaults(input);
	var div = $.sibling(input, 2);
	var dl = $.child(div);
	$.each(dl, 21, () => $.get(shown), ([id, page]) => id, ($$anchor, $$item) => {
		var $$array = $.derived(() => $.to_array($.get($$item), 2));
		let id = () => $.get($$array)[0];
		let page = () => $.get($$array)[1];
		var div_1 = root();
		var dt = $.child(div_1);
		var a = $.child(dt);
		var text = $.child(a, true);
		var node = $.sibling(text);
		Icon(node, {
			name: "play",
			size: "0.8rem"
		});
		$.reset(a);
		$.reset(dt);
		var dd = $.sibling(dt, 2);
		var text_1 = $.only_child(dd, true);
		$.reset(div_1);
		$.template_effect(($0, $1, $2) => {
			$.set_attribute(div_1, "data-operation", id());
			$.set_attribute(a, "href", $0);
			$.set_text(text, $1);
			$.set_text(text_1, $2);
		}, [
			() => href(...page().split("/")),
			() => t(`operations.${id()}`),
			() => t(`operations.${id()}_how`)
		]);
		$.append($$anchor, div_1);
	});
	$.reset(dl);
	var node_1 = $.sibling(dl, 2);
	var consequent = ($$anchor) => {
		var fragment_1 = root_2();
		var h2 = $.first_child(fragment_1);
		var text_2 = $.only_child(h2, true);
		var dl_1 = $.sibling(h2, 2);
		$.each(dl_1, 21, () => $.get(missing), ([id, section]) => id, ($$anchor, $$item) => {
			var $$array_1 = $.derived(() => $.to_array($.get($$item), 2));
			let id = () => $.get($$array_1)[0];
			let section = () => $.get($$array_1)[1];
			var div_2 = root_1();
			var dt_1 = $.child(div_2);
			var text_3 = $.child(dt_1);
			var small = $.sibling(text_3);
			var text_4 = $.only_child(small, true);
			$.reset(dt_1);
			var dd_1 = $.sibling(dt_1, 2);
			var text_5 = $.only_child(dd_1, true);
			$.reset(div_2);
			$.template_effect(($0, $1) => {
				$.set_attribute(div_2, "data-not-here", id());
				$.set_text(text_3, `${$0 ?? ""} `);
				$.set_text(text_4, section());
				$.set_text(text_5, $1);
			}, [() => t(`operations.not_${id()}`), () => t(`operations.not_${id()}_why`)]);
			$.append($$anchor, div_2);
		});
		$.reset(dl_1);
		$.template_effect(($0) => $.set_text(text_2, $0), [() => t("help.not_here")]);
		$.append($$anchor, fragment_1);
	};
	$.if(node_1, ($$render) => {
		if ($.get(missing).length) $$render(consequent);
	});
	$.reset(div);
	$.template_effect(($0, $1) => {
		$.set_attribute(input, "placeholder", $0);
		$.set_attribute(input, "aria-label", $1);
	}, [() => t("app.search"), () => t("app.search")]);
	$.bind_value(input, () => $.get(filter), ($$value) => $.set(filter, $$value));
	$.append($$anchor, fragment);
	$.pop();
}
export { Operations as default };
