import Digits from "../../lib/digits/Digits.svelte.js";
import { t } from "../../lib/i18n/index.svelte.js";
import { fixed, percent } from "../../lib/numbers.js";
import Card from "../../lib/parts/Card.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import { followParameters } from "../../lib/state/again.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/position/Speeds.svelte
var root = $.from_html(`<dd class="under set s-107j884"><span class="field s-107j884"><!></span> <span role="status" class="s-107j884"> </span></dd>`);
var root_1 = $.from_html(`<small class="s-107j884"> </small>`);
var root_2 = $.from_html(`<dl class="s-107j884"><div class="s-107j884"><dt class="s-107j884">F</dt> <dd class="s-107j884"><output class="number wide s-107j884" aria-live="off" data-testid="feed"><!></output><small class="s-107j884"> </small></dd> <dd class="under s-107j884"><span class="s-107j884"> <b class="number s-107j884"> </b></span><span> </span></dd></div> <div class="s-107j884"><dt class="s-107j884">S</dt> <dd class="s-107j884"><output class="number wide s-107j884" aria-live="off" data-testid="speed"><!></output><small class="s-107j884"> </small> <!></dd> <dd class="under s-107j884"><span class="s-107j884"> <b class="number s-107j884" data-testid="speed-programmed"> </b> <b class="number s-107j884"> </b></span><span> </span></dd> <!></div> <div class="s-107j884"><dt class="s-107j884">T</dt> <dd class="s-107j884"><output class="number s-107j884"> </output> <!></dd> <dd class="under s-107j884"><span class="s-107j884">H <b class="number s-107j884"> </b> · D <b class="number s-107j884"> </b></span><span class="s-107j884"> </span></dd></div></dl>`);
function Speeds($$anchor, $$props) {
	$.push($$props, true);
	let settable = $.prop(
		$$props,
		"settable",
		3,
		false
		/** Whether S can be typed here. */
	);
	const HIGHEST = 99999;
	/** The highest speed (P258); what the control says where it has one. */
	let highest = $.state(HIGHEST);
	$.user_effect(() => followParameters(["P258"], (values) => $.set(highest, Object.values(values)[0] || HIGHEST, true)));
	/** The program under way has a speed of its own. */
	const isTheirs = $.derived(() => machine.status.program_mode !== null);
	const feed = $.derived(() => machine.status.feed);
	const spindle = $.derived(() => machine.status.spindle);
	/** Less than this is standing still, r/min. */
	const STANDS = .5;
	const turns = $.derived(() => Math.abs($.get(spindle).actual) < STANDS ? null : $.get(spindle).actual > 0 ? "cw" : "ccw");
	Card($$anchor, {
		children: ($$anchor, $$slotProps) => {
			var dl = root_2();
			var div = $.child(dl);
			var dd = $.sibling($.child(div), 2);
			var output = $.child(dd);
			var node = $.child(output);
			Digits(node, { of: ({ feed }) => fixed(feed.actual, 0) });
			$.reset(output);
			var small = $.sibling(output);
			var text = $.only_child(small, true);
			$.reset(dd);
			var dd_1 = $.sibling(dd, 2);
			var span = $.child(dd_1);
			var text_1 = $.child(span);
			var b = $.sibling(text_1);
			var text_2 = $.only_child(b, true);
			$.reset(span);
			var span_1 = $.sibling(span);
			let classes;
			var text_3 = $.only_child(span_1);
			$.reset(dd_1);
			$.reset(div);
			var div_1 = $.sibling(div, 2);
			var dd_2 = $.sibling($.child(div_1), 2);
			var output_1 = $.child(dd_2);
			var node_1 = $.child(output_1);
			Digits(node_1, { of: ({ spindle }) => fixed(Math.abs(spindle.actual), 0) });
			$.reset(output_1);
			var small_1 = $.sibling(output_1);
			var text_4 = $.only_child(small_1, true);
			var node_2 = $.sibling(small_1, 2);
			var consequent = ($$anchor) => {
				Icon($$anchor, {
					get name() {
						return $.get(turns);
					},
					size: "1.1rem"
				});
			};
			$.if(node_2, ($$render) => {
				if ($.get(turns)) $$render(consequent);
			});
			$.reset(dd_2);
			var dd_3 = $.sibling(dd_2, 2);
			var span_2 = $.child(dd_3);
			var text_5 = $.child(span_2);
			var b_1 = $.sibling(text_5);
			var text_6 = $.only_child(b_1, true);
			var text_7 = $.sibling(b_1);
			var b_2 = $.sibling(text_7);
			var text_8 = $.only_child(b_2, true);
			$.reset(span_2);
			var span_3 = $.sibling(span_2);
			let classes_1;
			var text_9 = $.only_child(span_3);
			$.reset(dd_3);
			var node_3 = $.sibling(dd_3, 2);
			var consequent_1 = ($$anchor) => {
				var dd_4 = root();
				var span_4 = $.child(dd_4);
				var node_4 = $.child(span_4);
				{
					let $0 = $.derived(() => t("position.set_speed"));
					NumberField(node_4, {
						get label() {
							return $.get($0);
						},
						get value() {
							return $.get(spindle).programmed;
						},
						digits: 0,
						minimum: 0,
						get maximum() {
							return $.get(highest);
						},
						again: true,
						get disabled() {
							return $.get(isTheirs);
						},
						onvalue: (value) => value !== null && void machine.tell({
							do: "spindle_speed",
							speed: value
						})
					});
				}
				$.reset(span_4);
				var span_5 = $.sibling(span_4, 2);
				var text_10 = $.only_child(span_5, true);
				$.reset(dd_4);
				$.template_effect(($0) => $.set_text(text_10, $0), [() => $.get(isTheirs) ? t("position.speed_runs") : ""]);
				$.append($$anchor, dd_4);
			};
			$.if(node_3, ($$render) => {
				if (settable()) $$render(consequent_1);
			});
			$.reset(div_1);
			var div_2 = $.sibling(div_1, 2);
			var dd_5 = $.sibling($.child(div_2), 2);
			var output_2 = $.child(dd_5);
			var text_11 = $.only_child(output_2, true);
			var node_5 = $.sibling(output_2, 2);
			var consequent_2 = ($$anchor) => {
				var small_2 = root_1();
				var text_12 = $.only_child(small_2, true);
				$.template_effect(($0) => $.set_text(text_12, $0), [() => t("position.called", { tool: $.get(spindle).called_tool })]);
				$.append($$anchor, small_2);
			};
			$.if(node_5, ($$render) => {
				if ($.get(spindle).called_tool !== $.get(spindle).tool) $$render(consequent_2);
			});
			$.reset(dd_5);
			var dd_6 = $.sibling(dd_5, 2);
			var span_6 = $.child(dd_6);
			var b_3 = $.sibling($.child(span_6));
			var text_13 = $.only_child(b_3, true);
			var b_4 = $.sibling(b_3, 2);
			var text_14 = $.only_child(b_4, true);
			$.reset(span_6);
			var span_7 = $.sibling(span_6);
			var text_15 = $.only_child(span_7);
			$.reset(dd_6);
			$.reset(div_2);
			$.reset(dl);
			$.template_effect(($0, $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12, $13, $14) => {
				$.set_text(text, $0);
				$.set_text(text_1, `${$1 ?? ""} `);
				$.set_text(text_2, $2);
				classes = $.set_class(span_1, 1, "override s-107j884", null, classes, { off: $3 });
				$.set_text(text_3, `${$4 ?? ""} %`);
				$.set_attribute(output_1, "title", $5);
				$.set_text(text_4, $6);
				$.set_text(text_5, `${$7 ?? ""} `);
				$.set_text(text_6, $8);
				$.set_text(text_7, ` · ${$9 ?? ""} `);
				$.set_text(text_8, $10);
				classes_1 = $.set_class(span_3, 1, "override s-107j884", null, classes_1, { off: $11 });
				$.set_text(text_9, `${$12 ?? ""} %`);
				$.set_text(text_11, $.get(spindle).tool);
				$.set_text(text_13, machine.status.program.h);
				$.set_text(text_14, machine.status.program.d);
				$.set_text(text_15, `${$13 ?? ""} ${$14 ?? ""} %`);
			}, [
				() => t("unit.mm_min"),
				() => t("position.programmed"),
				() => fixed($.get(feed).programmed, 0),
				() => Math.round($.get(feed).feed_override * 100) !== 100,
				() => percent($.get(feed).feed_override),
				() => t("position.actual"),
				() => t("unit.rpm"),
				() => t("position.programmed"),
				() => fixed($.get(spindle).programmed, 0),
				() => t("position.told"),
				() => fixed($.get(spindle).told, 0),
				() => Math.round($.get(spindle).spindle_override * 100) !== 100,
				() => percent($.get(spindle).spindle_override),
				() => t("panel.rapid"),
				() => percent($.get(feed).rapid_override)
			]);
			$.append($$anchor, dl);
		},
		$$slots: { default: true }
	});
	$.pop();
}
export { Speeds as default };
