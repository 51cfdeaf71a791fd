import { t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Scope from "../../lib/parts/Scope.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/plc/Trace.svelte
var root = $.from_html(`<input class="code s-1f460z2"/> <!>`, 1);
var root_1 = $.from_html(`<!> <p class="muted s-1f460z2"> </p>`, 1);
function Trace($$anchor, $$props) {
	$.push($$props, true);
	let wanted = $.state("KEY_START LAMP_START STL MF FIN");
	let runs = $.state(false);
	let times = $.state([]);
	let lines = $.state([]);
	const names = $.derived(() => $.get(wanted).split(/[\s,]+/).filter(Boolean).slice(0, 12));
	$.user_effect(() => {
		if (!$.get(runs)) return;
		const asked = $.get(names);
		let stopped = false;
		const start = performance.now();
		$.set(times, []);
		$.set(lines, asked.map(() => []));
		const ask = async () => {
			while (!stopped) {
				const reply = await machine.ask({
					do: "signals",
					names: asked
				}).catch((refused) => {
					machine.refused(refused);
					$.set(runs, false);
					return null;
				});
				if (stopped || reply?.reply !== "signals") return;
				$.set(times, [...$.get(times).slice(-3e3), (performance.now() - start) / 1e3]);
				$.set(lines, asked.map((name, index) => [...($.get(lines)[index] ?? []).slice(-3e3), (reply.signals[name] ?? 0) !== 0 ? 1 : 0]));
				await new Promise((resolve) => setTimeout(resolve, 20));
			}
		};
		ask();
		return () => {
			stopped = true;
		};
	});
	var fragment = root_1();
	var node = $.first_child(fragment);
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var input = $.first_child(fragment_1);
			$.remove_input_defaults(input);
			var node_1 = $.sibling(input, 2);
			{
				let $0 = $.derived(() => $.get(runs) ? "danger" : "primary");
				let $1 = $.derived(() => $.get(runs) ? "stop" : "play");
				Button(node_1, {
					get kind() {
						return $.get($0);
					},
					get icon() {
						return $.get($1);
					},
					onclick: () => $.set(runs, !$.get(runs)),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text = $.text();
						$.template_effect(($0) => $.set_text(text, $0), [() => $.get(runs) ? t("plc.stop") : t("plc.record")]);
						$.append($$anchor, text);
					},
					$$slots: { default: true }
				});
			}
			$.template_effect(($0, $1) => {
				$.set_attribute(input, "aria-label", $0);
				$.set_attribute(input, "title", $1);
			}, [() => t("plc.signals"), () => t("plc.signals")]);
			$.bind_value(input, () => $.get(wanted), ($$value) => $.set(wanted, $$value));
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("plc.trace"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			fill: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				{
					let $0 = $.derived(() => t("plc.trace"));
					Scope($$anchor, {
						get times() {
							return $.get(times);
						},
						get lines() {
							return $.get(lines);
						},
						get names() {
							return $.get(names);
						},
						steps: true,
						get label() {
							return $.get($0);
						}
					});
				}
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var p = $.sibling(node, 2);
	var text_1 = $.only_child(p, true);
	$.template_effect(($0) => $.set_text(text_1, $0), [() => t("plc.trace_text")]);
	$.append($$anchor, fragment);
	$.pop();
}
export { Trace as default };
