import { t } from "../../lib/i18n/index.svelte.js";
import { route } from "../../lib/routing.svelte.js";
import { calculate } from "./calculate.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/help/Calculator.svelte
var root = $.from_html(`<button type="button"> </button>`);
var root_1 = $.from_html(`<li class="s-1jn6l0x"><button type="button" class="s-1jn6l0x"><span class="muted"> </span> </button></li>`);
var root_2 = $.from_html(`<div class="calculator s-1jn6l0x"><form class="s-1jn6l0x"><input class="number s-1jn6l0x" spellcheck="false" autocomplete="off" data-testid="sum"/> <output class="number s-1jn6l0x"> </output> <div class="keys s-1jn6l0x"></div></form> <ul class="number s-1jn6l0x"></ul></div>`);
function Calculator($$anchor, $$props) {
	$.push($$props, true);
	let sum = $.state($.proxy(route.item));
	let past = $.state([]);
	const value = $.derived(() => calculate($.get(sum)));
	const shown = (number) => Number(number.toPrecision(12)).toString();
	const keys = [
		"7",
		"8",
		"9",
		"/",
		"sin",
		"4",
		"5",
		"6",
		"*",
		"cos",
		"1",
		"2",
		"3",
		"-",
		"tan",
		"0",
		".",
		"π",
		"+",
		"√",
		"(",
		")",
		"^",
		"⌫",
		"="
	];
	function press(key) {
		if (key === "=") {
			if ($.get(value) === null) return;
			$.set(past, [{
				sum: $.get(sum),
				value: shown($.get(value))
			}, ...$.get(past)].slice(0, 30));
			$.set(sum, shown($.get(value)), true);
		} else if (key === "⌫") $.set(sum, $.get(sum).slice(0, -1), true);
		else $.set(sum, $.get(sum) + (/^[a-z]/.test(key) ? `${key}(` : key));
	}
	var div = root_2();
	var form = $.child(div);
	var input = $.child(form);
	$.remove_input_defaults(input);
	var output = $.sibling(input, 2);
	var text = $.only_child(output, true);
	var div_1 = $.sibling(output, 2);
	$.each(div_1, 20, () => keys, (key) => key, ($$anchor, key) => {
		var button = root();
		let classes;
		var text_1 = $.only_child(button, true);
		$.template_effect(() => {
			classes = $.set_class(button, 1, "s-1jn6l0x", null, classes, { equals: key === "=" });
			$.set_text(text_1, key);
		});
		$.delegated("click", button, () => press(key));
		$.append($$anchor, button);
	});
	$.reset(div_1);
	$.reset(form);
	var ul = $.sibling(form, 2);
	$.each(ul, 21, () => $.get(past), $.index, ($$anchor, one) => {
		var li = root_1();
		var button_1 = $.child(li);
		var span = $.child(button_1);
		var text_2 = $.only_child(span);
		var text_3 = $.sibling(span);
		$.reset(button_1);
		$.reset(li);
		$.template_effect(() => {
			$.set_text(text_2, `${$.get(one).sum ?? ""} =`);
			$.set_text(text_3, ` ${$.get(one).value ?? ""}`);
		});
		$.delegated("click", button_1, () => $.set(sum, $.get(one).sum, true));
		$.append($$anchor, li);
	});
	$.reset(ul);
	$.reset(div);
	$.template_effect(($0, $1) => {
		$.set_attribute(input, "aria-label", $0);
		$.set_text(text, $1);
	}, [() => t("help.sum"), () => $.get(value) === null ? $.get(sum) ? "–" : "0" : shown($.get(value))]);
	$.event("submit", form, (event) => {
		event.preventDefault();
		press("=");
	});
	$.bind_value(input, () => $.get(sum), ($$value) => $.set(sum, $$value));
	$.append($$anchor, div);
	$.pop();
}
$.delegate(["click"]);
export { Calculator as default };
