import { t } from "../../lib/i18n/index.svelte.js";
import { SYSTEMS, edge, middle, zeroAt } from "../../lib/measuring.js";
import { fixed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Labelled from "../../lib/parts/Labelled.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { notify } from "../../lib/state/notices.svelte.js";
import { untrack } from "svelte";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/settings/Centring.svelte
var form = $.proxy({
	kind: "middle",
	system: "G54",
	axis: "X",
	from: "below",
	radius: 5,
	coordinate: 0,
	begun: false
});
var root = $.from_svg(`<circle r="10"></circle>`);
var root_1 = $.from_svg(`<circle cx="120" cy="75" r="58" class="work s-1tpnn43"></circle><!>`, 1);
var root_2 = $.from_svg(`<circle cx="120" cy="29" r="11"></circle><circle cx="120" cy="121" r="11"></circle>`, 1);
var root_3 = $.from_svg(`<circle cx="120" cy="29" r="11"></circle>`);
var root_4 = $.from_svg(`<circle cx="59" cy="75" r="11"></circle>`);
var root_5 = $.from_svg(`<circle cx="181" cy="75" r="11"></circle>`);
var root_6 = $.from_svg(`<rect x="70" y="40" width="100" height="70" class="work s-1tpnn43"></rect><!><!><!><!>`, 1);
var root_7 = $.from_svg(`<path class="zero s-1tpnn43"></path>`);
var root_8 = $.from_html(`<option> </option>`);
var root_9 = $.from_html(`<select></select>`);
var root_10 = $.from_html(`<div class="row wrap"><!> <!></div>`);
var root_11 = $.from_html(`<div class="form s-1tpnn43"><!> <svg viewBox="0 0 240 150" role="img" class="s-1tpnn43"><!><!></svg> <div class="fields s-1tpnn43"><!> <!> <!></div> <!></div>`);
var root_12 = $.from_html(`<td class="right"><small class="muted"> </small> </td>`);
var root_13 = $.from_html(`<td class="right"> </td>`);
var root_14 = $.from_html(`<tr><th><!></th><!></tr>`);
var root_15 = $.from_html(`<strong> </strong>`);
var root_16 = $.from_html(`<p class="muted s-1tpnn43"> </p>`);
var root_17 = $.from_html(`<div class="result number s-1tpnn43"><!> <!></div>`);
var root_18 = $.from_html(`<p class="bad s-1tpnn43"> </p>`);
var root_19 = $.from_html(`<div class="form s-1tpnn43"><p class="muted"> </p> <table class="table"><tbody><tr><th> </th><!></tr><!></tbody></table> <div class="row"><!> <!></div> <!> <!></div>`);
var root_20 = $.from_html(`<div class="centring s-1tpnn43"><!> <!></div>`);
function Centring($$anchor, $$props) {
	$.push($$props, true);
	const kind = $.derived(() => form.kind), system = $.derived(() => form.system), axis = $.derived(() => form.axis), from = $.derived(() => form.from), radius = $.derived(() => form.radius), coordinate = $.derived(() => form.coordinate);
	/** Points that the control has taken, by number: machine positions. */
	let points = $.state({});
	/** The point that is taken next, where somebody has chosen one. */
	let chosen = $.state(null);
	/** What the control makes of them. */
	let centre = $.state(null);
	const kinds = $.derived(() => [
		"edge",
		"middle",
		"rectangle",
		"circle"
	].map((value) => ({
		value,
		label: t(`settings.${value}`)
	})));
	/** A work has one end along Z. */
	const axes = $.derived(() => machine.axes.filter((one) => ($.get(kind) === "edge" ? "XYZ" : "XY").includes(one)).map((value) => ({
		value,
		label: value
	})));
	/** Z is touched with the end of the tool, which the tool's radius says nothing of. */
	const isEnd = $.derived(() => $.get(kind) === "edge" && $.get(axis) === "Z");
	const sides = $.derived(() => ["below", "above"].map((value) => ({
		value,
		label: t(`settings.from_${value}`)
	})));
	const wanted = $.derived(() => ({
		edge: 1,
		middle: 2,
		rectangle: 4,
		circle: 3
	})[$.get(kind)]);
	/** A circle may have more points than it needs. */
	const most = $.derived(() => $.get(kind) === "circle" ? 8 : $.get(wanted));
	const has = (number) => $.get(points)[number] !== void 0;
	const taken = $.derived(() => Object.keys($.get(points)).filter((number) => Number(number) <= $.get(most)).length);
	const numbers = $.derived(() => {
		const all = Array.from({ length: $.get(most) }, (_, index) => index + 1);
		return $.get(kind) === "circle" ? all.filter((number) => number <= Math.max($.get(wanted), $.get(taken) + 1) || has(number)) : all;
	});
	const next = $.derived(() => $.get(chosen) ?? $.get(numbers).find((number) => !has(number)) ?? $.get(most));
	const here = $.derived(() => machine.status?.position.machine ?? {});
	const result = $.derived(() => {
		if ($.get(taken) < $.get(wanted)) return null;
		if ($.get(kind) === "edge") return {
			axes: { [$.get(axis)]: edge($.get(points)[1][$.get(axis)] ?? 0, $.get(isEnd) ? 0 : $.get(radius), $.get(from)) },
			texts: []
		};
		if ($.get(kind) === "middle") {
			const found = middle($.get(points)[1][$.get(axis)] ?? 0, $.get(points)[2][$.get(axis)] ?? 0, $.get(radius));
			return {
				axes: { [$.get(axis)]: found.centre },
				texts: [t("settings.apart", {
					inner: fixed(found.inner),
					outer: fixed(found.outer)
				})]
			};
		}
		if (!$.get(centre)) return null;
		const { X = 0, Y = 0 } = $.get(centre).place;
		const size = $.get(kind) === "circle" ? "settings.diameters" : "settings.apart";
		const texts = $.get(centre).sizes.map((apart) => t(size, {
			inner: fixed(apart + 2 * $.get(radius)),
			outer: fixed(apart - 2 * $.get(radius))
		}));
		return {
			axes: {
				X,
				Y
			},
			texts: $.get(kind) === "circle" && $.get(taken) > 3 ? [...texts, t("settings.out_of_round", { value: fixed($.get(centre).out_of_round) })] : texts
		};
	});
	async function read() {
		const reply = await machine.fetch("points", { do: "points" });
		if (reply) $.set(points, reply.points);
		$.set(centre, null);
		if ($.get(taken) < $.get(wanted) || $.get(kind) === "edge" || $.get(kind) === "middle") return;
		const measured = await machine.fetch("measured", {
			do: "centre",
			circle: $.get(kind) === "circle",
			values: {}
		});
		$.set(centre, measured?.measured ?? null);
	}
	$.user_effect(() => {
		if (machine.link === "open") untrack(() => form.begun && void read());
	});
	async function again() {
		$.set(points, {});
		$.set(centre, null);
		$.set(chosen, null);
		form.begun = false;
		await machine.tell({ do: "clear_points" });
	}
	function choose() {
		if ($.get(kind) !== "edge" && $.get(axis) === "Z") form.axis = "X";
		again();
	}
	async function take() {
		const number = $.get(next);
		if (!form.begun && !await machine.tell({ do: "clear_points" })) return;
		form.begun = true;
		if (!await machine.tell({
			do: "touch_point",
			number
		})) return;
		$.set(chosen, null);
		await read();
	}
	async function apply() {
		if (!$.get(result)) return;
		if ($.get(kind) === "edge" || $.get(kind) === "middle") {
			const found = $.get(result).axes;
			const reply = await machine.fetch("zeros", { do: "zeros" });
			if (!reply || !await machine.tell({
				do: "set_zero",
				system: $.get(system),
				axes: zeroAt(found, $.get(coordinate), reply.zeros.external ?? {})
			})) return;
		} else if (!await machine.tell({
			do: "centre",
			circle: $.get(kind) === "circle",
			system: $.get(system),
			values: {
				X: $.get(coordinate),
				Y: $.get(coordinate)
			}
		})) return;
		notify({
			kind: "done",
			title: t("settings.zero_set", { system: $.get(system) })
		});
		await again();
	}
	var div = root_20();
	var node = $.child(div);
	{
		let $0 = $.derived(() => t("settings.centring"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div_1 = root_11();
				var node_1 = $.child(div_1);
				{
					let $0 = $.derived(() => t("settings.centring"));
					Segmented(node_1, {
						get options() {
							return $.get(kinds);
						},
						get label() {
							return $.get($0);
						},
						onchange: choose,
						get value() {
							return form.kind;
						},
						set value($$value) {
							form.kind = $$value;
						}
					});
				}
				var svg = $.sibling(node_1, 2);
				var node_2 = $.child(svg);
				var consequent = ($$anchor) => {
					var fragment = root_1();
					var node_3 = $.sibling($.first_child(fragment));
					$.each(node_3, 18, () => [
						-90,
						30,
						150
					], (angle) => angle, ($$anchor, angle, index) => {
						var circle = root();
						let classes;
						$.template_effect(($0, $1, $2) => {
							$.set_attribute(circle, "cx", $0);
							$.set_attribute(circle, "cy", $1);
							classes = $.set_class(circle, 0, "touch s-1tpnn43", null, classes, { done: $2 });
						}, [
							() => 120 + 48 * Math.cos(angle * Math.PI / 180),
							() => 75 + 48 * Math.sin(angle * Math.PI / 180),
							() => has($.get(index) + 1)
						]);
						$.append($$anchor, circle);
					});
					$.append($$anchor, fragment);
				};
				var alternate = ($$anchor) => {
					var fragment_1 = root_6();
					var node_4 = $.sibling($.first_child(fragment_1));
					var consequent_1 = ($$anchor) => {
						var fragment_2 = root_2();
						var circle_1 = $.first_child(fragment_2);
						let classes_1;
						var circle_2 = $.sibling(circle_1);
						let classes_2;
						$.template_effect(($0, $1) => {
							classes_1 = $.set_class(circle_1, 0, "touch s-1tpnn43", null, classes_1, { done: $0 });
							classes_2 = $.set_class(circle_2, 0, "touch s-1tpnn43", null, classes_2, { done: $1 });
						}, [() => has(4), () => has(3)]);
						$.append($$anchor, fragment_2);
					};
					$.if(node_4, ($$render) => {
						if ($.get(kind) === "rectangle") $$render(consequent_1);
					});
					var node_5 = $.sibling(node_4);
					var consequent_2 = ($$anchor) => {
						var circle_3 = root_3();
						let classes_3;
						$.template_effect(($0) => classes_3 = $.set_class(circle_3, 0, "touch s-1tpnn43", null, classes_3, { done: $0 }), [() => has(1)]);
						$.append($$anchor, circle_3);
					};
					$.if(node_5, ($$render) => {
						if ($.get(isEnd)) $$render(consequent_2);
					});
					var node_6 = $.sibling(node_5);
					var consequent_3 = ($$anchor) => {
						var circle_4 = root_4();
						let classes_4;
						$.template_effect(($0) => classes_4 = $.set_class(circle_4, 0, "touch s-1tpnn43", null, classes_4, { done: $0 }), [() => has(1)]);
						$.append($$anchor, circle_4);
					};
					$.if(node_6, ($$render) => {
						if (!$.get(isEnd) && ($.get(kind) !== "edge" || $.get(from) === "below")) $$render(consequent_3);
					});
					var node_7 = $.sibling(node_6);
					var consequent_4 = ($$anchor) => {
						var circle_5 = root_5();
						let classes_5;
						$.template_effect(($0) => classes_5 = $.set_class(circle_5, 0, "touch s-1tpnn43", null, classes_5, { done: $0 }), [() => has($.get(kind) === "edge" ? 1 : 2)]);
						$.append($$anchor, circle_5);
					};
					$.if(node_7, ($$render) => {
						if (!$.get(isEnd) && ($.get(kind) !== "edge" || $.get(from) === "above")) $$render(consequent_4);
					});
					$.append($$anchor, fragment_1);
				};
				$.if(node_2, ($$render) => {
					if ($.get(kind) === "circle") $$render(consequent);
					else $$render(alternate, -1);
				});
				var node_8 = $.sibling(node_2);
				var consequent_5 = ($$anchor) => {
					var path = root_7();
					$.template_effect(() => $.set_attribute(path, "d", $.get(isEnd) ? "M65 40H175M120 25V55" : $.get(kind) === "edge" ? $.get(from) === "below" ? "M70 20V130M55 75H85" : "M170 20V130M155 75H185" : "M120 20V130M65 75H175"));
					$.append($$anchor, path);
				};
				$.if(node_8, ($$render) => {
					if ($.get(result)) $$render(consequent_5);
				});
				$.reset(svg);
				var div_2 = $.sibling(svg, 2);
				var node_9 = $.child(div_2);
				{
					let $0 = $.derived(() => t("settings.system"));
					Labelled(node_9, {
						get label() {
							return $.get($0);
						},
						children: ($$anchor, $$slotProps) => {
							var select = root_9();
							$.each(select, 20, () => SYSTEMS, (one) => one, ($$anchor, one) => {
								var option = root_8();
								var text_1 = $.only_child(option, true);
								var option_value = {};
								$.template_effect(() => {
									$.set_text(text_1, one);
									if (option_value !== (option_value = one)) option.__value = option_value;
								});
								$.append($$anchor, option);
							});
							$.reset(select);
							$.init_select(select);
							$.bind_select_value(select, () => form.system, ($$value) => form.system = $$value);
							$.append($$anchor, select);
						},
						$$slots: { default: true }
					});
				}
				var node_10 = $.sibling(node_9, 2);
				var consequent_6 = ($$anchor) => {
					{
						let $0 = $.derived(() => t("settings.tool_radius"));
						Labelled($$anchor, {
							get label() {
								return $.get($0);
							},
							children: ($$anchor, $$slotProps) => {
								{
									let $0 = $.derived(() => t("unit.mm"));
									let $1 = $.derived(() => t("settings.tool_radius"));
									NumberField($$anchor, {
										get value() {
											return $.get(radius);
										},
										minimum: 0,
										get unit() {
											return $.get($0);
										},
										get label() {
											return $.get($1);
										},
										onvalue: (value) => form.radius = value ?? 0
									});
								}
							},
							$$slots: { default: true }
						});
					}
				};
				$.if(node_10, ($$render) => {
					if (!$.get(isEnd)) $$render(consequent_6);
				});
				var node_11 = $.sibling(node_10, 2);
				{
					let $0 = $.derived(() => t("settings.coordinate"));
					Labelled(node_11, {
						get label() {
							return $.get($0);
						},
						children: ($$anchor, $$slotProps) => {
							{
								let $0 = $.derived(() => t("unit.mm"));
								let $1 = $.derived(() => t("settings.coordinate"));
								NumberField($$anchor, {
									get value() {
										return $.get(coordinate);
									},
									get unit() {
										return $.get($0);
									},
									get label() {
										return $.get($1);
									},
									onvalue: (value) => form.coordinate = value ?? 0
								});
							}
						},
						$$slots: { default: true }
					});
				}
				$.reset(div_2);
				var node_12 = $.sibling(div_2, 2);
				var consequent_8 = ($$anchor) => {
					var div_3 = root_10();
					var node_13 = $.child(div_3);
					{
						let $0 = $.derived(() => t("panel.axes"));
						Segmented(node_13, {
							get options() {
								return $.get(axes);
							},
							get label() {
								return $.get($0);
							},
							onchange: () => void again(),
							get value() {
								return form.axis;
							},
							set value($$value) {
								form.axis = $$value;
							}
						});
					}
					var node_14 = $.sibling(node_13, 2);
					var consequent_7 = ($$anchor) => {
						{
							let $0 = $.derived(() => t("settings.from"));
							Segmented($$anchor, {
								get options() {
									return $.get(sides);
								},
								get label() {
									return $.get($0);
								},
								get value() {
									return form.from;
								},
								set value($$value) {
									form.from = $$value;
								}
							});
						}
					};
					$.if(node_14, ($$render) => {
						if ($.get(kind) === "edge" && !$.get(isEnd)) $$render(consequent_7);
					});
					$.reset(div_3);
					$.append($$anchor, div_3);
				};
				$.if(node_12, ($$render) => {
					if ($.get(kind) === "edge" || $.get(kind) === "middle") $$render(consequent_8);
				});
				$.reset(div_1);
				$.template_effect(($0) => $.set_attribute(svg, "aria-label", $0), [() => t(`settings.${$.get(kind)}`)]);
				$.append($$anchor, div_1);
			},
			$$slots: { default: true }
		});
	}
	var node_15 = $.sibling(node, 2);
	{
		let $0 = $.derived(() => t("settings.points", {
			taken: $.get(taken),
			wanted: $.get(wanted)
		}));
		Card(node_15, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div_4 = root_19();
				var p = $.child(div_4);
				var text_2 = $.only_child(p, true);
				var table = $.sibling(p, 2);
				var tbody = $.child(table);
				var tr = $.child(tbody);
				var th = $.child(tr);
				var text_3 = $.only_child(th, true);
				var node_16 = $.sibling(th);
				$.each(node_16, 16, () => [
					"X",
					"Y",
					"Z"
				], (one) => one, ($$anchor, one) => {
					var td = root_12();
					var small = $.child(td);
					var text_4 = $.only_child(small, true);
					var text_5 = $.sibling(small);
					$.reset(td);
					$.template_effect(($0) => {
						$.set_text(text_4, one);
						$.set_text(text_5, ` ${$0 ?? ""}`);
					}, [() => fixed($.get(here)[one])]);
					$.append($$anchor, td);
				});
				$.reset(tr);
				var node_17 = $.sibling(tr);
				$.each(node_17, 16, () => $.get(numbers), (number) => number, ($$anchor, number) => {
					var tr_1 = root_14();
					var th_1 = $.child(tr_1);
					var node_18 = $.child(th_1);
					{
						let $0 = $.derived(() => number === $.get(next));
						let $1 = $.derived(() => t("settings.point", { number }));
						Button(node_18, {
							get pressed() {
								return $.get($0);
							},
							get "aria-label"() {
								return $.get($1);
							},
							onclick: () => $.set(chosen, number, true),
							children: ($$anchor, $$slotProps) => {
								$.next();
								var text_6 = $.text();
								$.template_effect(() => $.set_text(text_6, number));
								$.append($$anchor, text_6);
							},
							$$slots: { default: true }
						});
					}
					$.reset(th_1);
					var node_19 = $.sibling(th_1);
					$.each(node_19, 16, () => [
						"X",
						"Y",
						"Z"
					], (one) => one, ($$anchor, one) => {
						var td_1 = root_13();
						var text_7 = $.only_child(td_1, true);
						$.template_effect(($0) => $.set_text(text_7, $0), [() => fixed($.get(points)[number]?.[one])]);
						$.append($$anchor, td_1);
					});
					$.reset(tr_1);
					$.template_effect(($0) => $.set_attribute(tr_1, "data-taken", $0), [() => has(number) ? number : void 0]);
					$.append($$anchor, tr_1);
				});
				$.reset(tbody);
				$.reset(table);
				var div_5 = $.sibling(table, 2);
				var node_20 = $.child(div_5);
				Button(node_20, {
					icon: "target",
					onclick: () => void take(),
					"data-testid": "touch",
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_8 = $.text();
						$.template_effect(($0) => $.set_text(text_8, $0), [() => t("settings.take")]);
						$.append($$anchor, text_8);
					},
					$$slots: { default: true }
				});
				var node_21 = $.sibling(node_20, 2);
				{
					let $0 = $.derived(() => $.get(taken) === 0);
					Button(node_21, {
						icon: "reset",
						get disabled() {
							return $.get($0);
						},
						onclick: () => void again(),
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_9 = $.text();
							$.template_effect(($0) => $.set_text(text_9, $0), [() => t("settings.again")]);
							$.append($$anchor, text_9);
						},
						$$slots: { default: true }
					});
				}
				$.reset(div_5);
				var node_22 = $.sibling(div_5, 2);
				var consequent_9 = ($$anchor) => {
					var div_6 = root_17();
					var node_23 = $.child(div_6);
					$.each(node_23, 17, () => Object.entries($.get(result).axes), ([name, place]) => name, ($$anchor, $$item) => {
						var $$array = $.derived(() => $.to_array($.get($$item), 2));
						let name = () => $.get($$array)[0];
						let place = () => $.get($$array)[1];
						var strong = root_15();
						var text_10 = $.only_child(strong);
						$.template_effect(($0) => $.set_text(text_10, `${name() ?? ""} ${$0 ?? ""}`), [() => fixed(place())]);
						$.append($$anchor, strong);
					});
					var node_24 = $.sibling(node_23, 2);
					$.each(node_24, 17, () => $.get(result).texts, $.index, ($$anchor, text) => {
						var p_1 = root_16();
						var text_11 = $.only_child(p_1, true);
						$.template_effect(() => $.set_text(text_11, $.get(text)));
						$.append($$anchor, p_1);
					});
					$.reset(div_6);
					$.append($$anchor, div_6);
				};
				var consequent_10 = ($$anchor) => {
					var p_2 = root_18();
					var text_12 = $.only_child(p_2, true);
					$.template_effect(($0) => $.set_text(text_12, $0), [() => t("settings.on_a_line")]);
					$.append($$anchor, p_2);
				};
				$.if(node_22, ($$render) => {
					if ($.get(result)) $$render(consequent_9);
					else if ($.get(taken) >= $.get(wanted)) $$render(consequent_10, 1);
				});
				var node_25 = $.sibling(node_22, 2);
				{
					let $0 = $.derived(() => !$.get(result));
					Button(node_25, {
						kind: "primary",
						icon: "check",
						get disabled() {
							return $.get($0);
						},
						onclick: () => void apply(),
						"data-testid": "set-zero",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_13 = $.text();
							$.template_effect(($0) => $.set_text(text_13, $0), [() => t("settings.apply", { system: $.get(system) })]);
							$.append($$anchor, text_13);
						},
						$$slots: { default: true }
					});
				}
				$.reset(div_4);
				$.template_effect(($0, $1) => {
					$.set_text(text_2, $0);
					$.set_text(text_3, $1);
				}, [() => t(`settings.${$.get(kind)}_text`), () => t("settings.now")]);
				$.append($$anchor, div_4);
			},
			$$slots: { default: true }
		});
	}
	$.reset(div);
	$.append($$anchor, div);
	$.pop();
}
export { Centring as default };
