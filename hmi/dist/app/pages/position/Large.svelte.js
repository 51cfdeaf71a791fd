import { t } from "../../lib/i18n/index.svelte.js";
import { fixed } from "../../lib/numbers.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/position/Large.svelte
var root = $.from_html(`<span class="tools s-1kbybbx"><!></span>`);
var root_1 = $.from_html(`<div class="axis s-1kbybbx"><span> <!></span> <output class="large number s-1kbybbx" aria-live="off"><span class="digits s-1kbybbx"> </span></output> <span class="small s-1kbybbx"><span> </span> <span class="number muted s-1kbybbx"> </span></span> <!></div>`);
var root_2 = $.from_html(`<section class="axes s-1kbybbx" data-testid="axes"><header class="s-1kbybbx"><h2> </h2> <span class="legend muted s-1kbybbx"><span> </span><span> </span></span></header> <!></section>`);
function Large($$anchor, $$props) {
	$.push($$props, true);
	const status = $.derived(() => machine.status);
	var section = root_2();
	var header = $.child(section);
	var h2 = $.child(header);
	var text = $.only_child(h2, true);
	var span = $.sibling(h2, 2);
	var span_1 = $.child(span);
	var text_1 = $.only_child(span_1, true);
	var span_2 = $.sibling(span_1);
	var text_2 = $.only_child(span_2, true);
	$.reset(span);
	$.reset(header);
	var node = $.sibling(header, 2);
	$.each(node, 16, () => machine.axes, (axis) => axis, ($$anchor, axis) => {
		const homed = $.derived(() => $.get(status).referenced.includes(axis));
		var div = root_1();
		var span_3 = $.child(div);
		let classes;
		var text_3 = $.child(span_3);
		var node_1 = $.sibling(text_3);
		var consequent = ($$anchor) => {
			Icon($$anchor, {
				name: "check",
				size: "0.9rem"
			});
		};
		$.if(node_1, ($$render) => {
			if ($.get(homed)) $$render(consequent);
		});
		$.reset(span_3);
		var output = $.sibling(span_3, 2);
		var span_4 = $.child(output);
		var text_4 = $.only_child(span_4, true);
		$.reset(output);
		var span_5 = $.sibling(output, 2);
		var span_6 = $.child(span_5);
		let classes_1;
		var text_5 = $.only_child(span_6, true);
		var span_7 = $.sibling(span_6, 2);
		var text_6 = $.only_child(span_7, true);
		$.reset(span_5);
		var node_2 = $.sibling(span_5, 2);
		var consequent_1 = ($$anchor) => {
			var span_8 = root();
			var node_3 = $.child(span_8);
			$.snippet(node_3, () => $$props.tools, () => axis);
			$.reset(span_8);
			$.append($$anchor, span_8);
		};
		$.if(node_2, ($$render) => {
			if ($$props.tools) $$render(consequent_1);
		});
		$.reset(div);
		$.template_effect(($0, $1, $2, $3) => {
			$.set_attribute(div, "data-axis", axis);
			classes = $.set_class(span_3, 1, "letter s-1kbybbx", null, classes, { homed: $.get(homed) });
			$.set_text(text_3, `${axis ?? ""} `);
			$.set_text(text_4, $0);
			classes_1 = $.set_class(span_6, 1, "number s-1kbybbx", null, classes_1, { moves: $1 });
			$.set_text(text_5, $2);
			$.set_text(text_6, $3);
		}, [
			() => fixed($.get(status).position[$$props.what][axis]),
			() => Math.abs($.get(status).position.to_go[axis] ?? 0) > 5e-4,
			() => fixed($.get(status).position.to_go[axis] ?? 0),
			() => fixed($.get(status).position.machine[axis])
		]);
		$.append($$anchor, div);
	});
	$.reset(section);
	$.template_effect(($0, $1, $2) => {
		$.set_text(text, $0);
		$.set_text(text_1, $1);
		$.set_text(text_2, $2);
	}, [
		() => $$props.what === "work" ? $.get(status).position.system ?? t("position.g92") : t("position.relative"),
		() => t("position.to_go"),
		() => t("position.machine")
	]);
	$.append($$anchor, section);
	$.pop();
}
export { Large as default };
