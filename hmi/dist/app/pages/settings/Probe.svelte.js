import { t } from "../../lib/i18n/index.svelte.js";
import { fixed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Labelled from "../../lib/parts/Labelled.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/settings/Probe.svelte
var measured = ($$anchor, label = $.noop, value = $.noop, onvalue = $.noop, $$arg3) => {
	let empty = $.derived_safe_equal(() => $.fallback($$arg3?.(), false));
	Labelled($$anchor, {
		get label() {
			return label();
		},
		children: ($$anchor, $$slotProps) => {
			{
				let $0 = $.derived(() => t("unit.mm"));
				NumberField($$anchor, {
					get value() {
						return value();
					},
					get empty() {
						return $.get(empty);
					},
					get unit() {
						return $.get($0);
					},
					get label() {
						return label();
					},
					get onvalue() {
						return onvalue();
					}
				});
			}
		},
		$$slots: { default: true }
	});
};
var root = $.from_html(`<!> <!>`, 1);
var root_1 = $.from_html(`<option> </option>`);
var root_2 = $.from_html(`<select></select>`);
var root_3 = $.from_html(`<div class="row wrap"><!> <!></div>`);
var root_4 = $.from_html(`<div class="form s-r7wnwv"><!> <div class="fields s-r7wnwv"><!> <!> <!> <!></div> <!> <!></div>`);
var root_5 = $.from_html(`<div class="form s-r7wnwv"><!> <div class="fields s-r7wnwv"><!> <!> <!> <!></div> <p class="muted"> </p> <!></div>`);
var root_6 = $.from_html(`<strong> </strong>`);
var root_7 = $.from_html(`<p class="s-r7wnwv"> </p>`);
var root_8 = $.from_html(`<div class="result number s-r7wnwv" data-testid="measured"><!> <p class="muted s-r7wnwv"> </p> <!></div>`);
var root_9 = $.from_html(`<p class="muted"> </p>`);
var root_10 = $.from_html(`<div data-testid="probe"><span class="grow" role="status"> </span> <!></div> <div class="probe s-r7wnwv"><!> <!> <!></div>`, 1);
function Probe($$anchor, $$props) {
	$.push($$props, true);
	let form = $.state("hole");
	let diameter = $.state(40);
	let lx = $.state(60);
	let ly = $.state(40);
	let axis = $.state("X");
	let way = $.state("positive");
	let distance = $.state(10);
	let depth = $.state(null);
	let system = $.state("G54");
	let tolerance = $.state(null);
	let mode = $.state("length");
	let h = $.state(1);
	let d = $.state(1);
	let length = $.state(null);
	let width = $.state(null);
	let last = $.state(null);
	const forms = $.derived(() => [
		"hole",
		"boss",
		"slot",
		"web",
		"edge"
	].map((value) => ({
		value,
		label: t(`probe.${value}`)
	})));
	const modes = $.derived(() => [
		"length",
		"diameter",
		"both"
	].map((value) => ({
		value,
		label: t(`probe.tool_${value}`)
	})));
	const axes = $.derived(() => [
		"X",
		"Y",
		"Z"
	].map((value) => ({
		value,
		label: value
	})));
	const ways = $.derived(() => ["positive", "negative"].map((value) => ({
		value,
		label: value === "positive" ? "+" : "−"
	})));
	const ready = $.derived(() => machine.status?.measure_ready ?? false);
	$.user_effect(() => {
		machine.fetch("measured", { do: "measured" }).then((reply) => $.set(last, reply?.measured ?? null));
		return machine.hear((event) => {
			if (event.event === "measured") $.set(last, event.measured);
		});
	});
	function wanted() {
		switch ($.get(form)) {
			case "hole":
			case "boss": return {
				form: $.get(form),
				diameter: $.get(diameter)
			};
			case "slot":
			case "web": return {
				form: $.get(form),
				lx: $.get(lx),
				ly: $.get(ly)
			};
			case "edge": return {
				form: $.get(form),
				axis: $.get(axis),
				positive: $.get(way) === "positive",
				distance: $.get(distance)
			};
		}
	}
	const measure = () => machine.tell({
		do: "measure",
		...wanted(),
		z: $.get(depth),
		system: $.get(system),
		values: {},
		tolerance: $.get(tolerance)
	});
	const measureTool = () => machine.tell({
		do: "measure_tool",
		mode: $.get(mode),
		h: $.get(mode) === "diameter" ? 0 : $.get(h),
		d: $.get(mode) === "length" ? 0 : $.get(d),
		length: $.get(length),
		diameter: $.get(width)
	});
	var fragment_2 = root_10();
	var div = $.first_child(fragment_2);
	let classes;
	var span = $.child(div);
	var text = $.only_child(span, true);
	var node = $.sibling(span, 2);
	var consequent = ($$anchor) => {
		Button($$anchor, {
			icon: "close",
			onclick: () => void machine.tell({ do: "cancel_measure" }),
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_1 = $.text();
				$.template_effect(($0) => $.set_text(text_1, $0), [() => t("app.cancel")]);
				$.append($$anchor, text_1);
			},
			$$slots: { default: true }
		});
	};
	$.if(node, ($$render) => {
		if ($.get(ready)) $$render(consequent);
	});
	$.reset(div);
	var div_1 = $.sibling(div, 2);
	var node_1 = $.child(div_1);
	{
		let $0 = $.derived(() => t("probe.work"));
		Card(node_1, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div_2 = root_4();
				var node_2 = $.child(div_2);
				{
					let $0 = $.derived(() => t("probe.work"));
					Segmented(node_2, {
						get options() {
							return $.get(forms);
						},
						get label() {
							return $.get($0);
						},
						get value() {
							return $.get(form);
						},
						set value($$value) {
							$.set(form, $$value, true);
						}
					});
				}
				var div_3 = $.sibling(node_2, 2);
				var node_3 = $.child(div_3);
				var consequent_1 = ($$anchor) => {
					{
						let $0 = $.derived(() => t("probe.diameter"));
						measured($$anchor, () => $.get($0), () => $.get(diameter), () => (value) => $.set(diameter, value ?? $.get(diameter), true));
					}
				};
				var consequent_2 = ($$anchor) => {
					var fragment_6 = root();
					var node_4 = $.first_child(fragment_6);
					{
						let $0 = $.derived(() => t("probe.along", { axis: "X" }));
						measured(node_4, () => $.get($0), () => $.get(lx), () => (value) => $.set(lx, value, true), () => true);
					}
					var node_5 = $.sibling(node_4, 2);
					{
						let $0 = $.derived(() => t("probe.along", { axis: "Y" }));
						measured(node_5, () => $.get($0), () => $.get(ly), () => (value) => $.set(ly, value, true), () => true);
					}
					$.append($$anchor, fragment_6);
				};
				var alternate = ($$anchor) => {
					{
						let $0 = $.derived(() => t("probe.distance"));
						measured($$anchor, () => $.get($0), () => $.get(distance), () => (value) => $.set(distance, value ?? $.get(distance), true));
					}
				};
				$.if(node_3, ($$render) => {
					if ($.get(form) === "hole" || $.get(form) === "boss") $$render(consequent_1);
					else if ($.get(form) === "slot" || $.get(form) === "web") $$render(consequent_2, 1);
					else $$render(alternate, -1);
				});
				var node_6 = $.sibling(node_3, 2);
				{
					let $0 = $.derived(() => t("probe.height"));
					measured(node_6, () => $.get($0), () => $.get(depth), () => (value) => $.set(depth, value, true), () => true);
				}
				var node_7 = $.sibling(node_6, 2);
				{
					let $0 = $.derived(() => t("probe.tolerance"));
					measured(node_7, () => $.get($0), () => $.get(tolerance), () => (value) => $.set(tolerance, value, true), () => true);
				}
				var node_8 = $.sibling(node_7, 2);
				{
					let $0 = $.derived(() => t("settings.system"));
					Labelled(node_8, {
						get label() {
							return $.get($0);
						},
						children: ($$anchor, $$slotProps) => {
							var select = root_2();
							$.each(select, 20, () => [
								"G54",
								"G55",
								"G56",
								"G57",
								"G58",
								"G59"
							], (one) => one, ($$anchor, one) => {
								var option = root_1();
								var text_2 = $.only_child(option, true);
								var option_value = {};
								$.template_effect(() => {
									$.set_text(text_2, one);
									if (option_value !== (option_value = one)) option.__value = option_value;
								});
								$.append($$anchor, option);
							});
							$.reset(select);
							$.init_select(select);
							$.bind_select_value(select, () => $.get(system), ($$value) => $.set(system, $$value));
							$.append($$anchor, select);
						},
						$$slots: { default: true }
					});
				}
				$.reset(div_3);
				var node_9 = $.sibling(div_3, 2);
				var consequent_3 = ($$anchor) => {
					var div_4 = root_3();
					var node_10 = $.child(div_4);
					{
						let $0 = $.derived(() => t("panel.axes"));
						Segmented(node_10, {
							get options() {
								return $.get(axes);
							},
							get label() {
								return $.get($0);
							},
							get value() {
								return $.get(axis);
							},
							set value($$value) {
								$.set(axis, $$value, true);
							}
						});
					}
					var node_11 = $.sibling(node_10, 2);
					{
						let $0 = $.derived(() => t("probe.way"));
						Segmented(node_11, {
							get options() {
								return $.get(ways);
							},
							get label() {
								return $.get($0);
							},
							get value() {
								return $.get(way);
							},
							set value($$value) {
								$.set(way, $$value, true);
							}
						});
					}
					$.reset(div_4);
					$.append($$anchor, div_4);
				};
				$.if(node_9, ($$render) => {
					if ($.get(form) === "edge") $$render(consequent_3);
				});
				var node_12 = $.sibling(node_9, 2);
				Button(node_12, {
					kind: "primary",
					icon: "target",
					onclick: () => void measure(),
					"data-testid": "measure",
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_3 = $.text();
						$.template_effect(($0) => $.set_text(text_3, $0), [() => t("probe.prepare")]);
						$.append($$anchor, text_3);
					},
					$$slots: { default: true }
				});
				$.reset(div_2);
				$.append($$anchor, div_2);
			},
			$$slots: { default: true }
		});
	}
	var node_13 = $.sibling(node_1, 2);
	{
		let $0 = $.derived(() => t("probe.tool"));
		Card(node_13, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div_5 = root_5();
				var node_14 = $.child(div_5);
				{
					let $0 = $.derived(() => t("probe.tool"));
					Segmented(node_14, {
						get options() {
							return $.get(modes);
						},
						get label() {
							return $.get($0);
						},
						get value() {
							return $.get(mode);
						},
						set value($$value) {
							$.set(mode, $$value, true);
						}
					});
				}
				var div_6 = $.sibling(node_14, 2);
				var node_15 = $.child(div_6);
				var consequent_4 = ($$anchor) => {
					{
						let $0 = $.derived(() => t("settings.offset_number"));
						Labelled($$anchor, {
							get label() {
								return $.get($0);
							},
							children: ($$anchor, $$slotProps) => {
								{
									let $0 = $.derived(() => t("settings.offset_number"));
									NumberField($$anchor, {
										get value() {
											return $.get(h);
										},
										digits: 0,
										minimum: 1,
										maximum: 256,
										unit: "H",
										get label() {
											return $.get($0);
										},
										onvalue: (value) => $.set(h, value ?? 1, true)
									});
								}
							},
							$$slots: { default: true }
						});
					}
				};
				$.if(node_15, ($$render) => {
					if ($.get(mode) !== "diameter") $$render(consequent_4);
				});
				var node_16 = $.sibling(node_15, 2);
				var consequent_5 = ($$anchor) => {
					{
						let $0 = $.derived(() => t("settings.offset_number"));
						Labelled($$anchor, {
							get label() {
								return $.get($0);
							},
							children: ($$anchor, $$slotProps) => {
								{
									let $0 = $.derived(() => t("settings.offset_number"));
									NumberField($$anchor, {
										get value() {
											return $.get(d);
										},
										digits: 0,
										minimum: 1,
										maximum: 256,
										unit: "D",
										get label() {
											return $.get($0);
										},
										onvalue: (value) => $.set(d, value ?? 1, true)
									});
								}
							},
							$$slots: { default: true }
						});
					}
				};
				$.if(node_16, ($$render) => {
					if ($.get(mode) !== "length") $$render(consequent_5);
				});
				var node_17 = $.sibling(node_16, 2);
				{
					let $0 = $.derived(() => t("probe.length"));
					measured(node_17, () => $.get($0), () => $.get(length), () => (value) => $.set(length, value, true), () => true);
				}
				var node_18 = $.sibling(node_17, 2);
				{
					let $0 = $.derived(() => t("probe.diameter"));
					measured(node_18, () => $.get($0), () => $.get(width), () => (value) => $.set(width, value, true), () => true);
				}
				$.reset(div_6);
				var p = $.sibling(div_6, 2);
				var text_4 = $.only_child(p, true);
				var node_19 = $.sibling(p, 2);
				Button(node_19, {
					kind: "primary",
					icon: "tool",
					onclick: () => void measureTool(),
					"data-testid": "measure-tool",
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_5 = $.text();
						$.template_effect(($0) => $.set_text(text_5, $0), [() => t("probe.prepare")]);
						$.append($$anchor, text_5);
					},
					$$slots: { default: true }
				});
				$.reset(div_5);
				$.template_effect(($0) => $.set_text(text_4, $0), [() => t("probe.tool_hint")]);
				$.append($$anchor, div_5);
			},
			$$slots: { default: true }
		});
	}
	var node_20 = $.sibling(node_13, 2);
	{
		let $0 = $.derived(() => t("probe.last"));
		Card(node_20, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var fragment_14 = $.comment();
				var node_21 = $.first_child(fragment_14);
				var consequent_7 = ($$anchor) => {
					var div_7 = root_8();
					var node_22 = $.child(div_7);
					$.each(node_22, 17, () => Object.entries($.get(last).place), ([name, place]) => name, ($$anchor, $$item) => {
						var $$array = $.derived(() => $.to_array($.get($$item), 2));
						let name = () => $.get($$array)[0];
						let place = () => $.get($$array)[1];
						var strong = root_6();
						var text_6 = $.only_child(strong);
						$.template_effect(($0) => $.set_text(text_6, `${name() ?? ""} ${$0 ?? ""}`), [() => fixed(place())]);
						$.append($$anchor, strong);
					});
					var p_1 = $.sibling(node_22, 2);
					var text_7 = $.only_child(p_1);
					var node_23 = $.sibling(p_1, 2);
					var consequent_6 = ($$anchor) => {
						var p_2 = root_7();
						var text_8 = $.only_child(p_2, true);
						$.template_effect(($0) => $.set_text(text_8, $0), [() => t("probe.stored", { what: $.get(last).stored.join(", ") })]);
						$.append($$anchor, p_2);
					};
					$.if(node_23, ($$render) => {
						if ($.get(last).stored.length) $$render(consequent_6);
					});
					$.reset(div_7);
					$.template_effect(($0, $1) => $.set_text(text_7, `${$0 ?? ""} ${$1 ?? ""}`), [() => $.get(last).sizes.map((size) => fixed(size)).join(" × "), () => t("unit.mm")]);
					$.append($$anchor, div_7);
				};
				var alternate_1 = ($$anchor) => {
					var p_3 = root_9();
					var text_9 = $.only_child(p_3, true);
					$.template_effect(($0) => $.set_text(text_9, $0), [() => t("probe.nothing")]);
					$.append($$anchor, p_3);
				};
				$.if(node_21, ($$render) => {
					if ($.get(last)) $$render(consequent_7);
					else $$render(alternate_1, -1);
				});
				$.append($$anchor, fragment_14);
			},
			$$slots: { default: true }
		});
	}
	$.reset(div_1);
	$.template_effect(($0) => {
		classes = $.set_class(div, 1, "state row wrap s-r7wnwv", null, classes, { ready: $.get(ready) });
		$.set_attribute(div, "data-ready", $.get(ready));
		$.set_text(text, $0);
	}, [() => $.get(ready) ? t("probe.ready") : t("probe.hint")]);
	$.append($$anchor, fragment_2);
	$.pop();
}
export { Probe as default };
