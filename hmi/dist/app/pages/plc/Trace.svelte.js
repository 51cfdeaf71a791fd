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
	/** Changes that are recorded at most, and how many are read at once. */
	const MOST = 2e4;
	const AT_ONCE = 2e3;
	let wanted = $.state("KEY_START LAMP_START STL MF FIN");
	let runs = $.state(false);
	let times = $.state([]);
	let lines = $.state([]);
	let names = $.state([]);
	/** When the first sample was taken, s. */
	let start = 0;
	$.user_effect(() => () => {
		$.set(runs, false);
	});
	/** Adds what was recorded since; whether there is more. */
	async function read() {
		const reply = await machine.ask({
			do: "traced",
			from: $.get(times).length,
			most: AT_ONCE
		});
		if (reply.reply !== "traced") return false;
		if ($.get(times).length === 0) start = reply.rows[0]?.[0] ?? 0;
		$.set(times, [...$.get(times), ...reply.rows.map(([at]) => at - start)]);
		$.set(lines, $.get(names).map((_, bit) => [...$.get(lines)[bit] ?? [], ...reply.rows.map(([, bits]) => bits >>> bit & 1)]));
		return $.get(times).length < reply.samples;
	}
	async function record() {
		const asked = $.get(wanted).split(/[\s,]+/).filter(Boolean).slice(0, 32);
		if (!await machine.tell({
			do: "trace",
			signals: asked,
			samples: MOST,
			changes_only: true
		})) return;
		(($$value) => {
			var $$array = $.to_array($$value, 3);
			$.set(names, $$array[0]);
			$.set(times, $$array[1]);
			$.set(lines, $$array[2]);
		})([
			asked,
			[],
			[]
		]);
		$.set(runs, true);
		try {
			for (let more = true; $.get(runs) || more;) {
				more = await read();
				if ($.get(times).length >= MOST) $.set(runs, false);
				if (!more && $.get(runs)) await new Promise((resolve) => setTimeout(resolve, 100));
			}
			await machine.tell({ do: "end_trace" });
		} catch (refused) {
			$.set(runs, false);
			machine.refused(refused);
		}
	}
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
					"data-testid": "trace-record",
					onclick: () => $.get(runs) ? $.set(runs, false) : void record(),
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
