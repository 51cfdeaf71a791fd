import { t } from "../../lib/i18n/index.svelte.js";
import { firstOfPage, fixed, numberNamed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Find from "../../lib/parts/Find.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/offsets/Variables.svelte
var root = $.from_html(`<!> <!> <!> <!> <!>`, 1);
var root_1 = $.from_html(`<span class="number"> </span>`);
var root_2 = $.from_html(`<div tabindex="-1"><span class="code s-1qujq0n"> </span> <!></div>`);
var root_3 = $.from_html(`<div class="grid s-1qujq0n"></div>`);
function Variables($$anchor, $$props) {
	$.push($$props, true);
	const ranges = [
		{
			id: "local",
			from: 1,
			to: 50,
			own: true
		},
		{
			id: "common",
			from: 100,
			to: 199,
			own: true
		},
		{
			id: "kept",
			from: 500,
			to: 999,
			own: true
		},
		{
			id: "system",
			from: 1e3,
			to: 5999,
			own: false
		}
	];
	let id = $.state("common");
	let first = $.state(100);
	let values = $.state({});
	const range = $.derived(() => ranges.find((one) => one.id === $.get(id)));
	const PAGE = 100;
	const options = $.derived(() => ranges.map((one) => ({
		value: one.id,
		label: t(`offsets.range_${one.id}`)
	})));
	const numbers = $.derived(() => Array.from({ length: Math.min(PAGE, $.get(range).to - $.get(first) + 1) }, (_, index) => $.get(first) + index));
	const rangeOf = (number) => ranges.find(({ from, to }) => number >= from && number <= to);
	function named(text) {
		const number = numberNamed(text, "#", 1, 5999);
		return number !== null && rangeOf(number) ? number : null;
	}
	function show(found) {
		const number = Number(found);
		const within = rangeOf(number);
		$.set(id, within.id, true);
		$.set(first, firstOfPage(number, within.from, PAGE), true);
	}
	async function read() {
		const from = $.get(first);
		const reply = await machine.fetch("variables", {
			do: "variables",
			from,
			to: Math.min(from + PAGE - 1, $.get(range).to)
		});
		if (reply && from === $.get(first)) $.set(values, reply.variables);
	}
	$.user_effect(() => {
		machine.changed("variables");
		$.get(first);
		if (machine.link === "open") read();
	});
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var node = $.first_child(fragment_1);
			{
				let $0 = $.derived(() => t("offsets.find"));
				Find(node, {
					get label() {
						return $.get($0);
					},
					placeholder: "#500",
					meant: named,
					at: "data-variable",
					onfind: show,
					"data-testid": "find-variable"
				});
			}
			var node_1 = $.sibling(node, 2);
			{
				let $0 = $.derived(() => t("offsets.variables"));
				Segmented(node_1, {
					get options() {
						return $.get(options);
					},
					get label() {
						return $.get($0);
					},
					onchange: (now) => $.set(first, ranges.find((one) => one.id === now).from, true),
					get value() {
						return $.get(id);
					},
					set value($$value) {
						$.set(id, $$value, true);
					}
				});
			}
			var node_2 = $.sibling(node_1, 2);
			{
				let $0 = $.derived(() => t("offsets.before"));
				let $1 = $.derived(() => $.get(first) <= $.get(range).from);
				Button(node_2, {
					icon: "left",
					get "aria-label"() {
						return $.get($0);
					},
					get disabled() {
						return $.get($1);
					},
					onclick: () => $.set(first, Math.max($.get(range).from, $.get(first) - PAGE), true)
				});
			}
			var node_3 = $.sibling(node_2, 2);
			{
				let $0 = $.derived(() => t("offsets.after"));
				let $1 = $.derived(() => $.get(first) + PAGE > $.get(range).to);
				Button(node_3, {
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
			var node_4 = $.sibling(node_3, 2);
			{
				let $0 = $.derived(() => t("offsets.read_again"));
				let $1 = $.derived(() => t("offsets.read_again"));
				Button(node_4, {
					icon: "reset",
					get "aria-label"() {
						return $.get($0);
					},
					get title() {
						return $.get($1);
					},
					onclick: () => void read()
				});
			}
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("offsets.variables"));
		Card($$anchor, {
			get title() {
				return $.get($0);
			},
			fill: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var div = root_3();
				$.each(div, 20, () => $.get(numbers), (number) => number, ($$anchor, number) => {
					var div_1 = root_2();
					let classes;
					var span = $.child(div_1);
					var text_1 = $.only_child(span);
					var node_5 = $.sibling(span, 2);
					var consequent = ($$anchor) => {
						{
							let $0 = $.derived(() => $.get(values)[number] ?? null);
							let $1 = $.derived(() => `#${number}`);
							NumberField($$anchor, {
								get value() {
									return $.get($0);
								},
								digits: 4,
								empty: true,
								get label() {
									return $.get($1);
								},
								onvalue: (value) => void machine.tell({
									do: "set_variable",
									number,
									value
								}).then(() => read())
							});
						}
					};
					var alternate = ($$anchor) => {
						var span_1 = root_1();
						var text_2 = $.only_child(span_1, true);
						$.template_effect(($0) => $.set_text(text_2, $0), [() => number in $.get(values) ? fixed($.get(values)[number], 4) : "–"]);
						$.append($$anchor, span_1);
					};
					$.if(node_5, ($$render) => {
						if ($.get(range).own) $$render(consequent);
						else $$render(alternate, -1);
					});
					$.reset(div_1);
					$.template_effect(() => {
						classes = $.set_class(div_1, 1, "variable s-1qujq0n", null, classes, { set: number in $.get(values) });
						$.set_attribute(div_1, "data-variable", number);
						$.set_text(text_1, `#${number ?? ""}`);
					});
					$.append($$anchor, div_1);
				});
				$.reset(div);
				$.append($$anchor, div);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.pop();
}
export { Variables as default };
