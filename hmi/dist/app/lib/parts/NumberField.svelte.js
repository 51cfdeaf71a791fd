import { typed } from "../numbers.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/NumberField.svelte
var root = $.from_html(`<span class="unit s-1yzuc8k"> </span>`);
var root_1 = $.from_html(`<span><input class="number s-1yzuc8k" autocapitalize="characters" autocomplete="off" spellcheck="false"/> <!></span>`);
function NumberField($$anchor, $$props) {
	$.push($$props, true);
	let digits = $.prop($$props, "digits", 3, 3), unit = $.prop($$props, "unit", 3, ""), minimum = $.prop($$props, "minimum", 19, () => -Infinity), maximum = $.prop($$props, "maximum", 3, Infinity), empty = $.prop($$props, "empty", 3, false), disabled = $.prop($$props, "disabled", 3, false), again = $.prop($$props, "again", 3, false);
	/** Whether it may be left empty. */
	/** Whether it is given also where it is what stands there already. */
	/** What a text that is no number stands for; `null` where it is nothing. */
	let draft = $.state(null);
	const shown = $.derived(() => $.get(draft) ?? ($$props.value === null || $$props.value === void 0 ? "" : $$props.value.toFixed(digits())));
	const parsed = $.derived(() => typed($.get(shown)));
	/** The keys that a device shows: letters where a text means something, digits alone for a count. */
	const keys = $.derived(() => $$props.meant ? "text" : digits() === 0 && minimum() >= 0 ? "numeric" : "decimal");
	const other = $.derived(() => $.get(draft) !== null && $.get(parsed) === null ? $$props.meant?.($.get(draft)) ?? null : null);
	const wrong = $.derived(() => $.get(draft) !== null && $.get(other) === null && ($.get(draft).trim() === "" ? !empty() : $.get(parsed) === null || $.get(parsed) < minimum() || $.get(parsed) > maximum()));
	function give() {
		if ($.get(draft) === null) return;
		if (!$.get(wrong) && $.get(other) === null) {
			const next = $.get(draft).trim() === "" ? null : $.get(parsed);
			if (again() || next !== $$props.value) $$props.onvalue(next);
		}
		$.set(draft, null);
	}
	var span = root_1();
	let classes;
	var input = $.child(span);
	$.remove_input_defaults(input);
	var node = $.sibling(input, 2);
	var consequent = ($$anchor) => {
		var span_1 = root();
		var text = $.only_child(span_1, true);
		$.template_effect(() => $.set_text(text, unit()));
		$.append($$anchor, span_1);
	};
	$.if(node, ($$render) => {
		if (unit()) $$render(consequent);
	});
	$.reset(span);
	$.template_effect(() => {
		classes = $.set_class(span, 1, "field s-1yzuc8k", null, classes, { wrong: $.get(wrong) });
		$.set_attribute(input, "inputmode", $.get(keys));
		$.set_attribute(input, "aria-label", $$props.label);
		$.set_attribute(input, "aria-invalid", $.get(wrong));
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
