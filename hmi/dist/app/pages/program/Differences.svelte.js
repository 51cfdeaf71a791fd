import { t } from "../../lib/i18n/index.svelte.js";
import { called } from "../../lib/state/restart.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/program/Differences.svelte
var root = $.from_html(`<tr><td class="s-1vnwa8j"> </td><td class="code s-1vnwa8j"> </td><td class="code s-1vnwa8j"> </td></tr>`);
var root_1 = $.from_html(`<table class="table" data-testid="restart-differences"><thead><tr><th> </th><th> </th><th> </th></tr></thead><tbody></tbody></table>`);
function Differences($$anchor, $$props) {
	$.push($$props, true);
	/** A setting as the program has it: a word, a code, a number. */
	function value(text) {
		if (text === null) return "–";
		return text === "on" || text === "off" ? t(`app.${text}`) : text;
	}
	var table = root_1();
	var thead = $.child(table);
	var tr = $.child(thead);
	var th = $.child(tr);
	var text_1 = $.only_child(th, true);
	var th_1 = $.sibling(th);
	var text_2 = $.only_child(th_1, true);
	var th_2 = $.sibling(th_1);
	var text_3 = $.only_child(th_2, true);
	$.reset(tr);
	$.reset(thead);
	var tbody = $.sibling(thead);
	$.each(tbody, 21, () => $$props.plan.differences, (one) => one.of, ($$anchor, one) => {
		var tr_1 = root();
		let classes;
		var td = $.child(tr_1);
		var text_4 = $.only_child(td, true);
		var td_1 = $.sibling(td);
		var text_5 = $.only_child(td_1, true);
		var td_2 = $.sibling(td_1);
		var text_6 = $.only_child(td_2, true);
		$.reset(tr_1);
		$.template_effect(($0, $1, $2, $3) => {
			classes = $.set_class(tr_1, 1, "s-1vnwa8j", null, classes, { missing: $0 });
			$.set_text(text_4, $1);
			$.set_text(text_5, $2);
			$.set_text(text_6, $3);
		}, [
			() => $$props.plan.missing.includes($.get(one).of),
			() => called($.get(one).of),
			() => value($.get(one).program),
			() => value($.get(one).machine)
		]);
		$.append($$anchor, tr_1);
	});
	$.reset(tbody);
	$.reset(table);
	$.template_effect(($0, $1, $2) => {
		$.set_text(text_1, $0);
		$.set_text(text_2, $1);
		$.set_text(text_3, $2);
	}, [
		() => t("restart.differs"),
		() => t("restart.program"),
		() => t("restart.machine")
	]);
	$.append($$anchor, table);
	$.pop();
}
export { Differences as default };
