import { t } from "../../lib/i18n/index.svelte.js";
import { behindLetter, fixed } from "../../lib/numbers.js";
import { SYSTEMS } from "../../lib/measuring.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Labelled from "../../lib/parts/Labelled.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/settings/Probe.svelte
var measured = ($$anchor, label = $.noop, value = $.noop, onvalue = $.noop, $$arg3, $$arg4, $$arg5) => {
	let empty = $.derived_safe_equal(() => $.fallback($$arg3?.(), false));
	let unit = $.derived_safe_equal(() => $.fallback($$arg4?.(), () => t("unit.mm"), true));
	let limits = $.derived_safe_equal(() => $.fallback($$arg5?.(), () => ({}), true));
	Labelled($$anchor, {
		get label() {
			return label();
		},
		children: ($$anchor, $$slotProps) => {
			NumberField($$anchor, $.spread_props({
				get value() {
					return value();
				},
				get empty() {
					return $.get(empty);
				},
				get unit() {
					return $.get(unit);
				},
				get label() {
					return label();
				},
				get onvalue() {
					return onvalue();
				}
			}, () => $.get(limits)));
		},
		$$slots: { default: true }
	});
};
var root = $.from_html(`<div class="fields s-1b2hs9"><!> <!> <!> <!></div>`);
var root_1 = $.from_html(`<!> <!>`, 1);
var root_2 = $.from_html(`<option> </option>`);
var root_3 = $.from_html(`<select></select>`);
var root_4 = $.from_html(`<div class="row wrap"><!> <!></div>`);
var root_5 = $.from_html(`<div class="form s-1b2hs9"><!> <div class="fields s-1b2hs9"><!> <!> <!> <!></div> <!> <details class="s-1b2hs9"><summary data-testid="more-work" class="s-1b2hs9"> </summary> <div class="fields s-1b2hs9"><!> <!> <!> <!> <!> <!> <!></div> <!></details> <!></div>`);
var root_6 = $.from_html(`<div class="form s-1b2hs9"><!> <div class="fields s-1b2hs9"><!> <!> <!> <!></div> <p class="muted"> </p> <details class="s-1b2hs9"><summary data-testid="more-tool" class="s-1b2hs9"> </summary> <div class="fields s-1b2hs9"><!> <!> <!> <!> <!> <!> <!></div> <!></details> <!></div>`);
var root_7 = $.from_html(`<strong> </strong>`);
var root_8 = $.from_html(`<p class="s-1b2hs9"> </p>`);
var root_9 = $.from_html(`<div class="result number s-1b2hs9" data-testid="measured"><!> <p class="muted s-1b2hs9"> </p> <!></div>`);
var root_10 = $.from_html(`<p class="muted"> </p>`);
var root_11 = $.from_html(`<div data-testid="probe"><span class="grow" role="status"> </span> <!></div> <div class="probe s-1b2hs9"><!> <!> <!></div>`, 1);
function Probe($$anchor, $$props) {
	$.push($$props, true);
	const speeds = ($$anchor) => {
		var div = root();
		var node = $.child(div);
		{
			let $0 = $.derived(() => t("probe.pace_way"));
			let $1 = $.derived(() => t("unit.mm_min"));
			measured(node, () => $.get($0), () => pace.way, () => (value) => pace.way = value, () => true, () => $.get($1));
		}
		var node_1 = $.sibling(node, 2);
		{
			let $0 = $.derived(() => t("probe.pace_search"));
			let $1 = $.derived(() => t("unit.mm_min"));
			measured(node_1, () => $.get($0), () => pace.search, () => (value) => pace.search = value, () => true, () => $.get($1));
		}
		var node_2 = $.sibling(node_1, 2);
		{
			let $0 = $.derived(() => t("probe.pace_fine"));
			let $1 = $.derived(() => t("unit.mm_min"));
			measured(node_2, () => $.get($0), () => pace.fine, () => (value) => pace.fine = value, () => true, () => $.get($1));
		}
		var node_3 = $.sibling(node_2, 2);
		{
			let $0 = $.derived(() => t("probe.pace_back_off"));
			measured(node_3, () => $.get($0), () => pace.back_off, () => (value) => pace.back_off = value, () => true);
		}
		$.reset(div);
		$.append($$anchor, div);
	};
	const FORMS = [
		"hole",
		"boss",
		"slot",
		"web",
		"vector_hole",
		"vector_boss",
		"vector_slot",
		"vector_web",
		"edge"
	];
	const MODES = [
		"length",
		"diameter",
		"both",
		"calibrate_length",
		"calibrate_diameter"
	];
	const NUMBER = {
		minimum: 1,
		maximum: 256,
		whole: true
	};
	const TOLERANCE = { minimum: 0 };
	let form = $.state("hole");
	let diameter = $.state(40);
	let lx = $.state(60);
	let ly = $.state(40);
	let span = $.state(40);
	let angle = $.state(0);
	let angles = $.proxy([
		0,
		120,
		240
	]);
	let axis = $.state("X");
	let way = $.state("positive");
	let distance = $.state(10);
	let system = $.state("G54");
	let mode = $.state("length");
	let h = $.state(1);
	let d = $.state(1);
	let length = $.state(null);
	let width = $.state(null);
	const work = $.proxy({
		x: null,
		y: null,
		z: null,
		h: null,
		tolerance: null,
		clearance: null,
		overtravel: null,
		probe: null
	});
	const values = $.proxy({});
	const setter = $.proxy({
		depth: null,
		overtravel: null,
		tolerance: null,
		mark: null,
		adjust: null,
		stylus: null,
		rpm: null
	});
	const pace = $.proxy({
		way: null,
		search: null,
		fine: null,
		back_off: null
	});
	let last = $.state(null);
	const forms = $.derived(() => FORMS.map((value) => ({
		value,
		label: t(`probe.${value}`)
	})));
	const modes = $.derived(() => MODES.map((value) => ({
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
			case "vector_hole":
			case "vector_boss": return {
				form: $.get(form),
				diameter: $.get(diameter),
				angles: [...angles]
			};
			case "vector_slot":
			case "vector_web": return {
				form: $.get(form),
				width: $.get(span),
				angle: $.get(angle)
			};
			case "edge": return {
				form: $.get(form),
				axis: $.get(axis),
				positive: $.get(way) === "positive",
				distance: $.get(distance)
			};
		}
	}
	/** A place behind its letter is counted from where the probe stands: `Z-5`, or `X` for the place itself (3.4.3.1, input
	format 3). */
	const counted = (letter, put) => ({ meant: (text) => {
		const more = behindLetter(text, letter);
		const at = machine.status?.position.work[letter];
		return more === null || at === void 0 ? null : () => put(Math.round((at + more) * 1e4) / 1e4);
	} });
	const calibrates = $.derived(() => $.get(mode) === "calibrate_length" || $.get(mode) === "calibrate_diameter");
	const given = () => Object.fromEntries(Object.entries(values).filter((one) => one[1] !== null));
	const measure = () => machine.tell({
		do: "measure",
		...wanted(),
		...work,
		system: $.get(system),
		values: given(),
		pace: { ...pace }
	});
	const measureTool = () => machine.tell({
		do: "measure_tool",
		mode: $.get(mode),
		length: $.get(length),
		diameter: $.get(width),
		...setter,
		pace: { ...pace },
		h: $.get(calibrates) || $.get(mode) === "diameter" ? 0 : $.get(h),
		d: $.get(calibrates) || $.get(mode) === "length" ? 0 : $.get(d)
	});
	var fragment_2 = root_11();
	var div_1 = $.first_child(fragment_2);
	let classes;
	var span_1 = $.child(div_1);
	var text_1 = $.only_child(span_1, true);
	var node_4 = $.sibling(span_1, 2);
	var consequent = ($$anchor) => {
		Button($$anchor, {
			icon: "close",
			onclick: () => void machine.tell({ do: "cancel_measure" }),
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_2 = $.text();
				$.template_effect(($0) => $.set_text(text_2, $0), [() => t("app.cancel")]);
				$.append($$anchor, text_2);
			},
			$$slots: { default: true }
		});
	};
	$.if(node_4, ($$render) => {
		if ($.get(ready)) $$render(consequent);
	});
	$.reset(div_1);
	var div_2 = $.sibling(div_1, 2);
	var node_5 = $.child(div_2);
	{
		let $0 = $.derived(() => t("probe.work"));
		Card(node_5, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div_3 = root_5();
				var node_6 = $.child(div_3);
				{
					let $0 = $.derived(() => t("probe.work"));
					Segmented(node_6, {
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
				var div_4 = $.sibling(node_6, 2);
				var node_7 = $.child(div_4);
				var consequent_2 = ($$anchor) => {
					var fragment_5 = root_1();
					var node_8 = $.first_child(fragment_5);
					{
						let $0 = $.derived(() => t("probe.diameter"));
						measured(node_8, () => $.get($0), () => $.get(diameter), () => (value) => $.set(diameter, value ?? $.get(diameter), true));
					}
					var node_9 = $.sibling(node_8, 2);
					var consequent_1 = ($$anchor) => {
						var fragment_6 = $.comment();
						var node_10 = $.first_child(fragment_6);
						$.each(node_10, 17, () => angles, $.index, ($$anchor, one, index) => {
							{
								let $0 = $.derived(() => t("probe.angle_of", { n: index + 1 }));
								let $1 = $.derived(() => t("unit.deg"));
								measured($$anchor, () => $.get($0), () => $.get(one), () => (value) => angles[index] = value ?? $.get(one), () => false, () => $.get($1));
							}
						});
						$.append($$anchor, fragment_6);
					};
					$.if(node_9, ($$render) => {
						if ($.get(form) === "vector_hole" || $.get(form) === "vector_boss") $$render(consequent_1);
					});
					$.append($$anchor, fragment_5);
				};
				var consequent_3 = ($$anchor) => {
					var fragment_8 = root_1();
					var node_11 = $.first_child(fragment_8);
					{
						let $0 = $.derived(() => t("probe.width"));
						measured(node_11, () => $.get($0), () => $.get(span), () => (value) => $.set(span, value ?? $.get(span), true));
					}
					var node_12 = $.sibling(node_11, 2);
					{
						let $0 = $.derived(() => t("probe.angle"));
						let $1 = $.derived(() => t("unit.deg"));
						measured(node_12, () => $.get($0), () => $.get(angle), () => (value) => $.set(angle, value ?? $.get(angle), true), () => false, () => $.get($1));
					}
					$.append($$anchor, fragment_8);
				};
				var consequent_4 = ($$anchor) => {
					var fragment_9 = root_1();
					var node_13 = $.first_child(fragment_9);
					{
						let $0 = $.derived(() => t("probe.along", { axis: "X" }));
						measured(node_13, () => $.get($0), () => $.get(lx), () => (value) => $.set(lx, value, true), () => true);
					}
					var node_14 = $.sibling(node_13, 2);
					{
						let $0 = $.derived(() => t("probe.along", { axis: "Y" }));
						measured(node_14, () => $.get($0), () => $.get(ly), () => (value) => $.set(ly, value, true), () => true);
					}
					$.append($$anchor, fragment_9);
				};
				var alternate = ($$anchor) => {
					{
						let $0 = $.derived(() => t("probe.distance"));
						measured($$anchor, () => $.get($0), () => $.get(distance), () => (value) => $.set(distance, value ?? $.get(distance), true));
					}
				};
				$.if(node_7, ($$render) => {
					if ($.get(form) === "hole" || $.get(form) === "boss" || $.get(form) === "vector_hole" || $.get(form) === "vector_boss") $$render(consequent_2);
					else if ($.get(form) === "vector_slot" || $.get(form) === "vector_web") $$render(consequent_3, 1);
					else if ($.get(form) === "slot" || $.get(form) === "web") $$render(consequent_4, 2);
					else $$render(alternate, -1);
				});
				var node_15 = $.sibling(node_7, 2);
				{
					let $0 = $.derived(() => t("probe.height"));
					let $1 = $.derived(() => t("unit.mm"));
					let $2 = $.derived(() => counted("Z", (value) => work.z = value));
					measured(node_15, () => $.get($0), () => work.z, () => (value) => work.z = value, () => true, () => $.get($1), () => $.get($2));
				}
				var node_16 = $.sibling(node_15, 2);
				{
					let $0 = $.derived(() => t("probe.tolerance"));
					let $1 = $.derived(() => t("unit.mm"));
					measured(node_16, () => $.get($0), () => work.tolerance, () => (value) => work.tolerance = value, () => true, () => $.get($1), () => TOLERANCE);
				}
				var node_17 = $.sibling(node_16, 2);
				{
					let $0 = $.derived(() => t("settings.system"));
					Labelled(node_17, {
						get label() {
							return $.get($0);
						},
						children: ($$anchor, $$slotProps) => {
							var select = root_3();
							$.each(select, 20, () => SYSTEMS, (one) => one, ($$anchor, one) => {
								var option = root_2();
								var text_3 = $.only_child(option, true);
								var option_value = {};
								$.template_effect(() => {
									$.set_text(text_3, one);
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
				$.reset(div_4);
				var node_18 = $.sibling(div_4, 2);
				var consequent_5 = ($$anchor) => {
					var div_5 = root_4();
					var node_19 = $.child(div_5);
					{
						let $0 = $.derived(() => t("panel.axes"));
						Segmented(node_19, {
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
					var node_20 = $.sibling(node_19, 2);
					{
						let $0 = $.derived(() => t("probe.way"));
						Segmented(node_20, {
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
					$.reset(div_5);
					$.append($$anchor, div_5);
				};
				$.if(node_18, ($$render) => {
					if ($.get(form) === "edge") $$render(consequent_5);
				});
				var details = $.sibling(node_18, 2);
				var summary = $.child(details);
				var text_4 = $.only_child(summary, true);
				var div_6 = $.sibling(summary, 2);
				var node_21 = $.child(div_6);
				{
					let $0 = $.derived(() => t("probe.centre", { axis: "X" }));
					let $1 = $.derived(() => t("unit.mm"));
					let $2 = $.derived(() => counted("X", (value) => work.x = value));
					measured(node_21, () => $.get($0), () => work.x, () => (value) => work.x = value, () => true, () => $.get($1), () => $.get($2));
				}
				var node_22 = $.sibling(node_21, 2);
				{
					let $0 = $.derived(() => t("probe.centre", { axis: "Y" }));
					let $1 = $.derived(() => t("unit.mm"));
					let $2 = $.derived(() => counted("Y", (value) => work.y = value));
					measured(node_22, () => $.get($0), () => work.y, () => (value) => work.y = value, () => true, () => $.get($1), () => $.get($2));
				}
				var node_23 = $.sibling(node_22, 2);
				$.each(node_23, 16, () => $.get(form) === "edge" ? [$.get(axis)] : ["X", "Y"], (one) => one, ($$anchor, one) => {
					{
						let $0 = $.derived(() => t("probe.value", { axis: one }));
						measured($$anchor, () => $.get($0), () => values[one] ?? null, () => (value) => values[one] = value, () => true);
					}
				});
				var node_24 = $.sibling(node_23, 2);
				{
					let $0 = $.derived(() => t("probe.clearance"));
					measured(node_24, () => $.get($0), () => work.clearance, () => (value) => work.clearance = value, () => true);
				}
				var node_25 = $.sibling(node_24, 2);
				{
					let $0 = $.derived(() => t("probe.overtravel"));
					measured(node_25, () => $.get($0), () => work.overtravel, () => (value) => work.overtravel = value, () => true);
				}
				var node_26 = $.sibling(node_25, 2);
				{
					let $0 = $.derived(() => t("probe.ball"));
					measured(node_26, () => $.get($0), () => work.probe, () => (value) => work.probe = value, () => true);
				}
				var node_27 = $.sibling(node_26, 2);
				var consequent_6 = ($$anchor) => {
					{
						let $0 = $.derived(() => t("probe.probe_length"));
						measured($$anchor, () => $.get($0), () => work.h, () => (value) => work.h = value, () => true, () => "H", () => NUMBER);
					}
				};
				$.if(node_27, ($$render) => {
					if ($.get(form) === "edge" && $.get(axis) === "Z") $$render(consequent_6);
				});
				$.reset(div_6);
				var node_28 = $.sibling(div_6, 2);
				speeds(node_28);
				$.reset(details);
				var node_29 = $.sibling(details, 2);
				Button(node_29, {
					kind: "primary",
					icon: "target",
					onclick: () => void measure(),
					"data-testid": "measure",
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_5 = $.text();
						$.template_effect(($0) => $.set_text(text_5, $0), [() => t("probe.prepare")]);
						$.append($$anchor, text_5);
					},
					$$slots: { default: true }
				});
				$.reset(div_3);
				$.template_effect(($0) => $.set_text(text_4, $0), [() => t("probe.more")]);
				$.append($$anchor, div_3);
			},
			$$slots: { default: true }
		});
	}
	var node_30 = $.sibling(node_5, 2);
	{
		let $0 = $.derived(() => t("probe.tool"));
		Card(node_30, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div_7 = root_6();
				var node_31 = $.child(div_7);
				{
					let $0 = $.derived(() => t("probe.tool"));
					Segmented(node_31, {
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
				var div_8 = $.sibling(node_31, 2);
				var node_32 = $.child(div_8);
				var consequent_7 = ($$anchor) => {
					{
						let $0 = $.derived(() => t("settings.offset_number"));
						Labelled($$anchor, {
							get label() {
								return $.get($0);
							},
							children: ($$anchor, $$slotProps) => {
								{
									let $0 = $.derived(() => t("settings.offset_number"));
									NumberField($$anchor, $.spread_props({ get value() {
										return $.get(h);
									} }, () => NUMBER, {
										unit: "H",
										get label() {
											return $.get($0);
										},
										onvalue: (value) => $.set(h, value ?? 1, true)
									}));
								}
							},
							$$slots: { default: true }
						});
					}
				};
				$.if(node_32, ($$render) => {
					if ($.get(mode) === "length" || $.get(mode) === "both") $$render(consequent_7);
				});
				var node_33 = $.sibling(node_32, 2);
				var consequent_8 = ($$anchor) => {
					{
						let $0 = $.derived(() => t("settings.offset_number"));
						Labelled($$anchor, {
							get label() {
								return $.get($0);
							},
							children: ($$anchor, $$slotProps) => {
								{
									let $0 = $.derived(() => t("settings.offset_number"));
									NumberField($$anchor, $.spread_props({ get value() {
										return $.get(d);
									} }, () => NUMBER, {
										unit: "D",
										get label() {
											return $.get($0);
										},
										onvalue: (value) => $.set(d, value ?? 1, true)
									}));
								}
							},
							$$slots: { default: true }
						});
					}
				};
				$.if(node_33, ($$render) => {
					if ($.get(mode) === "diameter" || $.get(mode) === "both") $$render(consequent_8);
				});
				var node_34 = $.sibling(node_33, 2);
				{
					let $0 = $.derived(() => $.get(calibrates) ? t("probe.known_length") : t("probe.length"));
					measured(node_34, () => $.get($0), () => $.get(length), () => (value) => $.set(length, value, true), () => true);
				}
				var node_35 = $.sibling(node_34, 2);
				{
					let $0 = $.derived(() => t("probe.diameter"));
					measured(node_35, () => $.get($0), () => $.get(width), () => (value) => $.set(width, value, true), () => true);
				}
				$.reset(div_8);
				var p = $.sibling(div_8, 2);
				var text_6 = $.only_child(p, true);
				var details_1 = $.sibling(p, 2);
				var summary_1 = $.child(details_1);
				var text_7 = $.only_child(summary_1, true);
				var div_9 = $.sibling(summary_1, 2);
				var node_36 = $.child(div_9);
				{
					let $0 = $.derived(() => t("probe.tolerance"));
					let $1 = $.derived(() => t("unit.mm"));
					measured(node_36, () => $.get($0), () => setter.tolerance, () => (value) => setter.tolerance = value, () => true, () => $.get($1), () => TOLERANCE);
				}
				var node_37 = $.sibling(node_36, 2);
				{
					let $0 = $.derived(() => t("probe.mark"));
					measured(node_37, () => $.get($0), () => setter.mark, () => (value) => setter.mark = value, () => true, () => "H", () => NUMBER);
				}
				var node_38 = $.sibling(node_37, 2);
				{
					let $0 = $.derived(() => t("probe.adjust"));
					measured(node_38, () => $.get($0), () => setter.adjust, () => (value) => setter.adjust = value, () => true);
				}
				var node_39 = $.sibling(node_38, 2);
				{
					let $0 = $.derived(() => t("probe.rpm"));
					let $1 = $.derived(() => t("unit.rpm"));
					measured(node_39, () => $.get($0), () => setter.rpm, () => (value) => setter.rpm = value, () => true, () => $.get($1), () => ({
						whole: true,
						minimum: 0
					}));
				}
				var node_40 = $.sibling(node_39, 2);
				{
					let $0 = $.derived(() => t("probe.depth"));
					measured(node_40, () => $.get($0), () => setter.depth, () => (value) => setter.depth = value, () => true);
				}
				var node_41 = $.sibling(node_40, 2);
				{
					let $0 = $.derived(() => t("probe.overtravel"));
					measured(node_41, () => $.get($0), () => setter.overtravel, () => (value) => setter.overtravel = value, () => true);
				}
				var node_42 = $.sibling(node_41, 2);
				{
					let $0 = $.derived(() => t("probe.stylus"));
					measured(node_42, () => $.get($0), () => setter.stylus, () => (value) => setter.stylus = value, () => true);
				}
				$.reset(div_9);
				var node_43 = $.sibling(div_9, 2);
				speeds(node_43);
				$.reset(details_1);
				var node_44 = $.sibling(details_1, 2);
				Button(node_44, {
					kind: "primary",
					icon: "tool",
					onclick: () => void measureTool(),
					"data-testid": "measure-tool",
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_8 = $.text();
						$.template_effect(($0) => $.set_text(text_8, $0), [() => t("probe.prepare")]);
						$.append($$anchor, text_8);
					},
					$$slots: { default: true }
				});
				$.reset(div_7);
				$.template_effect(($0, $1) => {
					$.set_text(text_6, $0);
					$.set_text(text_7, $1);
				}, [() => t($.get(mode) === "calibrate_length" ? "probe.calibrate_hint" : "probe.tool_hint"), () => t("probe.more")]);
				$.append($$anchor, div_7);
			},
			$$slots: { default: true }
		});
	}
	var node_45 = $.sibling(node_30, 2);
	{
		let $0 = $.derived(() => t("probe.last"));
		Card(node_45, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var fragment_19 = $.comment();
				var node_46 = $.first_child(fragment_19);
				var consequent_10 = ($$anchor) => {
					var div_10 = root_9();
					var node_47 = $.child(div_10);
					$.each(node_47, 17, () => Object.entries($.get(last).place), ([name, place]) => name, ($$anchor, $$item) => {
						var $$array = $.derived(() => $.to_array($.get($$item), 2));
						let name = () => $.get($$array)[0];
						let place = () => $.get($$array)[1];
						var strong = root_7();
						var text_9 = $.only_child(strong);
						$.template_effect(($0) => $.set_text(text_9, `${name() ?? ""} ${$0 ?? ""}`), [() => fixed(place())]);
						$.append($$anchor, strong);
					});
					var p_1 = $.sibling(node_47, 2);
					var text_10 = $.only_child(p_1);
					var node_48 = $.sibling(p_1, 2);
					var consequent_9 = ($$anchor) => {
						var p_2 = root_8();
						var text_11 = $.only_child(p_2, true);
						$.template_effect(($0) => $.set_text(text_11, $0), [() => t("probe.stored", { what: $.get(last).stored.join(", ") })]);
						$.append($$anchor, p_2);
					};
					$.if(node_48, ($$render) => {
						if ($.get(last).stored.length) $$render(consequent_9);
					});
					$.reset(div_10);
					$.template_effect(($0, $1) => $.set_text(text_10, `${$0 ?? ""} ${$1 ?? ""}`), [() => $.get(last).sizes.map((size) => fixed(size)).join(" × "), () => t("unit.mm")]);
					$.append($$anchor, div_10);
				};
				var alternate_1 = ($$anchor) => {
					var p_3 = root_10();
					var text_12 = $.only_child(p_3, true);
					$.template_effect(($0) => $.set_text(text_12, $0), [() => t("probe.nothing")]);
					$.append($$anchor, p_3);
				};
				$.if(node_46, ($$render) => {
					if ($.get(last)) $$render(consequent_10);
					else $$render(alternate_1, -1);
				});
				$.append($$anchor, fragment_19);
			},
			$$slots: { default: true }
		});
	}
	$.reset(div_2);
	$.template_effect(($0) => {
		classes = $.set_class(div_1, 1, "state row wrap s-1b2hs9", null, classes, { ready: $.get(ready) });
		$.set_attribute(div_1, "data-ready", $.get(ready));
		$.set_text(text_1, $0);
	}, [() => $.get(ready) ? t("probe.ready") : t("probe.hint")]);
	$.append($$anchor, fragment_2);
	$.pop();
}
export { Probe as default };
