import { t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import Scope from "../../lib/parts/Scope.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/plc/Trace.svelte
var root = $.from_html(`<input class="code s-1czhrr0" autocapitalize="characters"/> <!>`, 1);
var root_1 = $.from_html(`<input class="code of s-1czhrr0" autocapitalize="characters" spellcheck="false"/> <!>`, 1);
var root_2 = $.from_html(`<span class="muted" role="status"> </span>`);
var root_3 = $.from_html(`<div class="recorder s-1czhrr0"><div class="trigger row wrap s-1czhrr0"><!> <!> <!></div> <div class="plot s-1czhrr0"><!></div></div>`);
var root_4 = $.from_html(`<!> <p class="muted s-1czhrr0" data-testid="traced"> </p>`, 1);
function Trace($$anchor, $$props) {
	$.push($$props, true);
	/** Changes that are recorded at most, scans that are recorded around a trigger, and how many are read at once. */
	const MOST = 2e4;
	const AROUND = 2e3;
	const AT_ONCE = 2e3;
	let wanted = $.state("KEY_START LAMP_START STL MF FIN");
	let starts = $.state("now");
	let of = $.state("MF");
	let edge = $.state("rising");
	let runs = $.state(false);
	let waits = $.state(false);
	let times = $.state([]);
	let lines = $.state([]);
	let names = $.state([]);
	/** What times are counted from, s: the trigger, else the first sample. */
	let start = 0;
	const beginnings = $.derived(() => [{
		value: "now",
		label: t("diagnosis.at_once")
	}, {
		value: "signal",
		label: t("plc.at_signal")
	}]);
	const edges = $.derived(() => [
		{
			value: "rising",
			label: t("diagnosis.rises")
		},
		{
			value: "falling",
			label: t("diagnosis.falls")
		},
		{
			value: "change",
			label: t("plc.changes")
		}
	]);
	$.user_effect(() => () => {
		$.set(runs, false);
	});
	const traced = async (most) => {
		const reply = await machine.ask({
			do: "traced",
			from: $.get(times).length,
			most
		});
		if (reply.reply !== "traced") throw new Error(reply.reply);
		return reply;
	};
	const pause = () => new Promise((resolve) => setTimeout(resolve, 100));
	/** Adds what was recorded since; whether there is more. */
	async function read() {
		const { triggered, rows, samples } = await traced(AT_ONCE);
		if ($.get(times).length === 0) start = triggered ?? rows[0]?.[0] ?? 0;
		$.set(times, [...$.get(times), ...rows.map(([at]) => at - start)]);
		$.set(lines, $.get(names).map((_, bit) => [...$.get(lines)[bit] ?? [], ...rows.map(([, bits]) => bits >>> bit & 1)]));
		return rows.length > 0 && $.get(times).length < samples;
	}
	async function record() {
		const asked = $.get(wanted).split(/[\s,]+/).filter(Boolean).slice(0, 32);
		const trigger = $.get(starts) === "signal" ? {
			signal: $.get(of).trim(),
			edge: $.get(edge)
		} : null;
		const samples = trigger ? AROUND : MOST;
		if (!await machine.tell({
			do: "trace",
			signals: asked,
			samples,
			trigger,
			behind: AROUND / 2,
			changes_only: !trigger
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
		$.set(waits, trigger !== null);
		try {
			while ($.get(runs) && $.get(waits)) if ((await traced(0)).done) $.set(waits, false);
			else await pause();
			for (let more = !$.get(waits); more || $.get(runs) && !trigger;) {
				more = await read();
				if ($.get(times).length >= MOST) $.set(runs, false);
				if (!more && $.get(runs) && !trigger) await pause();
			}
			await machine.tell({ do: "end_trace" });
		} catch (refused) {
			machine.refused(refused);
		}
		$.set(runs, $.set(waits, false), true);
	}
	var fragment = root_4();
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
				var div = root_3();
				var div_1 = $.child(div);
				var node_2 = $.child(div_1);
				{
					let $0 = $.derived(() => t("diagnosis.begin"));
					Segmented(node_2, {
						get options() {
							return $.get(beginnings);
						},
						get label() {
							return $.get($0);
						},
						get value() {
							return $.get(starts);
						},
						set value($$value) {
							$.set(starts, $$value, true);
						}
					});
				}
				var node_3 = $.sibling(node_2, 2);
				var consequent = ($$anchor) => {
					var fragment_3 = root_1();
					var input_1 = $.first_child(fragment_3);
					$.remove_input_defaults(input_1);
					var node_4 = $.sibling(input_1, 2);
					{
						let $0 = $.derived(() => t("diagnosis.edge"));
						Segmented(node_4, {
							get options() {
								return $.get(edges);
							},
							get label() {
								return $.get($0);
							},
							get value() {
								return $.get(edge);
							},
							set value($$value) {
								$.set(edge, $$value, true);
							}
						});
					}
					$.template_effect(($0, $1) => {
						$.set_attribute(input_1, "aria-label", $0);
						$.set_attribute(input_1, "title", $1);
					}, [() => t("plc.trigger"), () => t("plc.trigger")]);
					$.bind_value(input_1, () => $.get(of), ($$value) => $.set(of, $$value));
					$.append($$anchor, fragment_3);
				};
				$.if(node_3, ($$render) => {
					if ($.get(starts) === "signal") $$render(consequent);
				});
				var node_5 = $.sibling(node_3, 2);
				var consequent_1 = ($$anchor) => {
					var span = root_2();
					var text_1 = $.only_child(span, true);
					$.template_effect(($0) => $.set_text(text_1, $0), [() => t("plc.waits")]);
					$.append($$anchor, span);
				};
				$.if(node_5, ($$render) => {
					if ($.get(waits)) $$render(consequent_1);
				});
				$.reset(div_1);
				var div_2 = $.sibling(div_1, 2);
				var node_6 = $.child(div_2);
				var consequent_2 = ($$anchor) => {
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
				};
				var alternate = ($$anchor) => {
					{
						let $0 = $.derived(() => t("plc.trace_none"));
						let $1 = $.derived(() => t("plc.trace_none_text"));
						Empty($$anchor, {
							icon: "diagnosis",
							get title() {
								return $.get($0);
							},
							get text() {
								return $.get($1);
							}
						});
					}
				};
				$.if(node_6, ($$render) => {
					if ($.get(names).length) $$render(consequent_2);
					else $$render(alternate, -1);
				});
				$.reset(div_2);
				$.reset(div);
				$.append($$anchor, div);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var p = $.sibling(node, 2);
	var text_2 = $.only_child(p, true);
	$.template_effect(($0) => {
		$.set_attribute(p, "data-samples", $.get(times).length);
		$.set_text(text_2, $0);
	}, [() => t("plc.trace_text")]);
	$.append($$anchor, fragment);
	$.pop();
}
export { Trace as default };
