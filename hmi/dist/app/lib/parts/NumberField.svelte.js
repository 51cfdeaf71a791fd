import { t } from "../i18n/index.svelte.js";
import { rangeText, typed } from "../numbers.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/NumberField.svelte
var root = $.from_html(`<span class="unit s-1q407wr"> </span>`);
var root_1 = $.from_html(`<small class="may s-1q407wr" role="status"> </small>`);
var root_2 = $.from_html(`<span><span class="box s-1q407wr"><input class="number s-1q407wr" autocapitalize="characters" autocomplete="off" spellcheck="false"/> <!></span> <!></span>`);
function NumberField($$anchor, $$props) {
	const id = $.props_id();
	$.push($$props, true);
	let whole = $.prop($$props, "whole", 3, false), digits = $.prop($$props, "digits", 19, () => whole() ? 0 : 3), unit = $.prop($$props, "unit", 3, ""), minimum = $.prop($$props, "minimum", 19, () => -Infinity), maximum = $.prop($$props, "maximum", 3, Infinity), empty = $.prop($$props, "empty", 3, false), disabled = $.prop($$props, "disabled", 3, false), again = $.prop($$props, "again", 3, false);
	let draft = $.state(null);
	const shown = $.derived(() => $.get(draft) ?? ($$props.value === null || $$props.value === void 0 ? "" : $$props.value.toFixed(digits())));
	const parsed = $.derived(() => typed($.get(shown)));
	const keys = $.derived(() => $$props.meant ? "text" : whole() && minimum() >= 0 ? "numeric" : "decimal");
	const other = $.derived(() => $.get(draft) !== null && $.get(parsed) === null ? $$props.meant?.($.get(draft)) ?? null : null);
	const broken = $.derived(() => whole() && $.get(parsed) !== null && !Number.isInteger($.get(parsed)));
	const wrong = $.derived(() => $.get(draft) !== null && $.get(other) === null && ($.get(draft).trim() === "" ? !empty() : $.get(parsed) === null || $.get(broken) || $.get(parsed) < minimum() || $.get(parsed) > maximum()));
	const may = $.derived(() => [$.get(broken) ? t("app.whole_number") : "", rangeText(minimum(), maximum())].filter(Boolean).join(", "));
	function give() {
		if ($.get(draft) === null) return;
		if (!$.get(wrong) && $.get(other) === null) {
			const next = $.get(draft).trim() === "" ? null : $.get(parsed);
			if (again() || next !== $$props.value) $$props.onvalue(next);
		}
		$.set(draft, null);
	}
	var span = root_2();
	let classes;
	var span_1 = $.child(span);
	var input = $.child(span_1);
	$.remove_input_defaults(input);
	var node = $.sibling(input, 2);
	var consequent = ($$anchor) => {
		var span_2 = root();
		var text = $.only_child(span_2, true);
		$.template_effect(() => $.set_text(text, unit()));
		$.append($$anchor, span_2);
	};
	$.if(node, ($$render) => {
		if (unit()) $$render(consequent);
	});
	$.reset(span_1);
	var node_1 = $.sibling(span_1, 2);
	var consequent_1 = ($$anchor) => {
		var small = root_1();
		var text_1 = $.only_child(small, true);
		$.template_effect(() => {
			$.set_attribute(small, "id", id);
			$.set_text(text_1, $.get(may));
		});
		$.append($$anchor, small);
	};
	$.if(node_1, ($$render) => {
		if ($.get(wrong) && $.get(may)) $$render(consequent_1);
	});
	$.reset(span);
	$.template_effect(() => {
		classes = $.set_class(span, 1, "field s-1q407wr", null, classes, { wrong: $.get(wrong) });
		$.set_attribute(input, "inputmode", $.get(keys));
		$.set_attribute(input, "aria-label", $$props.label);
		$.set_attribute(input, "aria-invalid", $.get(wrong));
		$.set_attribute(input, "aria-describedby", $.get(wrong) && $.get(may) ? id : void 0);
		input.disabled = disabled();
		$.set_value(input, $.get(shown));
	});
	$.delegated("input", input, (event) => $.set(draft, event.currentTarget.value, true));
	$.event("focus", input, (event) => event.currentTarget.select());
	$.delegated("keydown", input, (event) => {
		if (event.key === "Enter") {
			const act = $.get(other);
			if (!$.get(wrong)) give();
			act?.();
		} else if (event.key === "Escape" && $.get(draft) !== null) {
			$.set(draft, null);
			event.stopPropagation();
		}
	});
	$.event("blur", input, give);
	$.append($$anchor, span);
	$.pop();
}
$.delegate(["input", "keydown"]);
export { NumberField as default };
