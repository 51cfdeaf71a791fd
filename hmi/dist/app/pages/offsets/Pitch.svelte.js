import { http } from "../../lib/api/http.js";
import { language, t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Find from "../../lib/parts/Find.svelte.js";
import { firstOfPage, numberNamed } from "../../lib/numbers.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/offsets/Pitch.svelte
var root = $.from_html(`<tr><th scope="row" class="code s-vz97nv"> </th><td> </td><td class="field s-vz97nv"><!></td><td class="number muted s-vz97nv"> </td></tr>`);
var root_1 = $.from_html(`<table class="table"><thead><tr><th> </th><th> </th><th class="right"> </th><th> </th></tr></thead><tbody></tbody></table>`);
var root_2 = $.from_html(`<!> <!> <!> <!>`, 1);
var root_3 = $.from_html(`<div><span class="code s-vz97nv"> </span> <!></div>`);
var root_4 = $.from_html(`<p class="muted s-vz97nv"> </p> <div class="grid s-vz97nv" data-testid="pitch-points"></div>`, 1);
var root_5 = $.from_html(`<!> <!>`, 1);
function Pitch($$anchor, $$props) {
	$.push($$props, true);
	let all = $.state([]);
	let values = $.state({});
	const wanted = [
		"P216",
		"P217",
		"P218",
		"P219",
		"P221",
		"P222",
		"P223",
		"P224",
		"P226",
		"P227",
		"P228",
		"P229"
	];
	$.user_effect(() => {
		http.parameters(language()).then((now) => $.set(all, now), (failed) => machine.refused(failed));
	});
	$.user_effect(() => {
		machine.changed("parameters");
		if (machine.link !== "open") return;
		machine.fetch("parameters", {
			do: "parameters",
			names: wanted.filter((name) => $.get(all).some((one) => one.name === name))
		}).then((reply) => {
			if (reply) $.set(values, reply.parameters);
		});
	});
	const shown = $.derived(() => $.get(all).filter((one) => wanted.includes(one.name)));
	/** Points of an axis, and how many are shown at once. */
	const POINTS = 1e4;
	const PAGE = 100;
	let axis = $.state("X");
	let first = $.state(0);
	let points = $.state({});
	const axes = $.derived(() => machine.axes.map((value) => ({
		value,
		label: value
	})));
	const numbers = $.derived(() => Array.from({ length: PAGE }, (_, index) => $.get(first) + index));
	async function read() {
		const of = $.get(axis);
		const reply = await machine.fetch("pitch", {
			do: "pitch",
			axis: of
		});
		if (reply && of === $.get(axis)) $.set(points, reply.points);
	}
	$.user_effect(() => {
		machine.changed("pitch");
		$.get(axis);
		if (machine.link === "open") read();
	});
	var fragment = root_5();
	var node = $.first_child(fragment);
	var consequent = ($$anchor) => {
		{
			let $0 = $.derived(() => t("offsets.pitch"));
			Card($$anchor, {
				get title() {
					return $.get($0);
				},
				flush: true,
				children: ($$anchor, $$slotProps) => {
					var table = root_1();
					var thead = $.child(table);
					var tr = $.child(thead);
					var th = $.child(tr);
					var text_1 = $.only_child(th, true);
					var th_1 = $.sibling(th);
					var text_2 = $.only_child(th_1, true);
					var th_2 = $.sibling(th_1);
					var text_3 = $.only_child(th_2, true);
					var th_3 = $.sibling(th_2);
					var text_4 = $.only_child(th_3, true);
					$.reset(tr);
					$.reset(thead);
					var tbody = $.sibling(thead);
					$.each(tbody, 21, () => $.get(shown), (one) => one.name, ($$anchor, one) => {
						var tr_1 = root();
						var th_4 = $.child(tr_1);
						var text_5 = $.only_child(th_4, true);
						var td = $.sibling(th_4);
						var text_6 = $.only_child(td, true);
						var td_1 = $.sibling(td);
						var node_1 = $.child(td_1);
						{
							let $0 = $.derived(() => $.get(values)[$.get(one).name] ?? $.get(one).standard);
							let $1 = $.derived(() => $.get(one).minimum ?? -Infinity);
							let $2 = $.derived(() => $.get(one).maximum ?? Infinity);
							NumberField(node_1, {
								get value() {
									return $.get($0);
								},
								digits: 4,
								get label() {
									return $.get(one).name;
								},
								get unit() {
									return $.get(one).unit;
								},
								get minimum() {
									return $.get($1);
								},
								get maximum() {
									return $.get($2);
								},
								onvalue: (value) => void machine.tell({
									do: "set_parameter",
									name: $.get(one).name,
									value
								})
							});
						}
						$.reset(td_1);
						var td_2 = $.sibling(td_1);
						var text_7 = $.only_child(td_2);
						$.reset(tr_1);
						$.template_effect(() => {
							$.set_text(text_5, $.get(one).name);
							$.set_text(text_6, $.get(one).meaning);
							$.set_text(text_7, `${$.get(one).minimum ?? "–" ?? ""} … ${$.get(one).maximum ?? "–" ?? ""}`);
						});
						$.append($$anchor, tr_1);
					});
					$.reset(tbody);
					$.reset(table);
					$.template_effect(($0, $1, $2, $3) => {
						$.set_text(text_1, $0);
						$.set_text(text_2, $1);
						$.set_text(text_3, $2);
						$.set_text(text_4, $3);
					}, [
						() => t("offsets.number"),
						() => t("offsets.meaning"),
						() => t("offsets.value"),
						() => t("offsets.range")
					]);
					$.append($$anchor, table);
				},
				$$slots: { default: true }
			});
		}
	};
	$.if(node, ($$render) => {
		if ($.get(shown).length) $$render(consequent);
	});
	var node_2 = $.sibling(node, 2);
	{
		const actions = ($$anchor) => {
			var fragment_2 = root_2();
			var node_3 = $.first_child(fragment_2);
			{
				let $0 = $.derived(() => t("offsets.find"));
				Find(node_3, {
					get label() {
						return $.get($0);
					},
					placeholder: "120",
					meant: (text) => numberNamed(text, "", 0, 9999),
					at: "data-point",
					onfind: (point) => $.set(first, firstOfPage(Number(point), 0, PAGE), true),
					"data-testid": "find-point"
				});
			}
			var node_4 = $.sibling(node_3, 2);
			{
				let $0 = $.derived(() => t("panel.axes"));
				Segmented(node_4, {
					get options() {
						return $.get(axes);
					},
					get label() {
						return $.get($0);
					},
					onchange: () => $.set(first, 0),
					get value() {
						return $.get(axis);
					},
					set value($$value) {
						$.set(axis, $$value, true);
					}
				});
			}
			var node_5 = $.sibling(node_4, 2);
			{
				let $0 = $.derived(() => t("offsets.before"));
				let $1 = $.derived(() => $.get(first) === 0);
				Button(node_5, {
					icon: "left",
					get "aria-label"() {
						return $.get($0);
					},
					get disabled() {
						return $.get($1);
					},
					onclick: () => $.set(first, $.get(first) - PAGE)
				});
			}
			var node_6 = $.sibling(node_5, 2);
			{
				let $0 = $.derived(() => t("offsets.after"));
				let $1 = $.derived(() => $.get(first) + PAGE >= POINTS);
				Button(node_6, {
					icon: "right",
					get "aria-label"() {
						return $.get($0);
					},
					get disabled() {
						return $.get($1);
					},
					onclick: () => $.set(first, $.get(first) + PAGE)
				});
			}
			$.append($$anchor, fragment_2);
		};
		let $0 = $.derived(() => t("offsets.pitch_points"));
		Card(node_2, {
			get title() {
				return $.get($0);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_3 = root_4();
				var p = $.first_child(fragment_3);
				var text_8 = $.only_child(p, true);
				var div = $.sibling(p, 2);
				$.each(div, 20, () => $.get(numbers), (number) => number, ($$anchor, number) => {
					var div_1 = root_3();
					let classes;
					var span = $.child(div_1);
					var text_9 = $.only_child(span, true);
					var node_7 = $.sibling(span, 2);
					{
						let $0 = $.derived(() => $.get(points)[number] ?? 0);
						let $1 = $.derived(() => `${$.get(axis)} ${number}`);
						NumberField(node_7, {
							get value() {
								return $.get($0);
							},
							digits: 4,
							get label() {
								return $.get($1);
							},
							onvalue: (value) => void machine.tell({
								do: "set_pitch",
								axis: $.get(axis),
								points: { [number]: value ?? 0 }
							}).then(() => read())
						});
					}
					$.reset(div_1);
					$.template_effect(() => {
						classes = $.set_class(div_1, 1, "point s-vz97nv", null, classes, { set: number in $.get(points) });
						$.set_attribute(div_1, "data-point", number);
						$.set_text(text_9, number);
					});
					$.append($$anchor, div_1);
				});
				$.reset(div);
				$.template_effect(($0) => $.set_text(text_8, $0), [() => t("offsets.pitch_hint")]);
				$.append($$anchor, fragment_3);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.append($$anchor, fragment);
	$.pop();
}
export { Pitch as default };
