import { sheet } from "../../lib/digits/sheets.js";
import { t } from "../../lib/i18n/index.svelte.js";
import { fixed } from "../../lib/numbers.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/position/Large.svelte
var root = $.from_html(`<canvas class="s-zz0ojl"><output class="large" aria-live="off"> </output> <span> <span> </span></span> <span> <span class="machine"> </span></span></canvas>`);
var root_1 = $.from_html(`<span class="tools s-zz0ojl"><!></span>`);
var root_2 = $.from_html(`<div class="axis s-zz0ojl"><span> <!></span> <!> <!></div>`);
var root_3 = $.from_html(`<section class="axes s-zz0ojl" data-testid="axes"><header class="s-zz0ojl"><h2> </h2> <span class="legend muted s-zz0ojl"><span> </span><span> </span></span></header> <!></section>`);
function Large($$anchor, $$props) {
	$.push($$props, true);
	const status = $.derived(() => machine.status);
	const moves = (now, axis) => Math.abs(now.position.to_go[axis] ?? 0) > 5e-4;
	function contents(axis) {
		return {
			numbers: (now) => [
				{
					text: fixed(now.position[$$props.what][axis]),
					tone: 0
				},
				{
					text: fixed(now.position.to_go[axis] ?? 0),
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
					right: end,
					font: `400 ${1.05 * rem}px ${style.fontFamily}`,
					spacing: 0
				};
				return [
					{
						right: end - 7.3 * rem,
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
	var section = root_3();
	var header = $.child(section);
	var h2 = $.child(header);
	var text_1 = $.only_child(h2, true);
	var span = $.sibling(h2, 2);
	var span_1 = $.child(span);
	var text_2 = $.only_child(span_1, true);
	var span_2 = $.sibling(span_1);
	var text_3 = $.only_child(span_2, true);
	$.reset(span);
	$.reset(header);
	var node = $.sibling(header, 2);
	$.each(node, 16, () => machine.axes, (axis) => axis, ($$anchor, axis) => {
		const homed = $.derived(() => $.get(status).referenced.includes(axis));
		var div = root_2();
		var span_3 = $.child(div);
		let classes;
		var text_4 = $.child(span_3);
		var node_1 = $.sibling(text_4);
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
		var node_2 = $.sibling(span_3, 2);
		$.key(node_2, () => $$props.what, ($$anchor) => {
			var canvas = root();
			var output = $.child(canvas);
			var text_5 = $.only_child(output, true);
			var span_4 = $.sibling(output, 2);
			var text_6 = $.child(span_4);
			var span_5 = $.sibling(text_6);
			let classes_1;
			var text_7 = $.only_child(span_5, true);
			$.reset(span_4);
			var span_6 = $.sibling(span_4, 2);
			var text_8 = $.child(span_6);
			var span_7 = $.sibling(text_8);
			var text_9 = $.only_child(span_7, true);
			$.reset(span_6);
			$.reset(canvas);
			$.attach(canvas, () => sheet(contents(axis)));
			$.template_effect(($0, $1, $2, $3, $4, $5) => {
				$.set_attribute(output, "aria-label", axis);
				$.set_text(text_5, $0);
				$.set_text(text_6, `${$1 ?? ""} `);
				classes_1 = $.set_class(span_5, 1, "to-go", null, classes_1, { moves: $2 });
				$.set_text(text_7, $3);
				$.set_text(text_8, `${$4 ?? ""} `);
				$.set_text(text_9, $5);
			}, [
				() => fixed($.get(status).position[$$props.what][axis]),
				() => t("position.to_go"),
				() => moves($.get(status), axis),
				() => fixed($.get(status).position.to_go[axis] ?? 0),
				() => t("position.machine"),
				() => fixed($.get(status).position.machine[axis])
			]);
			$.append($$anchor, canvas);
		});
		var node_3 = $.sibling(node_2, 2);
		var consequent_1 = ($$anchor) => {
			var span_8 = root_1();
			var node_4 = $.child(span_8);
			$.snippet(node_4, () => $$props.tools, () => axis);
			$.reset(span_8);
			$.append($$anchor, span_8);
		};
		$.if(node_3, ($$render) => {
			if ($$props.tools) $$render(consequent_1);
		});
		$.reset(div);
		$.template_effect(() => {
			$.set_attribute(div, "data-axis", axis);
			classes = $.set_class(span_3, 1, "letter s-zz0ojl", null, classes, { homed: $.get(homed) });
			$.set_text(text_4, `${axis ?? ""} `);
		});
		$.append($$anchor, div);
	});
	$.reset(section);
	$.template_effect(($0, $1, $2) => {
		$.set_text(text_1, $0);
		$.set_text(text_2, $1);
		$.set_text(text_3, $2);
	}, [
		() => $$props.what === "work" ? $.get(status).position.system ?? t("position.g92") : t("position.relative"),
		() => t("position.to_go"),
		() => t("position.machine")
	]);
	$.append($$anchor, section);
	$.pop();
}
export { Large as default };
