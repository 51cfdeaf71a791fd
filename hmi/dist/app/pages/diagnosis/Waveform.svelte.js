import { t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import Scope from "../../lib/parts/Scope.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { recorded } from "./recording.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/diagnosis/Waveform.svelte
var root = $.from_html(`<!> <!> <span class="seconds s-ykuuby"><!></span> <!>`, 1);
var root_1 = $.from_html(`<option> </option>`);
var root_2 = $.from_html(`<select class="code"></select> <!> <span class="measure s-ykuuby"><!></span> <span class="muted"> </span> <span class="measure s-ykuuby"><!></span>`, 1);
var root_3 = $.from_html(`<span class="muted" role="status"> </span>`);
var root_4 = $.from_html(`<div class="recorder s-ykuuby"><div class="trigger row wrap s-ykuuby"><!> <!> <span class="muted" data-testid="unit"> </span> <!></div> <div class="plot s-ykuuby"><!></div></div>`);
var root_5 = $.from_html(`<!> <p class="muted s-ykuuby" data-testid="samples"> </p>`, 1);
function Waveform($$anchor, $$props) {
	$.push($$props, true);
	let what = $.state("velocity");
	let runs = $.state(true);
	let seconds = $.state(2);
	let recording = $.state(false);
	let starts = $.state("now");
	/** The quantity of the trigger, by its place. */
	let of = $.state(0);
	let level = $.state(0);
	let edge = $.state("rises");
	let before = $.state(.2);
	let times = $.state([]);
	let lines = $.state([]);
	let names = $.state([]);
	const options = $.derived(() => [
		"velocity",
		"acceleration",
		"jerk",
		"position",
		"error",
		"path"
	].map((value) => ({
		value,
		label: t(`diagnosis.${value}`)
	})));
	/** Speeds are shown by the minute, and recorded by the second. */
	const PER_MINUTE = 60;
	const byMinute = (quantity) => /^velocity(\.|$)/.test(quantity);
	const unit = $.derived(() => $.get(what) === "velocity" ? t("unit.mm_min") : $.get(what) === "acceleration" ? t("unit.mm_s2") : $.get(what) === "jerk" ? t("unit.mm_s3") : $.get(what) === "path" ? `${t("unit.mm_min")}, ${t("unit.rpm")}` : t("unit.mm"));
	$.user_effect(() => {
		if (!$.get(runs)) return;
		const kind = $.get(what);
		const period = (machine.version?.period_ms ?? 1) / 1e3;
		const axes = machine.axes;
		const drawn = kind === "path" ? [
			"F",
			`S ${t("position.told")}`,
			`S ${t("position.actual")}`
		] : axes;
		$.set(names, drawn);
		let t0 = null;
		let before = null;
		/** Velocity and acceleration of the sample before, mm/s and mm/s², by axis; zero at first. */
		let v = {};
		let a = {};
		let at = [];
		let values = drawn.map(() => []);
		let shownAt = 0;
		return machine.watch((status) => {
			const now = status.periods * period;
			t0 ??= now;
			const dt = before ? (status.periods - before.periods) * period : 0;
			const sample = (axis) => {
				const here = status.position.machine[axis] ?? 0;
				if (kind === "position") return here;
				if (kind === "error") return here - (status.position.actual[axis] ?? here);
				if (dt <= 0) return 0;
				const velocity = (here - (before?.position.machine[axis] ?? here)) / dt;
				const acceleration = (velocity - (v[axis] ?? velocity)) / dt;
				const jerk = (acceleration - (a[axis] ?? acceleration)) / dt;
				v = {
					...v,
					[axis]: velocity
				};
				a = {
					...a,
					[axis]: acceleration
				};
				return kind === "velocity" ? velocity * PER_MINUTE : kind === "acceleration" ? acceleration : jerk;
			};
			at = [...at.slice(-999), now - t0];
			values = (kind === "path" ? [
				status.feed.actual,
				status.spindle.told,
				Math.abs(status.spindle.actual)
			] : axes.map(sample)).map((value, index) => [...(values[index] ?? []).slice(-999), value]);
			before = status;
			if (performance.now() - shownAt > 100) {
				shownAt = performance.now();
				$.set(times, at);
				$.set(lines, values);
			}
		});
	});
	const recordable = $.derived(() => $.get(what) === "path" ? ["velocity", "spindle"] : machine.axes.map((axis) => `${$.get(what) === "position" ? "commanded" : $.get(what)}.${axis}`));
	const beginnings = $.derived(() => [{
		value: "now",
		label: t("diagnosis.at_once")
	}, {
		value: "level",
		label: t("diagnosis.at_level")
	}]);
	const edges = $.derived(() => [{
		value: "rises",
		label: t("diagnosis.rises")
	}, {
		value: "falls",
		label: t("diagnosis.falls")
	}]);
	/** Records, or ends the recording that waits for its trigger. */
	async function record() {
		if ($.get(recording)) {
			await machine.tell({ do: "end_capture" });
			return;
		}
		const by = $.get(recordable)[$.get(of)] ?? $.get(recordable)[0] ?? "";
		const trigger = $.get(starts) === "level" ? {
			quantity: by,
			level: byMinute(by) ? $.get(level) / PER_MINUTE : $.get(level),
			rises: $.get(edge) === "rises"
		} : null;
		if (!await machine.tell({
			do: "capture",
			quantities: $.get(recordable),
			seconds: $.get(seconds),
			trigger,
			before: trigger ? $.get(before) : 0
		})) return;
		$.set(runs, false);
		$.set(recording, true);
		try {
			const read = await recorded(async (from, most) => {
				const part = await machine.ask({
					do: "captured",
					from,
					most
				});
				if (part.reply !== "captured") throw new Error(part.reply);
				return part;
			}, async () => {
				await new Promise((resolve) => setTimeout(resolve, 100));
				return shown;
			});
			if (read) {
				$.set(names, read.names), $.set(times, read.times);
				$.set(lines, read.lines.map((line, index) => byMinute(read.names[index] ?? "") ? line.map((value) => value * PER_MINUTE) : line));
			}
		} catch (refused) {
			machine.refused(refused);
		}
		$.set(recording, false);
	}
	let shown = true;
	$.user_effect(() => () => {
		shown = false;
	});
	var fragment = root_5();
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
			{
				let $0 = $.derived(() => $.get(recording) ? "stop" : "clock");
				Button(node_4, {
					get icon() {
						return $.get($0);
					},
					get pressed() {
						return $.get(recording);
					},
					onclick: () => void record(),
					"data-testid": "record",
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_1 = $.text();
						$.template_effect(($0) => $.set_text(text_1, $0), [() => $.get(recording) ? t("diagnosis.end") : t("diagnosis.record")]);
						$.append($$anchor, text_1);
					},
					$$slots: { default: true }
				});
			}
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
				var div = root_4();
				var div_1 = $.child(div);
				var node_5 = $.child(div_1);
				{
					let $0 = $.derived(() => t("diagnosis.begin"));
					Segmented(node_5, {
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
				var node_6 = $.sibling(node_5, 2);
				var consequent = ($$anchor) => {
					var fragment_4 = root_2();
					var select = $.first_child(fragment_4);
					$.each(select, 22, () => $.get(recordable), (one) => one, ($$anchor, one, index) => {
						var option = root_1();
						var text_2 = $.only_child(option, true);
						var option_value = {};
						$.template_effect(() => {
							$.set_text(text_2, one);
							if (option_value !== (option_value = $.get(index))) option.value = (option.__value = option_value) ?? "";
						});
						$.append($$anchor, option);
					});
					$.reset(select);
					$.init_select(select);
					var node_7 = $.sibling(select, 2);
					{
						let $0 = $.derived(() => t("diagnosis.edge"));
						Segmented(node_7, {
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
					var span_1 = $.sibling(node_7, 2);
					var node_8 = $.child(span_1);
					{
						let $0 = $.derived(() => t("diagnosis.level"));
						NumberField(node_8, {
							get value() {
								return $.get(level);
							},
							get unit() {
								return $.get(unit);
							},
							get label() {
								return $.get($0);
							},
							onvalue: (value) => $.set(level, value ?? 0, true)
						});
					}
					$.reset(span_1);
					var span_2 = $.sibling(span_1, 2);
					var text_3 = $.only_child(span_2, true);
					var span_3 = $.sibling(span_2, 2);
					var node_9 = $.child(span_3);
					{
						let $0 = $.derived(() => t("unit.s"));
						let $1 = $.derived(() => t("diagnosis.before"));
						NumberField(node_9, {
							get value() {
								return $.get(before);
							},
							digits: 2,
							minimum: 0,
							get maximum() {
								return $.get(seconds);
							},
							get unit() {
								return $.get($0);
							},
							get label() {
								return $.get($1);
							},
							onvalue: (value) => $.set(before, value ?? 0, true)
						});
					}
					$.reset(span_3);
					$.template_effect(($0, $1) => {
						$.set_attribute(select, "aria-label", $0);
						$.set_text(text_3, $1);
					}, [() => t("diagnosis.quantity"), () => t("diagnosis.before")]);
					$.bind_select_value(select, () => $.get(of), ($$value) => $.set(of, $$value));
					$.append($$anchor, fragment_4);
				};
				$.if(node_6, ($$render) => {
					if ($.get(starts) === "level") $$render(consequent);
				});
				var span_4 = $.sibling(node_6, 2);
				var text_4 = $.only_child(span_4, true);
				var node_10 = $.sibling(span_4, 2);
				var consequent_1 = ($$anchor) => {
					var span_5 = root_3();
					var text_5 = $.only_child(span_5, true);
					$.template_effect(($0) => $.set_text(text_5, $0), [() => t("diagnosis.recording")]);
					$.append($$anchor, span_5);
				};
				$.if(node_10, ($$render) => {
					if ($.get(recording)) $$render(consequent_1);
				});
				$.reset(div_1);
				var div_2 = $.sibling(div_1, 2);
				var node_11 = $.child(div_2);
				{
					let $0 = $.derived(() => t("diagnosis.waveform"));
					Scope(node_11, {
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
				$.reset(div_2);
				$.reset(div);
				$.template_effect(() => $.set_text(text_4, $.get(unit)));
				$.append($$anchor, div);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var p = $.sibling(node, 2);
	var text_6 = $.only_child(p, true);
	$.template_effect(($0) => {
		$.set_attribute(p, "data-samples", $.get(times).length);
		$.set_text(text_6, $0);
	}, [() => t("diagnosis.waveform_text")]);
	$.append($$anchor, fragment);
	$.pop();
}
export { Waveform as default };
