import { t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/settings/Zeros.svelte
var root = $.from_html(`<!> <!>`, 1);
var root_1 = $.from_html(`<th class="right s-1si0ian"> </th>`);
var root_2 = $.from_html(`<td><div class="row s-1si0ian"><!> <!></div></td>`);
var root_3 = $.from_html(`<tr><th scope="row" class="code s-1si0ian"> </th><!></tr>`);
var root_4 = $.from_html(`<table class="table" data-testid="zeros"><thead><tr><th class="s-1si0ian"> </th><!></tr></thead><tbody></tbody></table>`);
var root_5 = $.from_html(`<!> <p class="muted s-1si0ian"> </p>`, 1);
function Zeros($$anchor, $$props) {
	$.push($$props, true);
	let zeros = $.state({});
	let more = $.state(false);
	const basic = [
		"external",
		"G54",
		"G55",
		"G56",
		"G57",
		"G58",
		"G59"
	];
	const systems = $.derived(() => $.get(more) ? Array.from({ length: 50 }, (_, index) => `G54 P${index + 1}`) : basic);
	const current = $.derived(() => machine.status?.position.system ?? "");
	$.user_effect(() => {
		machine.changed("zeros");
		if (machine.link !== "open") return;
		machine.fetch("zeros", { do: "zeros" }).then((reply) => {
			if (reply) $.set(zeros, reply.zeros);
		});
	});
	var fragment = root_5();
	var node = $.first_child(fragment);
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var node_1 = $.first_child(fragment_1);
			{
				let $0 = $.derived(() => !$.get(more));
				Button(node_1, {
					get pressed() {
						return $.get($0);
					},
					onclick: () => $.set(more, false),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text = $.text("G54 – G59");
						$.append($$anchor, text);
					},
					$$slots: { default: true }
				});
			}
			var node_2 = $.sibling(node_1, 2);
			Button(node_2, {
				get pressed() {
					return $.get(more);
				},
				onclick: () => $.set(more, true),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_1 = $.text("G54 P1 – P50");
					$.append($$anchor, text_1);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("settings.zeros"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			fill: true,
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var table = root_4();
				var thead = $.child(table);
				var tr = $.child(thead);
				var th = $.child(tr);
				var text_2 = $.only_child(th, true);
				var node_3 = $.sibling(th);
				$.each(node_3, 16, () => machine.axes, (axis) => axis, ($$anchor, axis) => {
					var th_1 = root_1();
					var text_3 = $.only_child(th_1, true);
					$.template_effect(() => $.set_text(text_3, axis));
					$.append($$anchor, th_1);
				});
				$.reset(tr);
				$.reset(thead);
				var tbody = $.sibling(thead);
				$.each(tbody, 20, () => $.get(systems), (system) => system, ($$anchor, system) => {
					var tr_1 = root_3();
					let classes;
					var th_2 = $.child(tr_1);
					var text_4 = $.only_child(th_2, true);
					var node_4 = $.sibling(th_2);
					$.each(node_4, 16, () => machine.axes, (axis) => axis, ($$anchor, axis) => {
						var td = root_2();
						var div = $.child(td);
						var node_5 = $.child(div);
						{
							let $0 = $.derived(() => $.get(zeros)[system]?.[axis] ?? 0);
							let $1 = $.derived(() => `${system} ${axis}`);
							NumberField(node_5, {
								get value() {
									return $.get($0);
								},
								get label() {
									return $.get($1);
								},
								onvalue: (value) => {
									if (value !== null) machine.tell({
										do: "set_zero",
										system,
										axes: { [axis]: value }
									});
								}
							});
						}
						var node_6 = $.sibling(node_5, 2);
						var consequent = ($$anchor) => {
							{
								let $0 = $.derived(() => t("settings.here", { axis }));
								let $1 = $.derived(() => t("settings.here", { axis: `${system} ${axis}` }));
								Button($$anchor, {
									icon: "target",
									get title() {
										return $.get($0);
									},
									get "aria-label"() {
										return $.get($1);
									},
									onclick: () => void machine.tell({
										do: "zero_here",
										system,
										axes: { [axis]: 0 }
									})
								});
							}
						};
						$.if(node_6, ($$render) => {
							if (system !== "external") $$render(consequent);
						});
						$.reset(div);
						$.reset(td);
						$.append($$anchor, td);
					});
					$.reset(tr_1);
					$.template_effect(($0) => {
						$.set_attribute(tr_1, "data-system", system);
						classes = $.set_class(tr_1, 1, "s-1si0ian", null, classes, { current: system === $.get(current) });
						$.set_text(text_4, $0);
					}, [() => system === "external" ? t("settings.external") : system]);
					$.append($$anchor, tr_1);
				});
				$.reset(tbody);
				$.reset(table);
				$.template_effect(($0) => $.set_text(text_2, $0), [() => t("settings.system")]);
				$.append($$anchor, table);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var p = $.sibling(node, 2);
	var text_5 = $.only_child(p, true);
	$.template_effect(($0) => $.set_text(text_5, $0), [() => t("settings.zeros_hint")]);
	$.append($$anchor, fragment);
	$.pop();
}
export { Zeros as default };
