import Digits from "../../lib/digits/Digits.svelte.js";
import { t } from "../../lib/i18n/index.svelte.js";
import { duration } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/position/Times.svelte
var root = $.from_html(`<dl class="s-3nab8q"><dt class="s-3nab8q"> </dt> <dd class="number parts s-3nab8q" data-testid="parts"><!></dd> <!> <dt class="s-3nab8q"> </dt> <dd class="number time s-3nab8q"><!></dd> <!> <dt class="s-3nab8q"> </dt> <dd class="number time s-3nab8q"><!></dd> <!> <dt class="s-3nab8q"> </dt> <dd class="number time s-3nab8q"><!></dd></dl>`);
function Times($$anchor, $$props) {
	$.push($$props, true);
	const counters = $.derived(() => machine.status.counters);
	/** What the page of the control has room for (GSK990MC part 2, 3.1.2). */
	const MOST_PARTS = 9999999;
	const set = (counter, value) => void machine.tell({
		do: "set_counter",
		counter,
		value
	});
	const clear = (counter) => set(counter, 0);
	Card($$anchor, {
		children: ($$anchor, $$slotProps) => {
			var dl = root();
			var dt = $.child(dl);
			var text = $.only_child(dt, true);
			var dd = $.sibling(dt, 2);
			var node = $.child(dd);
			{
				let $0 = $.derived(() => t("position.parts"));
				NumberField(node, {
					get value() {
						return $.get(counters).parts;
					},
					whole: true,
					minimum: 0,
					maximum: MOST_PARTS,
					get label() {
						return $.get($0);
					},
					onvalue: (value) => set("parts", value ?? 0)
				});
			}
			$.reset(dd);
			var node_1 = $.sibling(dd, 2);
			{
				let $0 = $.derived(() => t("position.clear", { what: t("position.parts") }));
				Button(node_1, {
					kind: "quiet",
					icon: "reset",
					get "aria-label"() {
						return $.get($0);
					},
					onclick: () => clear("parts")
				});
			}
			var dt_1 = $.sibling(node_1, 2);
			var text_1 = $.only_child(dt_1, true);
			var dd_1 = $.sibling(dt_1, 2);
			var node_2 = $.child(dd_1);
			Digits(node_2, { of: ({ counters }) => duration(counters.run_time) });
			$.reset(dd_1);
			var node_3 = $.sibling(dd_1, 2);
			{
				let $0 = $.derived(() => t("position.clear", { what: t("position.run_time") }));
				Button(node_3, {
					kind: "quiet",
					icon: "reset",
					get "aria-label"() {
						return $.get($0);
					},
					onclick: () => clear("run-time")
				});
			}
			var dt_2 = $.sibling(node_3, 2);
			var text_2 = $.only_child(dt_2, true);
			var dd_2 = $.sibling(dt_2, 2);
			var node_4 = $.child(dd_2);
			Digits(node_4, { of: ({ counters }) => duration(counters.cutting_time) });
			$.reset(dd_2);
			var node_5 = $.sibling(dd_2, 2);
			{
				let $0 = $.derived(() => t("position.clear", { what: t("position.cutting_time") }));
				Button(node_5, {
					kind: "quiet",
					icon: "reset",
					get "aria-label"() {
						return $.get($0);
					},
					onclick: () => clear("cutting-time")
				});
			}
			var dt_3 = $.sibling(node_5, 2);
			var text_3 = $.only_child(dt_3, true);
			var dd_3 = $.sibling(dt_3, 2);
			var node_6 = $.child(dd_3);
			Digits(node_6, { of: ({ counters }) => duration(counters.power_on_time) });
			$.reset(dd_3);
			$.reset(dl);
			$.template_effect(($0, $1, $2, $3) => {
				$.set_text(text, $0);
				$.set_attribute(dd, "data-parts", $.get(counters).parts);
				$.set_text(text_1, $1);
				$.set_text(text_2, $2);
				$.set_text(text_3, $3);
			}, [
				() => t("position.parts"),
				() => t("position.run_time"),
				() => t("position.cutting_time"),
				() => t("position.power_on_time")
			]);
			$.append($$anchor, dl);
		},
		$$slots: { default: true }
	});
	$.pop();
}
export { Times as default };
