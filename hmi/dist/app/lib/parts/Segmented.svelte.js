import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Segmented.svelte
var root = $.from_html(`<button type="button" role="radio" class="s-niintw"> </button>`);
var root_1 = $.from_html(`<div class="segmented s-niintw" role="radiogroup"></div>`);
function Segmented($$anchor, $$props) {
	$.push($$props, true);
	let value = $.prop($$props, "value", 15);
	var div = root_1();
	$.each(div, 21, () => $$props.options, (option) => option.value, ($$anchor, option) => {
		var button = root();
		var text = $.only_child(button, true);
		$.template_effect(() => {
			$.set_attribute(button, "aria-checked", value() === $.get(option).value);
			$.set_text(text, $.get(option).label);
		});
		$.delegated("click", button, () => {
			value($.get(option).value);
			$$props.onchange?.($.get(option).value);
		});
		$.append($$anchor, button);
	});
	$.reset(div);
	$.template_effect(() => $.set_attribute(div, "aria-label", $$props.label));
	$.append($$anchor, div);
	$.pop();
}
$.delegate(["click"]);
export { Segmented as default };
