import { machine } from "../state/machine.svelte.js";
import { canDraw, sheet } from "./sheets.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/digits/Digits.svelte
var next = 0;
var root = $.from_html(`<span class="steady"> </span>`);
var root_1 = $.from_html(`<canvas class="steady s-1f8yx5u"> </canvas>`);
function Digits($$anchor, $$props) {
	$.push($$props, true);
	/** Its characters. */
	/** The page itself writes it. */
	let plain = $.state(!canDraw());
	const part = next++;
	const drawn = sheet({
		numbers: (now) => [{
			text: $$props.of(now),
			tone: 0
		}],
		places: (style, _, height, scale) => [{
			edge: 0,
			align: "left",
			middle: height / 2,
			font: `${style.fontWeight} ${Number.parseFloat(style.fontSize) * scale}px ${style.fontFamily}`,
			spacing: 0,
			colours: [style.color]
		}]
	}, () => $.set(plain, true));
	var fragment = $.comment();
	var node = $.first_child(fragment);
	var consequent = ($$anchor) => {
		var span = root();
		var text = $.only_child(span, true);
		$.template_effect(($0) => $.set_text(text, $0), [() => $$props.of(machine.status)]);
		$.append($$anchor, span);
	};
	var alternate = ($$anchor) => {
		var canvas = root_1();
		var text_1 = $.only_child(canvas, true);
		$.attach(canvas, () => drawn);
		$.template_effect(($0) => $.set_text(text_1, $0), [() => $$props.of(machine.calm(part))]);
		$.append($$anchor, canvas);
	};
	$.if(node, ($$render) => {
		if ($.get(plain)) $$render(consequent);
		else $$render(alternate, -1);
	});
	$.append($$anchor, fragment);
	$.pop();
}
export { Digits as default };
