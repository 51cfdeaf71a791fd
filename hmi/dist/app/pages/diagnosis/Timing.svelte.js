import { t } from "../../lib/i18n/index.svelte.js";
import { fixed } from "../../lib/numbers.js";
import Card from "../../lib/parts/Card.svelte.js";
import Scope from "../../lib/parts/Scope.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/diagnosis/Timing.svelte
var root = $.from_html(`<dl class="number s-1660oid"><div><dt class="s-1660oid"> </dt><dd class="s-1660oid"> </dd></div> <div><dt class="s-1660oid"> </dt><dd class="s-1660oid"> </dd></div> <div><dt class="s-1660oid"> </dt><dd class="s-1660oid"> </dd></div> <div><dt class="s-1660oid"> </dt><dd class="s-1660oid"> </dd></div> <div><dt class="s-1660oid"> </dt><dd class="s-1660oid"> </dd></div></dl>`);
var root_1 = $.from_html(`<!> <!>`, 1);
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
	const sorted = $.derived(() => [...$.get(gaps)].sort((a, b) => a - b));
	const part = (share) => $.get(sorted)[Math.min($.get(sorted).length - 1, Math.floor($.get(sorted).length * share))];
	var fragment = root_1();
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
		let $0 = $.derived(() => t("diagnosis.gaps"));
		Card(node_1, {
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
