import { t } from "../../lib/i18n/index.svelte.js";
import { fixed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Scope from "../../lib/parts/Scope.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/diagnosis/Timing.svelte
var root = $.from_html(`<dl class="number s-1sz6db4"><div><dt class="s-1sz6db4"> </dt><dd class="s-1sz6db4"> </dd></div> <div><dt class="s-1sz6db4"> </dt><dd class="s-1sz6db4"> </dd></div> <div><dt class="s-1sz6db4"> </dt><dd class="s-1sz6db4"> </dd></div> <div><dt class="s-1sz6db4"> </dt><dd class="s-1sz6db4"> </dd></div> <div><dt class="s-1sz6db4"> </dt><dd class="s-1sz6db4"> </dd></div></dl>`);
var root_1 = $.from_html(`<tr><th> </th><td class="right number"> </td><td class="share s-1sz6db4"><meter min="0" class="s-1sz6db4"></meter></td><td class="right number muted"> </td></tr>`);
var root_2 = $.from_html(`<table class="table" data-testid="timing"><tbody><!><tr><th> </th><td class="right number"> </td><td></td><td></td></tr><tr><th> </th><td class="right number"> </td><td></td><td></td></tr></tbody></table>`);
var root_3 = $.from_html(`<!> <!> <!>`, 1);
function Timing($$anchor, $$props) {
	$.push($$props, true);
	let times = $.state([]);
	let gaps = $.state([]);
	let round = $.state(0);
	let drift = $.state(0);
	$.user_effect(() => {
		const period = machine.version?.period_ms ?? 1;
		let first = null;
		let before = 0;
		let own = [];
		let at = [];
		let shownAt = 0;
		return machine.watch((status) => {
			const now = performance.now();
			first ??= {
				at: now,
				periods: status.periods
			};
			if (before) {
				own = [...own.slice(-499), now - before];
				at = [...at.slice(-499), (now - first.at) / 1e3];
			}
			before = now;
			if (now - shownAt > 200) {
				shownAt = now;
				$.set(times, at);
				$.set(gaps, own);
				$.set(drift, (status.periods - first.periods) * period - (now - first.at));
			}
		});
	});
	$.user_effect(() => {
		const ask = async () => {
			if (machine.link !== "open") return;
			const start = performance.now();
			if (await machine.ask({ do: "alive" }).catch(() => null)) $.set(round, performance.now() - start);
		};
		const timer = setInterval(() => void ask(), 1e3);
		return () => clearInterval(timer);
	});
	let own = $.state(null);
	async function take(forget) {
		const reply = await machine.fetch("timing", {
			do: "timing",
			forget
		});
		if (reply) $.set(own, forget ? await machine.fetch("timing", {
			do: "timing",
			forget: false
		}) ?? $.get(own) : reply);
	}
	$.user_effect(() => {
		const ask = () => {
			if (machine.link === "open" && document.visibilityState === "visible") take(false);
		};
		ask();
		const timer = setInterval(ask, 1e3);
		return () => clearInterval(timer);
	});
	const worst = $.derived(() => $.get(own) ? [
		["worst_period", $.get(own).worst_period_us],
		["worst_work", $.get(own).worst_work_us],
		["level_1", $.get(own).worst_level_1_us],
		["level_2", $.get(own).worst_level_2_us]
	] : []);
	const sorted = $.derived(() => [...$.get(gaps)].sort((a, b) => a - b));
	const part = (share) => $.get(sorted)[Math.min($.get(sorted).length - 1, Math.floor($.get(sorted).length * share))];
	var fragment = root_3();
	var node = $.first_child(fragment);
	Card(node, {
		children: ($$anchor, $$slotProps) => {
			var dl = root();
			var div = $.child(dl);
			var dt = $.child(div);
			var text = $.only_child(dt, true);
			var dd = $.sibling(dt);
			var text_1 = $.only_child(dd);
			$.reset(div);
			var div_1 = $.sibling(div, 2);
			var dt_1 = $.child(div_1);
			var text_2 = $.only_child(dt_1, true);
			var dd_1 = $.sibling(dt_1);
			var text_3 = $.only_child(dd_1, true);
			$.reset(div_1);
			var div_2 = $.sibling(div_1, 2);
			var dt_2 = $.child(div_2);
			var text_4 = $.only_child(dt_2, true);
			var dd_2 = $.sibling(dt_2);
			var text_5 = $.only_child(dd_2);
			$.reset(div_2);
			var div_3 = $.sibling(div_2, 2);
			var dt_3 = $.child(div_3);
			var text_6 = $.only_child(dt_3, true);
			var dd_3 = $.sibling(dt_3);
			var text_7 = $.only_child(dd_3);
			$.reset(div_3);
			var div_4 = $.sibling(div_3, 2);
			var dt_4 = $.child(div_4);
			var text_8 = $.only_child(dt_4, true);
			var dd_4 = $.sibling(dt_4);
			var text_9 = $.only_child(dd_4);
			$.reset(div_4);
			$.reset(dl);
			$.template_effect(($0, $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12) => {
				$.set_text(text, $0);
				$.set_text(text_1, `${machine.version?.period_ms ?? ""} ${$1 ?? ""}`);
				$.set_text(text_2, $2);
				$.set_text(text_3, machine.status?.periods ?? 0);
				$.set_text(text_4, $3);
				$.set_text(text_5, `${$4 ?? ""} ${$5 ?? ""}`);
				$.set_text(text_6, $6);
				$.set_text(text_7, `${$7 ?? ""} / ${$8 ?? ""} ${$9 ?? ""}`);
				$.set_text(text_8, $10);
				$.set_text(text_9, `${$11 ?? ""} ${$12 ?? ""}`);
			}, [
				() => t("settings.period"),
				() => t("unit.ms"),
				() => t("diagnosis.periods"),
				() => t("diagnosis.drift"),
				() => fixed($.get(drift), 1),
				() => t("unit.ms"),
				() => t("diagnosis.gap"),
				() => fixed(part(.5), 1),
				() => fixed(part(.99), 1),
				() => t("unit.ms"),
				() => t("diagnosis.round"),
				() => fixed($.get(round), 1),
				() => t("unit.ms")
			]);
			$.append($$anchor, dl);
		},
		$$slots: { default: true }
	});
	var node_1 = $.sibling(node, 2);
	{
		const actions = ($$anchor) => {
			Button($$anchor, {
				icon: "undo",
				onclick: () => void take(true),
				"data-testid": "forget-timing",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_10 = $.text();
					$.template_effect(($0) => $.set_text(text_10, $0), [() => t("diagnosis.anew")]);
					$.append($$anchor, text_10);
				},
				$$slots: { default: true }
			});
		};
		let $0 = $.derived(() => t("diagnosis.control_time"));
		Card(node_1, {
			get title() {
				return $.get($0);
			},
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_3 = $.comment();
				var node_2 = $.first_child(fragment_3);
				var consequent = ($$anchor) => {
					var table = root_2();
					var tbody = $.child(table);
					var node_3 = $.child(tbody);
					$.each(node_3, 17, () => $.get(worst), ([name, us]) => name, ($$anchor, $$item) => {
						var $$array = $.derived(() => $.to_array($.get($$item), 2));
						let name = () => $.get($$array)[0];
						let us = () => $.get($$array)[1];
						var tr = root_1();
						var th = $.child(tr);
						var text_11 = $.only_child(th, true);
						var td = $.sibling(th);
						var text_12 = $.only_child(td);
						var td_1 = $.sibling(td);
						var meter = $.only_child(td_1);
						var td_2 = $.sibling(td_1);
						var text_13 = $.only_child(td_2);
						$.reset(tr);
						$.template_effect(($0, $1, $2, $3, $4, $5) => {
							$.set_attribute(tr, "data-timing", name());
							$.set_text(text_11, $0);
							$.set_text(text_12, `${$1 ?? ""} ${$2 ?? ""}`);
							$.set_attribute(meter, "max", $.get(own).period_us);
							$.set_value(meter, $3);
							$.set_attribute(meter, "aria-label", $4);
							$.set_text(text_13, `${$5 ?? ""} %`);
						}, [
							() => t(`diagnosis.${name()}`),
							() => fixed(us(), 1),
							() => t("unit.us"),
							() => Math.min(us(), $.get(own).period_us),
							() => t(`diagnosis.${name()}`),
							() => fixed(us() / $.get(own).period_us * 100, 0)
						]);
						$.append($$anchor, tr);
					});
					var tr_1 = $.sibling(node_3);
					var th_1 = $.child(tr_1);
					var text_14 = $.only_child(th_1, true);
					var td_3 = $.sibling(th_1);
					var text_15 = $.only_child(td_3, true);
					$.next(2);
					$.reset(tr_1);
					var tr_2 = $.sibling(tr_1);
					var th_2 = $.child(tr_2);
					var text_16 = $.only_child(th_2, true);
					var td_4 = $.sibling(th_2);
					var text_17 = $.only_child(td_4, true);
					$.next(2);
					$.reset(tr_2);
					$.reset(tbody);
					$.reset(table);
					$.template_effect(($0, $1) => {
						$.set_attribute(table, "data-periods", $.get(own).periods);
						$.set_text(text_14, $0);
						$.set_text(text_15, $.get(own).level_2_periods);
						$.set_text(text_16, $1);
						$.set_text(text_17, $.get(own).periods);
					}, [() => t("diagnosis.level_2_periods"), () => t("diagnosis.since")]);
					$.append($$anchor, table);
				};
				$.if(node_2, ($$render) => {
					if ($.get(own)) $$render(consequent);
				});
				$.append($$anchor, fragment_3);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var node_4 = $.sibling(node_1, 2);
	{
		let $0 = $.derived(() => t("diagnosis.gaps"));
		Card(node_4, {
			get title() {
				return $.get($0);
			},
			fill: true,
			children: ($$anchor, $$slotProps) => {
				{
					let $0 = $.derived(() => [$.get(gaps)]);
					let $1 = $.derived(() => [t("unit.ms")]);
					let $2 = $.derived(() => t("diagnosis.gaps"));
					Scope($$anchor, {
						get times() {
							return $.get(times);
						},
						get lines() {
							return $.get($0);
						},
						get names() {
							return $.get($1);
						},
						get label() {
							return $.get($2);
						}
					});
				}
			},
			$$slots: { default: true }
		});
	}
	$.append($$anchor, fragment);
	$.pop();
}
export { Timing as default };
