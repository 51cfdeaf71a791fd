import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Bits.svelte
var root = $.from_html(`<button type="button"><small class="s-1a0byl1"> </small><b class="number"> </b></button>`);
var root_1 = $.from_html(`<div class="bits s-1a0byl1" role="group"></div>`);
function Bits($$anchor, $$props) {
	$.push($$props, true);
	let toggles = $.prop($$props, "toggles", 3, false), disabled = $.prop($$props, "disabled", 3, false);
	var div = root_1();
	$.each(div, 20, () => [
		7,
		6,
		5,
		4,
		3,
		2,
		1,
		0
	], (bit) => bit, ($$anchor, bit) => {
		const place = $.derived(() => `${$$props.address}.${bit}`);
		const signal = $.derived(() => $$props.named($.get(place)));
		const isOn = $.derived(() => ($$props.value >> bit & 1) === 1);
		var button = root();
		let classes;
		var small = $.child(button);
		var text = $.only_child(small, true);
		var b = $.sibling(small);
		var text_1 = $.only_child(b, true);
		$.reset(button);
		$.template_effect(($0) => {
			$.set_attribute(button, "role", toggles() ? "switch" : void 0);
			$.set_attribute(button, "aria-checked", toggles() ? $.get(isOn) : void 0);
			button.disabled = disabled();
			$.set_attribute(button, "title", $.get(signal) ? `${$.get(signal).name}: ${$.get(signal).meaning}` : $.get(place));
			$.set_attribute(button, "aria-label", $.get(place));
			$.set_attribute(button, "data-address", $.get(place));
			classes = $.set_class(button, 1, "s-1a0byl1", null, classes, {
				named: $.get(signal),
				on: $.get(isOn)
			});
			$.set_text(text, bit);
			$.set_text(text_1, $0);
		}, [() => Number($.get(isOn))]);
		$.event("focus", button, () => toggles() || $$props.onbit($.get(place), $.get(isOn)));
		$.delegated("click", button, () => $$props.onbit($.get(place), $.get(isOn)));
		$.append($$anchor, button);
	});
	$.reset(div);
	$.template_effect(() => $.set_attribute(div, "aria-label", $$props.address));
	$.append($$anchor, div);
	$.pop();
}
$.delegate(["click"]);
export { Bits as default };
