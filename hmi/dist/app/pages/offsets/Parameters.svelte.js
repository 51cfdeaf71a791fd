import { http } from "../../lib/api/http.js";
import { language, number, t } from "../../lib/i18n/index.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import ParameterSwitch from "../../lib/parts/ParameterSwitch.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import { asNumberedBit, numberedBit } from "./bits.js";
import { route } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/offsets/Parameters.svelte
var root = $.from_html(`<input type="search" data-testid="parameter-search"/> <!> <!> <!>`, 1);
var root_1 = $.from_html(`<i> </i>`);
var root_2 = $.from_html(`<span class="code bits s-1cvhlgy"></span> <span class="meaning muted s-1cvhlgy"> </span>`, 1);
var root_3 = $.from_html(`<span class="number value s-1cvhlgy"> <small class="s-1cvhlgy"> </small></span> <span class="meaning s-1cvhlgy"> </span>`, 1);
var root_4 = $.from_html(`<button type="button" role="option"><span class="code name s-1cvhlgy"> </span> <!></button>`);
var root_5 = $.from_html(`<p class="muted none s-1cvhlgy"> </p>`);
var root_6 = $.from_html(`<div class="list scroll s-1cvhlgy" role="listbox"></div>`);
var root_7 = $.from_html(`<span class="muted"> </span>`);
var root_8 = $.from_html(`<p> </p> <!> <dl class="s-1cvhlgy"><dt class="s-1cvhlgy"> </dt><dd class="number s-1cvhlgy"> </dd> <dt class="s-1cvhlgy"> </dt><dd class="number s-1cvhlgy"> </dd> <dt class="s-1cvhlgy"> </dt><dd class="s-1cvhlgy"> </dd></dl> <!>`, 1);
var root_9 = $.from_html(`<small class="standard s-1cvhlgy"> </small>`);
var root_10 = $.from_html(`<p class="unused s-1cvhlgy"> </p>`);
var root_11 = $.from_html(`<li class="s-1cvhlgy"><button type="button" class="bit code s-1cvhlgy" role="switch"> </button> <div><strong class="code"> </strong><!> <p class="s-1cvhlgy"> </p> <!> <!></div></li>`);
var root_12 = $.from_html(`<ul class="s-1cvhlgy"></ul>`);
var root_13 = $.from_html(`<p class="muted"> </p>`);
var root_14 = $.from_html(`<p class="need"> </p>`);
var root_15 = $.from_html(`<div class="detail stack scroll" data-testid="parameter"><h2 class="code"> <!></h2> <!> <!> <!> <!> <!></div>`);
var root_16 = $.from_html(`<p class="muted count s-1cvhlgy"> </p>`);
var root_17 = $.from_html(`<div class="parameters s-1cvhlgy"><!> <!></div> <!>`, 1);
function Parameters($$anchor, $$props) {
	$.push($$props, true);
	let all = $.state([]);
	let loaded = $.state(false);
	let values = $.state({});
	let given = $.state(/* @__PURE__ */ new Set());
	let left = $.state(/* @__PURE__ */ new Set());
	let kind = $.state("all");
	let sought = $.state("");
	let changedOnly = $.state(false);
	let chosen = $.state(null);
	const level = $.derived(() => machine.level);
	$.user_effect(() => {
		http.parameters(language()).then((now) => {
			$.set(all, now);
			$.set(loaded, true);
		}, (failed) => machine.refused(failed));
	});
	$.user_effect(() => {
		machine.changed("parameters");
		if (machine.link !== "open") return;
		machine.fetch("parameters", {
			do: "parameters",
			names: []
		}).then((reply) => {
			if (!reply) return;
			$.set(values, reply.parameters);
			$.set(given, new Set(reply.given));
			$.set(left, new Set(reply.left_to_file));
		});
	});
	$.user_effect(() => {
		if (route.item) $.set(sought, route.item, true);
	});
	const value = (name, standard) => $.get(values)[name] ?? standard;
	const differs = (one) => one.kind === "bit" ? one.bits.some((bit) => value(bit.name, bit.standard) !== bit.standard) : value(one.name, one.standard) !== one.standard;
	const text = (one) => `${one.name} ${one.number} ${one.symbol} ${one.meaning} ${one.bits.map((bit) => `${bit.name} ${numberedBit(one.number, bit.bit)} ${bit.symbol} ${bit.meaning}`).join(" ")}`.toLowerCase();
	const shown = $.derived(() => {
		const words = $.get(sought).toLowerCase().split(/\s+/).filter(Boolean).map(asNumberedBit);
		return $.get(all).filter((one) => ($.get(kind) === "all" || one.kind === $.get(kind)) && (!$.get(changedOnly) || differs(one)) && words.every((word) => text(one).includes(word)));
	});
	const current = $.derived(() => $.get(shown).find((one) => one.name === $.get(chosen)) ?? $.get(shown)[0]);
	const kinds = $.derived(() => [
		"all",
		"bit",
		"data"
	].map((one) => ({
		value: one,
		label: t(`offsets.kind_${one}`)
	})));
	const binary = (one) => [
		7,
		6,
		5,
		4,
		3,
		2,
		1,
		0
	].map((at) => {
		const bit = one.bits.find((each) => each.bit === at);
		return bit ? String(value(bit.name, bit.standard)) : "·";
	});
	function set(name, to) {
		machine.tell({
			do: "set_parameter",
			name,
			value: to
		});
	}
	var fragment = root_17();
	var div = $.first_child(fragment);
	var node = $.child(div);
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var input = $.first_child(fragment_1);
			$.remove_input_defaults(input);
			var node_1 = $.sibling(input, 2);
			{
				let $0 = $.derived(() => t("offsets.kind"));
				Segmented(node_1, {
					get options() {
						return $.get(kinds);
					},
					get label() {
						return $.get($0);
					},
					get value() {
						return $.get(kind);
					},
					set value($$value) {
						$.set(kind, $$value, true);
					}
				});
			}
			var node_2 = $.sibling(node_1, 2);
			Button(node_2, {
				get pressed() {
					return $.get(changedOnly);
				},
				onclick: () => $.set(changedOnly, !$.get(changedOnly)),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_1 = $.text();
					$.template_effect(($0) => $.set_text(text_1, $0), [() => t("offsets.changed_only")]);
					$.append($$anchor, text_1);
				},
				$$slots: { default: true }
			});
			var node_3 = $.sibling(node_2, 2);
			ParameterSwitch(node_3, {});
			$.template_effect(($0, $1) => {
				$.set_attribute(input, "placeholder", $0);
				$.set_attribute(input, "aria-label", $1);
			}, [() => t("app.search"), () => t("app.search")]);
			$.bind_value(input, () => $.get(sought), ($$value) => $.set(sought, $$value));
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("offsets.parameters"));
		Card(node, {
			fill: true,
			flush: true,
			get title() {
				return $.get($0);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var div_1 = root_6();
				$.each(div_1, 21, () => $.get(shown), (one) => one.name, ($$anchor, one) => {
					var button = root_4();
					let classes;
					var span = $.child(button);
					var text_2 = $.only_child(span, true);
					var node_4 = $.sibling(span, 2);
					var consequent = ($$anchor) => {
						var fragment_3 = root_2();
						var span_1 = $.first_child(fragment_3);
						$.each(span_1, 21, () => binary($.get(one)), $.index, ($$anchor, bit) => {
							var i = root_1();
							let classes_1;
							var text_3 = $.only_child(i, true);
							$.template_effect(() => {
								classes_1 = $.set_class(i, 1, "s-1cvhlgy", null, classes_1, { one: $.get(bit) === "1" });
								$.set_text(text_3, $.get(bit));
							});
							$.append($$anchor, i);
						});
						$.reset(span_1);
						var span_2 = $.sibling(span_1, 2);
						var text_4 = $.only_child(span_2, true);
						$.template_effect(($0) => $.set_text(text_4, $0), [() => $.get(one).bits.map((bit) => bit.symbol).filter(Boolean).join(" ")]);
						$.append($$anchor, fragment_3);
					};
					var alternate = ($$anchor) => {
						var fragment_4 = root_3();
						var span_3 = $.first_child(fragment_4);
						var text_5 = $.child(span_3, true);
						var small = $.sibling(text_5);
						var text_6 = $.only_child(small, true);
						$.reset(span_3);
						var span_4 = $.sibling(span_3, 2);
						var text_7 = $.only_child(span_4, true);
						$.template_effect(($0) => {
							$.set_text(text_5, $0);
							$.set_text(text_6, $.get(one).unit);
							$.set_text(text_7, $.get(one).meaning);
						}, [() => value($.get(one).name, $.get(one).standard)]);
						$.append($$anchor, fragment_4);
					};
					$.if(node_4, ($$render) => {
						if ($.get(one).kind === "bit") $$render(consequent);
						else $$render(alternate, -1);
					});
					$.reset(button);
					$.template_effect(($0) => {
						$.set_attribute(button, "aria-selected", $.get(one) === $.get(current));
						$.set_attribute(button, "data-parameter", $.get(one).name);
						classes = $.set_class(button, 1, "s-1cvhlgy", null, classes, { differs: $0 });
						$.set_text(text_2, $.get(one).name);
					}, [() => differs($.get(one))]);
					$.delegated("click", button, () => $.set(chosen, $.get(one).name, true));
					$.append($$anchor, button);
				}, ($$anchor) => {
					var p = root_5();
					var text_8 = $.only_child(p, true);
					$.template_effect(($0) => $.set_text(text_8, $0), [() => !$.get(loaded) ? t("app.loading") : $.get(all).length ? t("offsets.none") : t("offsets.no_parameters")]);
					$.append($$anchor, p);
				});
				$.reset(div_1);
				$.template_effect(($0) => $.set_attribute(div_1, "aria-label", $0), [() => t("offsets.parameters")]);
				$.append($$anchor, div_1);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var node_5 = $.sibling(node, 2);
	var consequent_12 = ($$anchor) => {
		var div_2 = root_15();
		var h2 = $.child(div_2);
		var text_9 = $.child(h2, true);
		var node_6 = $.sibling(text_9);
		var consequent_1 = ($$anchor) => {
			var span_5 = root_7();
			var text_10 = $.only_child(span_5, true);
			$.template_effect(() => $.set_text(text_10, $.get(current).symbol));
			$.append($$anchor, span_5);
		};
		$.if(node_6, ($$render) => {
			if ($.get(current).symbol) $$render(consequent_1);
		});
		$.reset(h2);
		var node_7 = $.sibling(h2, 2);
		var consequent_3 = ($$anchor) => {
			var fragment_5 = root_8();
			var p_1 = $.first_child(fragment_5);
			var text_11 = $.only_child(p_1, true);
			var node_8 = $.sibling(p_1, 2);
			{
				let $0 = $.derived(() => value($.get(current).name, $.get(current).standard));
				let $1 = $.derived(() => Number.isInteger(value($.get(current).name, $.get(current).standard)) ? 0 : 4);
				let $2 = $.derived(() => $.get(current).minimum ?? -Infinity);
				let $3 = $.derived(() => $.get(current).maximum ?? Infinity);
				NumberField(node_8, {
					get value() {
						return $.get($0);
					},
					get digits() {
						return $.get($1);
					},
					get label() {
						return $.get(current).name;
					},
					get unit() {
						return $.get(current).unit;
					},
					get minimum() {
						return $.get($2);
					},
					get maximum() {
						return $.get($3);
					},
					onvalue: (to) => set($.get(current).name, to)
				});
			}
			var dl = $.sibling(node_8, 2);
			var dt = $.child(dl);
			var text_12 = $.only_child(dt, true);
			var dd = $.sibling(dt);
			var text_13 = $.only_child(dd);
			var dt_1 = $.sibling(dd, 2);
			var text_14 = $.only_child(dt_1, true);
			var dd_1 = $.sibling(dt_1);
			var text_15 = $.only_child(dd_1, true);
			var dt_2 = $.sibling(dd_1, 2);
			var text_16 = $.only_child(dt_2, true);
			var dd_2 = $.sibling(dt_2);
			var text_17 = $.only_child(dd_2);
			$.reset(dl);
			var node_9 = $.sibling(dl, 2);
			var consequent_2 = ($$anchor) => {
				Button($$anchor, {
					icon: "undo",
					onclick: () => set($.get(current).name, null),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_18 = $.text();
						$.template_effect(($0) => $.set_text(text_18, $0), [() => t("offsets.to_standard")]);
						$.append($$anchor, text_18);
					},
					$$slots: { default: true }
				});
			};
			var d = $.derived(() => $.get(given).has($.get(current).name) || value($.get(current).name, $.get(current).standard) !== $.get(current).standard);
			$.if(node_9, ($$render) => {
				if ($.get(d)) $$render(consequent_2);
			});
			$.template_effect(($0, $1, $2, $3) => {
				$.set_text(text_11, $.get(current).meaning);
				$.set_text(text_12, $0);
				$.set_text(text_13, `${$.get(current).minimum ?? "–" ?? ""} … ${$.get(current).maximum ?? "–" ?? ""} ${$.get(current).unit ?? ""}`);
				$.set_text(text_14, $1);
				$.set_text(text_15, $.get(current).standard);
				$.set_text(text_16, $2);
				$.set_text(text_17, `${$.get(current).level ?? ""} · ${$3 ?? ""}`);
			}, [
				() => t("offsets.range"),
				() => t("offsets.standard"),
				() => t("offsets.right"),
				() => t(`rights.level_${$.get(current).level}`)
			]);
			$.append($$anchor, fragment_5);
		};
		var alternate_1 = ($$anchor) => {
			var ul = root_12();
			$.each(ul, 21, () => [...$.get(current).bits].reverse(), (bit) => bit.bit, ($$anchor, bit) => {
				const on = $.derived(() => value($.get(bit).name, $.get(bit).standard) === 1);
				var li = root_11();
				var button_1 = $.child(li);
				var text_19 = $.only_child(button_1, true);
				var div_3 = $.sibling(button_1, 2);
				var strong = $.child(div_3);
				var text_20 = $.only_child(strong);
				var node_10 = $.sibling(strong);
				var consequent_4 = ($$anchor) => {
					var small_1 = root_9();
					var text_21 = $.only_child(small_1);
					$.template_effect(($0) => $.set_text(text_21, `${$0 ?? ""} ${$.get(bit).standard ?? ""}`), [() => t("offsets.standard")]);
					$.append($$anchor, small_1);
				};
				var d_1 = $.derived(() => value($.get(bit).name, $.get(bit).standard) !== $.get(bit).standard);
				$.if(node_10, ($$render) => {
					if ($.get(d_1)) $$render(consequent_4);
				});
				var p_2 = $.sibling(node_10, 2);
				var text_22 = $.only_child(p_2, true);
				var node_11 = $.sibling(p_2, 2);
				var consequent_5 = ($$anchor) => {
					var p_3 = root_10();
					var text_23 = $.only_child(p_3, true);
					$.template_effect(($0) => $.set_text(text_23, $0), [() => t("offsets.unused")]);
					$.append($$anchor, p_3);
				};
				$.if(node_11, ($$render) => {
					if (!$.get(bit).used) $$render(consequent_5);
				});
				var node_12 = $.sibling(node_11, 2);
				var consequent_6 = ($$anchor) => {
					var p_4 = root_10();
					var text_24 = $.only_child(p_4, true);
					$.template_effect(($0) => $.set_text(text_24, $0), [() => t("offsets.left_to_file")]);
					$.append($$anchor, p_4);
				};
				var d_2 = $.derived(() => $.get(left).has($.get(bit).name));
				$.if(node_12, ($$render) => {
					if ($.get(d_2)) $$render(consequent_6);
				});
				$.reset(div_3);
				$.reset(li);
				$.template_effect(() => {
					$.set_attribute(button_1, "aria-checked", $.get(on));
					$.set_attribute(button_1, "aria-label", $.get(bit).name);
					$.set_text(text_19, $.get(on) ? 1 : 0);
					$.set_text(text_20, `${$.get(bit).name ?? ""} ${$.get(bit).symbol ?? ""}`);
					$.set_text(text_22, $.get(bit).meaning);
				});
				$.delegated("click", button_1, () => set($.get(bit).name, $.get(on) ? 0 : 1));
				$.append($$anchor, li);
			});
			$.reset(ul);
			$.append($$anchor, ul);
		};
		$.if(node_7, ($$render) => {
			if ($.get(current).kind === "data") $$render(consequent_3);
			else $$render(alternate_1, -1);
		});
		var node_13 = $.sibling(node_7, 2);
		var consequent_7 = ($$anchor) => {
			var p_5 = root_13();
			var text_25 = $.only_child(p_5, true);
			$.template_effect(($0) => $.set_text(text_25, $0), [() => t("offsets.unused")]);
			$.append($$anchor, p_5);
		};
		$.if(node_13, ($$render) => {
			if ($.get(current).kind === "data" && !$.get(current).used) $$render(consequent_7);
		});
		var node_14 = $.sibling(node_13, 2);
		var consequent_8 = ($$anchor) => {
			var p_6 = root_13();
			var text_26 = $.only_child(p_6, true);
			$.template_effect(($0) => $.set_text(text_26, $0), [() => t("offsets.left_to_file")]);
			$.append($$anchor, p_6);
		};
		var d_3 = $.derived(() => $.get(left).has($.get(current).name));
		$.if(node_14, ($$render) => {
			if ($.get(d_3)) $$render(consequent_8);
		});
		var node_15 = $.sibling(node_14, 2);
		var consequent_9 = ($$anchor) => {
			var p_7 = root_14();
			var text_27 = $.only_child(p_7, true);
			$.template_effect(($0) => $.set_text(text_27, $0), [() => t("offsets.need", {
				level: $.get(current).level,
				name: t(`rights.level_${$.get(current).level}`)
			})]);
			$.append($$anchor, p_7);
		};
		$.if(node_15, ($$render) => {
			if ($.get(level) > $.get(current).level) $$render(consequent_9);
		});
		var node_16 = $.sibling(node_15, 2);
		var consequent_10 = ($$anchor) => {
			var p_8 = root_14();
			var text_28 = $.only_child(p_8, true);
			$.template_effect(($0) => $.set_text(text_28, $0), [() => t("offsets.need_mdi")]);
			$.append($$anchor, p_8);
		};
		var consequent_11 = ($$anchor) => {
			var p_9 = root_14();
			var text_29 = $.only_child(p_9, true);
			$.template_effect(($0) => $.set_text(text_29, $0), [() => t("offsets.need_switch")]);
			$.append($$anchor, p_9);
		};
		$.if(node_16, ($$render) => {
			if (machine.status?.mode !== "mdi") $$render(consequent_10);
			else if (machine.status.switches.parameters === false) $$render(consequent_11, 1);
		});
		$.reset(div_2);
		$.template_effect(() => $.set_text(text_9, $.get(current).name));
		$.append($$anchor, div_2);
	};
	$.if(node_5, ($$render) => {
		if ($.get(current)) $$render(consequent_12);
	});
	$.reset(div);
	var node_17 = $.sibling(div, 2);
	var consequent_13 = ($$anchor) => {
		var p_10 = root_16();
		var text_30 = $.only_child(p_10, true);
		$.template_effect(($0) => $.set_text(text_30, $0), [() => t("offsets.count", {
			n: number($.get(shown).length),
			all: number($.get(all).length)
		})]);
		$.append($$anchor, p_10);
	};
	$.if(node_17, ($$render) => {
		if ($.get(all).length) $$render(consequent_13);
	});
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["click"]);
export { Parameters as default };
