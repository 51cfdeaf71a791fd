import { t } from "../../lib/i18n/index.svelte.js";
import { fixed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Relative from "./Relative.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/position/All.svelte
var root = $.from_html(`<th class="right s-2ni3hj"> </th>`);
var root_1 = $.from_html(`<td> </td>`);
var root_2 = $.from_html(`<tr><th scope="row" class="s-2ni3hj"> </th><!><td class="right value s-2ni3hj"> </td></tr>`);
var root_3 = $.from_html(`<div class="scroll room s-2ni3hj"><table class="table"><thead><tr><th class="s-2ni3hj"></th><!><th class="right s-2ni3hj" data-kind="speed"> <small> </small></th></tr></thead><tbody></tbody></table></div>`);
var root_4 = $.from_html(`<div class="relative s-2ni3hj" data-testid="set-relative"></div>`);
var root_5 = $.from_html(`<!> <!>`, 1);
function All($$anchor, $$props) {
	$.push($$props, true);
	const status = $.derived(() => machine.status);
	const kinds = [
		"work",
		"relative",
		"machine",
		"actual",
		"to_go",
		"interruption"
	];
	const interrupted = $.derived(() => Object.values($.get(status).position.interruption).some((value) => Math.abs(value) > 1e-6));
	var fragment = root_5();
	var node = $.first_child(fragment);
	{
		const actions = ($$anchor) => {
			var fragment_1 = $.comment();
			var node_1 = $.first_child(fragment_1);
			var consequent = ($$anchor) => {
				Button($$anchor, {
					onclick: () => void machine.tell({ do: "clear_interruption" }),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text = $.text();
						$.template_effect(($0) => $.set_text(text, $0), [() => t("position.clear_interruption")]);
						$.append($$anchor, text);
					},
					$$slots: { default: true }
				});
			};
			$.if(node_1, ($$render) => {
				if ($.get(interrupted)) $$render(consequent);
			});
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("position.all"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var div = root_3();
				var table = $.child(div);
				var thead = $.child(table);
				var tr = $.child(thead);
				var node_2 = $.sibling($.child(tr));
				$.each(node_2, 16, () => kinds, (kind) => kind, ($$anchor, kind) => {
					var th = root();
					var text_1 = $.only_child(th, true);
					$.template_effect(($0) => {
						$.set_attribute(th, "data-kind", kind);
						$.set_text(text_1, $0);
					}, [() => kind === "work" ? $.get(status).position.system ?? t("position.g92") : t(`position.${kind}`)]);
					$.append($$anchor, th);
				});
				var th_1 = $.sibling(node_2);
				var text_2 = $.child(th_1);
				var small = $.sibling(text_2);
				var text_3 = $.only_child(small, true);
				$.reset(th_1);
				$.reset(tr);
				$.reset(thead);
				var tbody = $.sibling(thead);
				$.each(tbody, 20, () => machine.axes, (axis) => axis, ($$anchor, axis) => {
					var tr_1 = root_2();
					var th_2 = $.child(tr_1);
					var text_4 = $.only_child(th_2, true);
					var node_3 = $.sibling(th_2);
					$.each(node_3, 16, () => kinds, (kind) => kind, ($$anchor, kind) => {
						var td = root_1();
						let classes;
						var text_5 = $.only_child(td, true);
						$.template_effect(($0) => {
							classes = $.set_class(td, 1, "right value s-2ni3hj", null, classes, { main: kind === "work" });
							$.set_text(text_5, $0);
						}, [() => fixed($.get(status).position[kind][axis])]);
						$.append($$anchor, td);
					});
					var td_1 = $.sibling(node_3);
					var text_6 = $.only_child(td_1, true);
					$.reset(tr_1);
					$.template_effect(($0) => {
						$.set_attribute(tr_1, "data-axis", axis);
						$.set_text(text_4, axis);
						$.set_attribute(td_1, "data-speed", axis);
						$.set_text(text_6, $0);
					}, [() => fixed($.get(status).feed.components[axis] ?? 0, 0)]);
					$.append($$anchor, tr_1);
				});
				$.reset(tbody);
				$.reset(table);
				$.reset(div);
				$.template_effect(($0, $1) => {
					$.set_text(text_2, `${$0 ?? ""} `);
					$.set_text(text_3, $1);
				}, [() => t("position.speed"), () => t("unit.mm_min")]);
				$.append($$anchor, div);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var node_4 = $.sibling(node, 2);
	{
		let $0 = $.derived(() => t("position.relative"));
		Card(node_4, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div_1 = root_4();
				$.each(div_1, 20, () => machine.axes, (axis) => axis, ($$anchor, axis) => {
					Relative($$anchor, { get axis() {
						return axis;
					} });
				});
				$.reset(div_1);
				$.append($$anchor, div_1);
			},
			$$slots: { default: true }
		});
	}
	$.append($$anchor, fragment);
	$.pop();
}
export { All as default };
