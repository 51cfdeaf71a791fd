import { t } from "../../lib/i18n/index.svelte.js";
import { fixed, percent } from "../../lib/numbers.js";
import Card from "../../lib/parts/Card.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/position/Speeds.svelte
var root = $.from_html(`<small class="s-1idfk3s"> </small>`);
var root_1 = $.from_html(`<dl class="s-1idfk3s"><div class="s-1idfk3s"><dt class="s-1idfk3s">F</dt> <dd class="s-1idfk3s"><output class="number s-1idfk3s" data-testid="feed"> </output><small class="s-1idfk3s"> </small></dd> <dd class="under s-1idfk3s"><span> <b class="number s-1idfk3s"> </b></span><span> </span></dd></div> <div class="s-1idfk3s"><dt class="s-1idfk3s">S</dt> <dd class="s-1idfk3s"><output class="number s-1idfk3s" data-testid="speed"> </output><small class="s-1idfk3s"> </small> <!></dd> <dd class="under s-1idfk3s"><span> <b class="number s-1idfk3s" data-testid="speed-programmed"> </b> <b class="number s-1idfk3s"> </b></span><span> </span></dd></div> <div class="s-1idfk3s"><dt class="s-1idfk3s">T</dt> <dd class="s-1idfk3s"><output class="number s-1idfk3s"> </output> <!></dd> <dd class="under s-1idfk3s"><span>H <b class="number s-1idfk3s"> </b> · D <b class="number s-1idfk3s"> </b></span><span> </span></dd></div></dl>`);
function Speeds($$anchor, $$props) {
	$.push($$props, true);
	const feed = $.derived(() => machine.status.feed);
	const spindle = $.derived(() => machine.status.spindle);
	/** Less than this is standing still, r/min. */
	const STANDS = .5;
	const turns = $.derived(() => Math.abs($.get(spindle).actual) < STANDS ? null : $.get(spindle).actual > 0 ? "cw" : "ccw");
	Card($$anchor, {
		children: ($$anchor, $$slotProps) => {
			var dl = root_1();
			var div = $.child(dl);
			var dd = $.sibling($.child(div), 2);
			var output = $.child(dd);
			var text = $.only_child(output, true);
			var small = $.sibling(output);
			var text_1 = $.only_child(small, true);
			$.reset(dd);
			var dd_1 = $.sibling(dd, 2);
			var span = $.child(dd_1);
			var text_2 = $.child(span);
			var b = $.sibling(text_2);
			var text_3 = $.only_child(b, true);
			$.reset(span);
			var span_1 = $.sibling(span);
			let classes;
			var text_4 = $.only_child(span_1);
			$.reset(dd_1);
			$.reset(div);
			var div_1 = $.sibling(div, 2);
			var dd_2 = $.sibling($.child(div_1), 2);
			var output_1 = $.child(dd_2);
			var text_5 = $.only_child(output_1, true);
			var small_1 = $.sibling(output_1);
			var text_6 = $.only_child(small_1, true);
			var node = $.sibling(small_1, 2);
			var consequent = ($$anchor) => {
				Icon($$anchor, {
					get name() {
						return $.get(turns);
					},
					size: "1.1rem"
				});
			};
			$.if(node, ($$render) => {
				if ($.get(turns)) $$render(consequent);
			});
			$.reset(dd_2);
			var dd_3 = $.sibling(dd_2, 2);
			var span_2 = $.child(dd_3);
			var text_7 = $.child(span_2);
			var b_1 = $.sibling(text_7);
			var text_8 = $.only_child(b_1, true);
			var text_9 = $.sibling(b_1);
			var b_2 = $.sibling(text_9);
			var text_10 = $.only_child(b_2, true);
			$.reset(span_2);
			var span_3 = $.sibling(span_2);
			let classes_1;
			var text_11 = $.only_child(span_3);
			$.reset(dd_3);
			$.reset(div_1);
			var div_2 = $.sibling(div_1, 2);
			var dd_4 = $.sibling($.child(div_2), 2);
			var output_2 = $.child(dd_4);
			var text_12 = $.only_child(output_2, true);
			var node_1 = $.sibling(output_2, 2);
			var consequent_1 = ($$anchor) => {
				var small_2 = root();
				var text_13 = $.only_child(small_2, true);
				$.template_effect(($0) => $.set_text(text_13, $0), [() => t("position.called", { tool: $.get(spindle).called_tool })]);
				$.append($$anchor, small_2);
			};
			$.if(node_1, ($$render) => {
				if ($.get(spindle).called_tool !== $.get(spindle).tool) $$render(consequent_1);
			});
			$.reset(dd_4);
			var dd_5 = $.sibling(dd_4, 2);
			var span_4 = $.child(dd_5);
			var b_3 = $.sibling($.child(span_4));
			var text_14 = $.only_child(b_3, true);
			var b_4 = $.sibling(b_3, 2);
			var text_15 = $.only_child(b_4, true);
			$.reset(span_4);
			var span_5 = $.sibling(span_4);
			var text_16 = $.only_child(span_5);
			$.reset(dd_5);
			$.reset(div_2);
			$.reset(dl);
			$.template_effect(($0, $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12, $13, $14, $15, $16) => {
				$.set_text(text, $0);
				$.set_text(text_1, $1);
				$.set_text(text_2, `${$2 ?? ""} `);
				$.set_text(text_3, $3);
				classes = $.set_class(span_1, 1, "override s-1idfk3s", null, classes, { off: $4 });
				$.set_text(text_4, `${$5 ?? ""} %`);
				$.set_attribute(output_1, "title", $6);
				$.set_text(text_5, $7);
				$.set_text(text_6, $8);
				$.set_text(text_7, `${$9 ?? ""} `);
				$.set_text(text_8, $10);
				$.set_text(text_9, ` · ${$11 ?? ""} `);
				$.set_text(text_10, $12);
				classes_1 = $.set_class(span_3, 1, "override s-1idfk3s", null, classes_1, { off: $13 });
				$.set_text(text_11, `${$14 ?? ""} %`);
				$.set_text(text_12, $.get(spindle).tool);
				$.set_text(text_14, machine.status.program.h);
				$.set_text(text_15, machine.status.program.d);
				$.set_text(text_16, `${$15 ?? ""} ${$16 ?? ""} %`);
			}, [
				() => fixed($.get(feed).actual, 0),
				() => t("unit.mm_min"),
				() => t("position.programmed"),
				() => fixed($.get(feed).programmed, 0),
				() => Math.round($.get(feed).feed_override * 100) !== 100,
				() => percent($.get(feed).feed_override),
				() => t("position.actual"),
				() => fixed(Math.abs($.get(spindle).actual), 0),
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
