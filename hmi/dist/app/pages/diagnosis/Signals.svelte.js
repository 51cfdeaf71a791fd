import { http } from "../../lib/api/http.js";
import { language, number, t } from "../../lib/i18n/index.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { route } from "../../lib/routing.svelte.js";
import { followSignals } from "../../lib/state/again.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/diagnosis/Signals.svelte
var root = $.from_html(`<!> <input type="search"/>`, 1);
var root_1 = $.from_html(`<div><b class="number s-1mowcno"> </b> <span class="code address s-1mowcno"> </span> <span class="code name s-1mowcno"> </span> <span class="muted meaning s-1mowcno"> </span></div>`);
var root_2 = $.from_html(`<p class="muted s-1mowcno"> </p>`);
var root_3 = $.from_html(`<div class="signals s-1mowcno" data-testid="signals"></div> <!>`, 1);
function Signals($$anchor, $$props) {
	$.push($$props, true);
	const MOST = 150;
	let all = $.state([]);
	let values = $.state({});
	let area = $.state("F");
	let sought = $.state("");
	const areas = [
		"F",
		"G",
		"X",
		"Y",
		"A",
		"K",
		"D"
	].map((value) => ({
		value,
		label: value
	}));
	$.user_effect(() => {
		http.signals(language()).then((now) => $.set(all, now), (failed) => machine.refused(failed));
	});
	$.user_effect(() => {
		if (route.item) $.set(sought, route.item, true);
	});
	const found = $.derived(() => {
		const words = $.get(sought).toLowerCase().split(/\s+/).filter(Boolean);
		return $.get(all).filter((one) => words.length ? words.every((word) => `${one.name} ${one.address} ${one.meaning}`.toLowerCase().includes(word)) : one.address.startsWith($.get(area)));
	});
	const shown = $.derived(() => $.get(found).slice(0, MOST));
	$.user_effect(() => {
		return followSignals($.get(shown).map((one) => one.name), 150, (now) => $.set(values, now));
	});
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var node = $.first_child(fragment_1);
			{
				let $0 = $.derived(() => t("diagnosis.area"));
				Segmented(node, {
					get options() {
						return areas;
					},
					get label() {
						return $.get($0);
					},
					onchange: () => $.set(sought, ""),
					get value() {
						return $.get(area);
					},
					set value($$value) {
						$.set(area, $$value, true);
					}
				});
			}
			var input = $.sibling(node, 2);
			$.remove_input_defaults(input);
			$.template_effect(($0, $1) => {
				$.set_attribute(input, "placeholder", $0);
				$.set_attribute(input, "aria-label", $1);
			}, [() => t("app.search"), () => t("app.search")]);
			$.bind_value(input, () => $.get(sought), ($$value) => $.set(sought, $$value));
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("diagnosis.signals"));
		Card($$anchor, {
			get title() {
				return $.get($0);
			},
			fill: true,
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_2 = root_3();
				var div = $.first_child(fragment_2);
				$.each(div, 21, () => $.get(shown), (one) => one.address, ($$anchor, one) => {
					const value = $.derived(() => $.get(values)[$.get(one).name]);
					var div_1 = root_1();
					let classes;
					var b = $.child(div_1);
					var text = $.only_child(b, true);
					var span = $.sibling(b, 2);
					var text_1 = $.only_child(span, true);
					var span_1 = $.sibling(span, 2);
					var text_2 = $.only_child(span_1, true);
					var span_2 = $.sibling(span_1, 2);
					var text_3 = $.only_child(span_2, true);
					$.reset(div_1);
					$.template_effect(() => {
						classes = $.set_class(div_1, 1, "s-1mowcno", null, classes, { on: $.get(value) !== void 0 && $.get(value) !== 0 });
						$.set_text(text, $.get(value) ?? "·");
						$.set_text(text_1, $.get(one).address);
						$.set_text(text_2, $.get(one).name);
						$.set_text(text_3, $.get(one).meaning);
					});
					$.append($$anchor, div_1);
				});
				$.reset(div);
				var node_1 = $.sibling(div, 2);
				var consequent = ($$anchor) => {
					var p = root_2();
					var text_4 = $.only_child(p, true);
					$.template_effect(($0) => $.set_text(text_4, $0), [() => t("diagnosis.more", { n: number($.get(found).length - MOST) })]);
					$.append($$anchor, p);
				};
				$.if(node_1, ($$render) => {
					if ($.get(found).length > MOST) $$render(consequent);
				});
				$.append($$anchor, fragment_2);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.pop();
}
export { Signals as default };
