import { t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import Scope from "../../lib/parts/Scope.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { csv } from "./csv.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/diagnosis/Waveform.svelte
var root = $.from_html(`<!> <!> <span class="seconds s-oxsfao"><!></span> <!>`, 1);
var root_1 = $.from_html(`<!> <p class="muted s-oxsfao"> </p>`, 1);
function Waveform($$anchor, $$props) {
	$.push($$props, true);
	let what = $.state("velocity");
	let runs = $.state(true);
	let seconds = $.state(2);
	let recording = $.state(false);
	let times = $.state([]);
	let lines = $.state([]);
	let names = $.state([]);
	const options = $.derived(() => [
		"velocity",
		"position",
		"error",
		"path"
	].map((value) => ({
		value,
		label: t(`diagnosis.${value}`)
	})));
	$.user_effect(() => {
		if (!$.get(runs)) return;
		const kind = $.get(what);
		const period = (machine.version?.period_ms ?? 1) / 1e3;
		const axes = machine.axes;
		$.set(names, kind === "path" ? ["F", "S"] : axes);
		let t0 = null;
		let before = null;
		let at = [];
		let values = $.get(names).map(() => []);
		let shownAt = 0;
		return machine.watch((status) => {
			const now = status.periods * period;
			t0 ??= now;
			const dt = before ? (status.periods - before.periods) * period : 0;
			const sample = (axis) => {
				const here = status.position.machine[axis] ?? 0;
				if (kind === "position") return here;
				if (kind === "error") return here - (status.position.actual[axis] ?? here);
				return dt > 0 ? (here - (before?.position.machine[axis] ?? here)) / dt * 60 : 0;
			};
			at = [...at.slice(-999), now - t0];
			values = (kind === "path" ? [status.feed.actual, status.spindle.told] : axes.map(sample)).map((value, index) => [...(values[index] ?? []).slice(-999), value]);
			before = status;
			if (performance.now() - shownAt > 100) {
				shownAt = performance.now();
				$.set(times, at);
				$.set(lines, values);
			}
		});
	});
	async function record() {
		$.set(runs, false);
		const quantities = $.get(what) === "path" ? ["velocity", "spindle"] : machine.axes.map((axis) => `${$.get(what) === "position" ? "commanded" : $.get(what) === "error" ? "error" : "velocity"}.${axis}`);
		if (!await machine.tell({
			do: "capture",
			quantities,
			seconds: $.get(seconds)
		})) return;
		$.set(recording, true);
		await new Promise((resolve) => setTimeout(resolve, $.get(seconds) * 1e3 + 300));
		$.set(recording, false);
		try {
			const reply = await machine.ask({
				do: "captured",
				from: 0,
				most: 1e3
			});
			const table = csv(reply.csv ?? reply.text ?? "");
			$.set(names, table.names.slice(1));
			$.set(times, table.columns[0] ?? []);
			$.set(lines, table.columns.slice(1));
		} catch (refused) {
			machine.refused(refused);
		}
	}
	var fragment = root_1();
	var node = $.first_child(fragment);
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var node_1 = $.first_child(fragment_1);
			{
				let $0 = $.derived(() => t("diagnosis.waveform"));
				Segmented(node_1, {
					get options() {
						return $.get(options);
					},
					get label() {
						return $.get($0);
					},
					get value() {
						return $.get(what);
					},
					set value($$value) {
						$.set(what, $$value, true);
					}
				});
			}
			var node_2 = $.sibling(node_1, 2);
			{
				let $0 = $.derived(() => $.get(runs) ? "pause" : "play");
				Button(node_2, {
					get pressed() {
						return $.get(runs);
					},
					get icon() {
						return $.get($0);
					},
					onclick: () => $.set(runs, !$.get(runs)),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text = $.text();
						$.template_effect(($0) => $.set_text(text, $0), [() => t("graphics.live")]);
						$.append($$anchor, text);
					},
					$$slots: { default: true }
				});
			}
			var span = $.sibling(node_2, 2);
			var node_3 = $.child(span);
			{
				let $0 = $.derived(() => t("unit.s"));
				let $1 = $.derived(() => t("diagnosis.duration"));
				NumberField(node_3, {
					get value() {
						return $.get(seconds);
					},
					digits: 1,
					minimum: .1,
					maximum: 30,
					get unit() {
						return $.get($0);
					},
					get label() {
						return $.get($1);
					},
					onvalue: (value) => $.set(seconds, value ?? 2, true)
				});
			}
			$.reset(span);
			var node_4 = $.sibling(span, 2);
			Button(node_4, {
				icon: "clock",
				get busy() {
					return $.get(recording);
				},
				onclick: () => void record(),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_1 = $.text();
					$.template_effect(($0) => $.set_text(text_1, $0), [() => t("diagnosis.record")]);
					$.append($$anchor, text_1);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("diagnosis.waveform"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			fill: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				{
					let $0 = $.derived(() => t("diagnosis.waveform"));
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
	var text_2 = $.only_child(p, true);
	$.template_effect(($0) => $.set_text(text_2, $0), [() => t("diagnosis.waveform_text")]);
	$.append($$anchor, fragment);
	$.pop();
}
export { Waveform as default };
