import { canDraw, sheet } from "../../lib/digits/sheets.js";
import { t } from "../../lib/i18n/index.svelte.js";
import { fixed } from "../../lib/numbers.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { placeUnit } from "../../lib/units.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/position/Large.svelte
var root = $.from_html(`<output class="large s-14xhx1q" aria-live="off"> </output> <span> <span> </span></span> <span> <span class="machine"> </span></span>`, 1);
var root_1 = $.from_html(`<div class="plain s-14xhx1q"><!></div>`);
var root_2 = $.from_html(`<canvas class="s-14xhx1q"><!></canvas>`);
var root_3 = $.from_html(`<span class="tools s-14xhx1q"><!></span>`);
var root_4 = $.from_html(`<div class="axis s-14xhx1q"><span> <!></span> <!> <!></div>`);
var root_5 = $.from_html(`<section data-testid="axes"><header class="s-14xhx1q"><h2> <small class="s-14xhx1q"> </small></h2> <span class="legend muted s-14xhx1q"><span> </span><span> </span></span></header> <!></section>`);
function Large($$anchor, $$props) {
	$.push($$props, true);
	const numbers = ($$anchor, axis = $.noop, $$arg1) => {
		let mode = () => ($$arg1?.()).mode;
		let position = () => ($$arg1?.()).position;
		const beside = $.derived(() => second(mode()));
		var fragment = root();
		var output = $.first_child(fragment);
		var text_1 = $.only_child(output, true);
		var span = $.sibling(output, 2);
		var text_2 = $.child(span);
		var span_1 = $.sibling(text_2);
		var text_3 = $.only_child(span_1, true);
		$.reset(span);
		var span_2 = $.sibling(span, 2);
		var text_4 = $.child(span_2);
		var span_3 = $.sibling(text_4);
		var text_5 = $.only_child(span_3, true);
		$.reset(span_2);
		$.template_effect(($0, $1, $2, $3, $4) => {
			$.set_attribute(output, "aria-label", axis());
			$.set_text(text_1, $0);
			$.set_text(text_2, `${$1 ?? ""} `);
			$.set_class(span_1, 1, $.clsx($.get(beside) === "to_go" ? "to-go" : "relative"));
			$.set_text(text_3, $2);
			$.set_text(text_4, `${$3 ?? ""} `);
			$.set_text(text_5, $4);
		}, [
			() => fixed(position()[$$props.what][axis()]),
			() => t(`position.${$.get(beside)}`),
			() => fixed(position()[$.get(beside)][axis()] ?? 0),
			() => t("position.machine"),
			() => fixed(position().machine[axis()])
		]);
		$.append($$anchor, fragment);
	};
	let small = $.prop($$props, "small", 3, false);
	const status = $.derived(() => machine.status);
	let plain = $.state(!canDraw());
	const BY_HAND = [
		"home",
		"step",
		"jog",
		"handle"
	];
	const second = (mode) => small() && BY_HAND.includes(mode) ? "relative" : "to_go";
	const moves = (now, axis) => second(now.mode) === "to_go" && Math.abs(now.position.to_go[axis] ?? 0) > 5e-4;
	function contents(axis) {
		return {
			numbers: (now) => [
				{
					text: fixed(now.position[$$props.what][axis]),
					tone: 0
				},
				{
					text: fixed(now.position[second(now.mode)][axis] ?? 0),
					tone: moves(now, axis) ? 1 : 0
				},
				{
					text: fixed(now.position.machine[axis]),
					tone: 0
				}
			],
			places(style, width, height, scale) {
				const rem = Number.parseFloat(getComputedStyle(document.documentElement).fontSize) * scale;
				const size = Number.parseFloat(style.fontSize) * scale;
				const colour = (name) => style.getPropertyValue(name).trim();
				const [text, muted, run] = [
					colour("--text"),
					colour("--muted"),
					colour("--run")
				];
				const [end, middle] = [width, height / 2];
				const small = {
					edge: end,
					align: "right",
					font: `400 ${1.05 * rem}px ${style.fontFamily}`,
					spacing: 0
				};
				return [
					{
						...small,
						edge: end - 7.3 * rem,
						middle,
						font: `500 ${size}px ${style.fontFamily}`,
						spacing: -.02 * size,
						colours: [text]
					},
					{
						...small,
						middle: middle - .71 * rem,
						colours: [text, run]
					},
					{
						...small,
						middle: middle + .71 * rem,
						colours: [muted]
					}
				];
			}
		};
	}
	var section = root_5();
	let classes;
	var header = $.child(section);
	var h2 = $.child(header);
	var text_6 = $.child(h2);
	var small_1 = $.sibling(text_6);
	var text_7 = $.only_child(small_1, true);
	$.reset(h2);
	var span_4 = $.sibling(h2, 2);
	var span_5 = $.child(span_4);
	var text_8 = $.only_child(span_5, true);
	var span_6 = $.sibling(span_5);
	var text_9 = $.only_child(span_6, true);
	$.reset(span_4);
	$.reset(header);
	var node = $.sibling(header, 2);
	$.each(node, 18, () => machine.axes, (axis) => axis, ($$anchor, axis, index) => {
		const homed = $.derived(() => $.get(status).referenced.includes(axis));
		var div = root_4();
		var span_7 = $.child(div);
		let classes_1;
		var text_10 = $.child(span_7);
		var node_1 = $.sibling(text_10);
		var consequent = ($$anchor) => {
			Icon($$anchor, {
				name: "check",
				size: "0.9rem"
			});
		};
		$.if(node_1, ($$render) => {
			if ($.get(homed)) $$render(consequent);
		});
		$.reset(span_7);
		var node_2 = $.sibling(span_7, 2);
		var consequent_1 = ($$anchor) => {
			var div_1 = root_1();
			var node_3 = $.child(div_1);
			numbers(node_3, () => axis, () => $.get(status));
			$.reset(div_1);
			$.append($$anchor, div_1);
		};
		var alternate = ($$anchor) => {
			var fragment_2 = $.comment();
			var node_4 = $.first_child(fragment_2);
			$.key(node_4, () => $$props.what, ($$anchor) => {
				var canvas = root_2();
				var node_5 = $.child(canvas);
				{
					let $0 = $.derived(() => machine.calm($.get(index)));
					numbers(node_5, () => axis, () => $.get($0));
				}
				$.reset(canvas);
				$.attach(canvas, () => sheet(contents(axis), () => $.set(plain, true)));
				$.append($$anchor, canvas);
			});
			$.append($$anchor, fragment_2);
		};
		$.if(node_2, ($$render) => {
			if ($.get(plain)) $$render(consequent_1);
			else $$render(alternate, -1);
		});
		var node_6 = $.sibling(node_2, 2);
		var consequent_2 = ($$anchor) => {
			var span_8 = root_3();
			var node_7 = $.child(span_8);
			$.snippet(node_7, () => $$props.tools, () => axis);
			$.reset(span_8);
			$.append($$anchor, span_8);
		};
		$.if(node_6, ($$render) => {
			if ($$props.tools) $$render(consequent_2);
		});
		$.reset(div);
		$.template_effect(() => {
			$.set_attribute(div, "data-axis", axis);
			classes_1 = $.set_class(span_7, 1, "letter s-14xhx1q", null, classes_1, { homed: $.get(homed) });
			$.set_text(text_10, `${axis ?? ""} `);
		});
		$.append($$anchor, div);
	});
	$.reset(section);
	$.template_effect(($0, $1, $2, $3) => {
		classes = $.set_class(section, 1, "axes s-14xhx1q", null, classes, { small: small() });
		$.set_text(text_6, `${$0 ?? ""} `);
		$.set_text(text_7, $1);
		$.set_text(text_8, $2);
		$.set_text(text_9, $3);
	}, [
		() => $$props.what === "absolute" ? $.get(status).position.system ?? t("position.g92") : t("position.relative"),
		() => placeUnit(),
		() => t(`position.${second($.get(status).mode)}`),
		() => t("position.machine")
	]);
	$.append($$anchor, section);
	$.pop();
}
export { Large as default };
