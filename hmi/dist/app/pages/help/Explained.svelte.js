import { href } from "../../lib/routing.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/help/Explained.svelte
var root = $.from_html(`<dt class="s-1fuvnz5"> </dt><dd class="s-1fuvnz5"> </dd>`, 1);
var root_1 = $.from_html(`<dl class="s-1fuvnz5"></dl>`);
var root_2 = $.from_html(`<span class="number s-1fuvnz5"> </span>`);
var root_3 = $.from_html(`<a class="code s-1fuvnz5"> </a> <!> <span class="s-1fuvnz5"> </span>`, 1);
var root_4 = $.from_html(`<section class="s-1fuvnz5"><h3> </h3> <div></div></section>`);
var root_5 = $.from_html(`<!> <!>`, 1);
function Explained($$anchor, $$props) {
	$.push($$props, true);
	var fragment = root_5();
	var node = $.first_child(fragment);
	var consequent = ($$anchor) => {
		var dl = root_1();
		$.each(dl, 21, () => $$props.about.facts, $.index, ($$anchor, fact) => {
			var fragment_1 = root();
			var dt = $.first_child(fragment_1);
			var text = $.only_child(dt, true);
			var dd = $.sibling(dt);
			var text_1 = $.only_child(dd, true);
			$.template_effect(() => {
				$.set_text(text, $.get(fact).label);
				$.set_text(text_1, $.get(fact).text);
			});
			$.append($$anchor, fragment_1);
		});
		$.reset(dl);
		$.append($$anchor, dl);
	};
	$.if(node, ($$render) => {
		if ($$props.about.facts.length) $$render(consequent);
	});
	var node_1 = $.sibling(node, 2);
	$.each(node_1, 17, () => $$props.about.tables, $.index, ($$anchor, table) => {
		var section = root_4();
		var h3 = $.child(section);
		var text_2 = $.only_child(h3, true);
		var div = $.sibling(h3, 2);
		let classes;
		$.each(div, 21, () => $.get(table).rows, $.index, ($$anchor, $$item, index, $$array) => {
			var $$array_1 = $.derived(() => $.to_array($.get($$item)));
			let name = $.derived_safe_equal(() => $.fallback($.get($$array_1)[0], ""));
			let rest = () => $.get($$array_1).slice(1);
			var fragment_2 = root_3();
			var a = $.first_child(fragment_2);
			var text_3 = $.only_child(a, true);
			var node_2 = $.sibling(a, 2);
			var consequent_1 = ($$anchor) => {
				var span = root_2();
				var text_4 = $.only_child(span, true);
				$.template_effect(() => $.set_text(text_4, rest()[0]));
				$.append($$anchor, span);
			};
			$.if(node_2, ($$render) => {
				if (rest().length > 1) $$render(consequent_1);
			});
			var span_1 = $.sibling(node_2, 2);
			var text_5 = $.only_child(span_1, true);
			$.template_effect(($0, $1) => {
				$.set_attribute(a, "href", $0);
				$.set_text(text_3, $.get(name));
				$.set_text(text_5, $1);
			}, [() => href("help", "search", $.get(name)), () => rest().at(-1)]);
			$.append($$anchor, fragment_2);
		});
		$.reset(div);
		$.reset(section);
		$.template_effect(($0) => {
			$.set_text(text_2, $.get(table).label);
			classes = $.set_class(div, 1, "rows s-1fuvnz5", null, classes, { valued: $0 });
		}, [() => $.get(table).rows.some((row) => row.length > 2)]);
		$.append($$anchor, section);
	});
	$.append($$anchor, fragment);
	$.pop();
}
export { Explained as default };
