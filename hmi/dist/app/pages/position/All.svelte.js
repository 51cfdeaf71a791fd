import { t } from "../../lib/i18n/index.svelte.js";
import { fixed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { placeUnit } from "../../lib/units.js";
import Relative from "./Relative.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/position/All.svelte
var root = $.from_html(`<span class="muted"> </span> <!>`, 1);
var root_1 = $.from_html(`<th class="right s-2ni3hj"> </th>`);
var root_2 = $.from_html(`<td> </td>`);
var root_3 = $.from_html(`<tr><th scope="row" class="s-2ni3hj"> </th><!><td class="right value s-2ni3hj"> </td></tr>`);
var root_4 = $.from_html(`<div class="scroll room s-2ni3hj"><table class="table"><thead><tr><th class="s-2ni3hj"><small> </small></th><!><th class="right s-2ni3hj" data-kind="speed"> <small> </small></th></tr></thead><tbody></tbody></table></div>`);
var root_5 = $.from_html(`<div class="relative s-2ni3hj" data-testid="set-relative"></div>`);
var root_6 = $.from_html(`<!> <!>`, 1);
function All($$anchor, $$props) {
	$.push($$props, true);
	const status = $.derived(() => machine.status);
	const kinds = [
		"absolute",
		"relative",
		"machine",
		"actual",
		"to_go",
		"interruption"
	];
	/** Axes that the handwheel has shifted: each is cleared for itself (GSK990MC part 2, 6.2.1). */
	const interrupted = $.derived(() => machine.axes.filter((axis) => Math.abs($.get(status).position.interruption[axis] ?? 0) > 1e-6));
	var fragment = root_6();
	var node = $.first_child(fragment);
	{
		const actions = ($$anchor) => {
			var fragment_1 = $.comment();
			var node_1 = $.first_child(fragment_1);
			var consequent = ($$anchor) => {
				var fragment_2 = root();
				var span = $.first_child(fragment_2);
				var text = $.only_child(span, true);
				var node_2 = $.sibling(span, 2);
				$.each(node_2, 16, () => $.get(interrupted), (axis) => axis, ($$anchor, axis) => {
					{
						let $0 = $.derived(() => `${t("position.clear_interruption")}: ${axis}`);
						let $1 = $.derived(() => `clear-interruption-${axis}`);
						Button($$anchor, {
							get "aria-label"() {
								return $.get($0);
							},
							onclick: () => void machine.tell({
								do: "clear_interruption",
								axis
							}),
							get "data-testid"() {
								return $.get($1);
							},
							children: ($$anchor, $$slotProps) => {
								$.next();
								var text_1 = $.text();
								$.template_effect(() => $.set_text(text_1, axis));
								$.append($$anchor, text_1);
							},
							$$slots: { default: true }
						});
					}
				});
				$.template_effect(($0) => $.set_text(text, $0), [() => t("position.clear_interruption")]);
				$.append($$anchor, fragment_2);
			};
			$.if(node_1, ($$render) => {
				if ($.get(interrupted).length) $$render(consequent);
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
				var div = root_4();
				var table = $.child(div);
				var thead = $.child(table);
				var tr = $.child(thead);
				var th = $.child(tr);
				var small = $.child(th);
				var text_2 = $.only_child(small, true);
				$.reset(th);
				var node_3 = $.sibling(th);
				$.each(node_3, 16, () => kinds, (kind) => kind, ($$anchor, kind) => {
					var th_1 = root_1();
					var text_3 = $.only_child(th_1, true);
					$.template_effect(($0) => {
						$.set_attribute(th_1, "data-kind", kind);
						$.set_text(text_3, $0);
					}, [() => kind === "absolute" ? $.get(status).position.system ?? t("position.g92") : t(`position.${kind}`)]);
					$.append($$anchor, th_1);
				});
				var th_2 = $.sibling(node_3);
				var text_4 = $.child(th_2);
				var small_1 = $.sibling(text_4);
				var text_5 = $.only_child(small_1, true);
				$.reset(th_2);
				$.reset(tr);
				$.reset(thead);
				var tbody = $.sibling(thead);
				$.each(tbody, 20, () => machine.axes, (axis) => axis, ($$anchor, axis) => {
					var tr_1 = root_3();
					var th_3 = $.child(tr_1);
					var text_6 = $.only_child(th_3, true);
					var node_4 = $.sibling(th_3);
					$.each(node_4, 16, () => kinds, (kind) => kind, ($$anchor, kind) => {
						var td = root_2();
						let classes;
						var text_7 = $.only_child(td, true);
						$.template_effect(($0) => {
							classes = $.set_class(td, 1, "right value s-2ni3hj", null, classes, { main: kind === "absolute" });
							$.set_text(text_7, $0);
						}, [() => fixed($.get(status).position[kind][axis])]);
						$.append($$anchor, td);
					});
					var td_1 = $.sibling(node_4);
					var text_8 = $.only_child(td_1, true);
					$.reset(tr_1);
					$.template_effect(($0) => {
						$.set_attribute(tr_1, "data-axis", axis);
						$.set_text(text_6, axis);
						$.set_attribute(td_1, "data-speed", axis);
						$.set_text(text_8, $0);
					}, [() => fixed($.get(status).feed.components[axis] ?? 0, 0)]);
					$.append($$anchor, tr_1);
				});
				$.reset(tbody);
				$.reset(table);
				$.reset(div);
				$.template_effect(($0, $1, $2) => {
					$.set_text(text_2, $0);
					$.set_text(text_4, `${$1 ?? ""} `);
					$.set_text(text_5, $2);
				}, [
					() => placeUnit(),
					() => t("position.speed"),
					() => t("unit.mm_min")
				]);
				$.append($$anchor, div);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var node_5 = $.sibling(node, 2);
	{
		let $0 = $.derived(() => t("position.relative"));
		Card(node_5, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div_1 = root_5();
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
