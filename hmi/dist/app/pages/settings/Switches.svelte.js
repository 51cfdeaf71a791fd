import { moment, t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import ParameterSwitch from "../../lib/parts/ParameterSwitch.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/settings/Switches.svelte
var root = $.from_html(`<small class="muted"> </small>`);
var root_1 = $.from_html(`<fieldset class="s-m794go"><!></fieldset>`);
var root_2 = $.from_html(`<span> <!></span> <!>`, 1);
var root_3 = $.from_html(`<p class="muted"> </p>`);
var root_4 = $.from_html(`<div class="rows s-m794go" data-testid="switches"><span> </span> <span class="row wrap"><!></span> <!> <!> <p class="muted hint s-m794go"> </p> <!> <p class="muted hint s-m794go"> </p> <!> <span> <!></span> <span class="short s-m794go"><!></span> <span> </span> <span class="row wrap"><input class="code short s-m794go" autocapitalize="characters" data-testid="stop-program"/> <span class="short s-m794go"><!></span> <span class="code" data-testid="stop"> </span> <!></span> <span> </span> <span><time class="number" data-testid="clock"> </time><br/><small class="muted"> </small></span></div> <!>`, 1);
function Switches($$anchor, $$props) {
	$.push($$props, true);
	const level = ($$anchor, name = $.noop) => {
		var small = root();
		var text_1 = $.only_child(small, true);
		$.template_effect(($0) => $.set_text(text_1, $0), [() => $.get(levels).has(name()) ? t("settings.set_level", { level: $.get(levels).get(name()) }) : ""]);
		$.append($$anchor, small);
	};
	const choice = ($$anchor, name = $.noop, label = $.noop, options = $.noop) => {
		var fragment = root_2();
		var span = $.first_child(fragment);
		var text_2 = $.child(span);
		var node = $.sibling(text_2);
		level(node, name);
		$.reset(span);
		var node_1 = $.sibling(span, 2);
		$.key(node_1, () => $.get(values), ($$anchor) => {
			var fieldset = root_1();
			var node_2 = $.child(fieldset);
			{
				let $0 = $.derived(() => $.get(values)[name()] ?? -1);
				let $1 = $.derived(() => options().map((text, value) => ({
					value,
					label: text
				})));
				Segmented(node_2, {
					get value() {
						return $.get($0);
					},
					get label() {
						return label();
					},
					get options() {
						return $.get($1);
					},
					onchange: (value) => void set(name(), value)
				});
			}
			$.reset(fieldset);
			$.template_effect(() => {
				fieldset.disabled = !$.get(inMdi);
				$.set_attribute(fieldset, "data-setting", name());
				$.set_attribute(fieldset, "data-value", $.get(values)[name()]);
			});
			$.append($$anchor, fieldset);
		});
		$.template_effect(() => $.set_text(text_2, `${label() ?? ""} `));
		$.append($$anchor, fragment);
	};
	const names = {
		programs: "NO54.6",
		unit: "NO0.2",
		channel: "P0",
		numbers: "NO0.5",
		step: "P210"
	};
	let values = $.state({});
	let program = $.state("");
	let ahead = $.state(null);
	let now = $.state($.proxy(Date.now()));
	const levels = $.derived(() => new Map($$props.all.flatMap((one) => [[one.name, one.level], ...one.bits.map((bit) => [bit.name, bit.level])])));
	const status = $.derived(() => machine.status);
	const stop = $.derived(() => $.get(status)?.program.stop_at ?? null);
	const inMdi = $.derived(() => $.get(status)?.mode === "mdi");
	function read() {
		machine.fetch("parameters", {
			do: "parameters",
			names: Object.values(names)
		}).then((reply) => {
			if (reply) $.set(values, reply.parameters);
		});
	}
	$.user_effect(() => {
		machine.changed("parameters");
		if (machine.link === "open") read();
	});
	$.user_effect(() => {
		if (machine.link !== "open") return;
		const asked = Date.now();
		machine.fetch("version", { do: "version" }).then((reply) => {
			if (reply) $.set(ahead, reply.time - (asked + Date.now()) / 2);
		});
	});
	$.user_effect(() => {
		const timer = setInterval(() => $.set(now, Date.now(), true), 1e3);
		return () => clearInterval(timer);
	});
	async function set(name, value) {
		if (!await machine.tell({
			do: "set_parameter",
			name,
			value
		})) $.set(values, { ...$.get(values) });
	}
	function stopAt(sequence) {
		const named = $.get(program).trim() || null;
		machine.tell(named ? {
			do: "stop_at",
			program: named,
			sequence
		} : {
			do: "stop_at",
			sequence
		});
	}
	{
		let $0 = $.derived(() => t("settings.switches"));
		Card($$anchor, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var fragment_2 = root_4();
				var div = $.first_child(fragment_2);
				var span_1 = $.child(div);
				var text_3 = $.only_child(span_1, true);
				var span_2 = $.sibling(span_1, 2);
				var node_3 = $.child(span_2);
				ParameterSwitch(node_3, {});
				$.reset(span_2);
				var node_4 = $.sibling(span_2, 2);
				{
					let $0 = $.derived(() => t("settings.program_switch"));
					let $1 = $.derived(() => [t("app.off"), t("app.on")]);
					choice(node_4, () => names.programs, () => $.get($0), () => $.get($1));
				}
				var node_5 = $.sibling(node_4, 2);
				{
					let $0 = $.derived(() => t("settings.input_unit"));
					let $1 = $.derived(() => [t("settings.metric"), t("settings.inch")]);
					choice(node_5, () => names.unit, () => $.get($0), () => $.get($1));
				}
				var p = $.sibling(node_5, 2);
				var text_4 = $.only_child(p, true);
				var node_6 = $.sibling(p, 2);
				{
					let $0 = $.derived(() => t("settings.channel"));
					choice(node_6, () => names.channel, () => $.get($0), () => [
						"RS232 Xon/Xoff",
						"RS232 XModem",
						"USB"
					]);
				}
				var p_1 = $.sibling(node_6, 2);
				var text_5 = $.only_child(p_1, true);
				var node_7 = $.sibling(p_1, 2);
				{
					let $0 = $.derived(() => t("settings.sequence"));
					let $1 = $.derived(() => [t("app.off"), t("app.on")]);
					choice(node_7, () => names.numbers, () => $.get($0), () => $.get($1));
				}
				var span_3 = $.sibling(node_7, 2);
				var text_6 = $.child(span_3);
				var node_8 = $.sibling(text_6);
				level(node_8, () => names.step);
				$.reset(span_3);
				var span_4 = $.sibling(span_3, 2);
				var node_9 = $.child(span_4);
				{
					let $0 = $.derived(() => $.get(values)[names.step] ?? null);
					let $1 = $.derived(() => !$.get(inMdi));
					let $2 = $.derived(() => t("settings.increment"));
					NumberField(node_9, {
						get value() {
							return $.get($0);
						},
						whole: true,
						minimum: 0,
						maximum: 1e3,
						get disabled() {
							return $.get($1);
						},
						get label() {
							return $.get($2);
						},
						onvalue: (value) => void set(names.step, value ?? 0)
					});
				}
				$.reset(span_4);
				var span_5 = $.sibling(span_4, 2);
				var text_7 = $.only_child(span_5, true);
				var span_6 = $.sibling(span_5, 2);
				var input = $.child(span_6);
				$.remove_input_defaults(input);
				var span_7 = $.sibling(input, 2);
				var node_10 = $.child(span_7);
				{
					let $0 = $.derived(() => $.get(stop)?.sequence ?? null);
					let $1 = $.derived(() => t("settings.stop"));
					NumberField(node_10, {
						get value() {
							return $.get($0);
						},
						whole: true,
						minimum: 0,
						maximum: 99999,
						empty: true,
						unit: "N",
						get label() {
							return $.get($1);
						},
						onvalue: stopAt
					});
				}
				$.reset(span_7);
				var span_8 = $.sibling(span_7, 2);
				var text_8 = $.only_child(span_8, true);
				var node_11 = $.sibling(span_8, 2);
				var consequent = ($$anchor) => {
					{
						let $0 = $.derived(() => t("app.delete"));
						Button($$anchor, {
							icon: "close",
							get "aria-label"() {
								return $.get($0);
							},
							onclick: () => stopAt(null)
						});
					}
				};
				$.if(node_11, ($$render) => {
					if ($.get(stop)) $$render(consequent);
				});
				$.reset(span_6);
				var span_9 = $.sibling(span_6, 2);
				var text_9 = $.only_child(span_9, true);
				var span_10 = $.sibling(span_9, 2);
				var time = $.child(span_10);
				var text_10 = $.only_child(time, true);
				var small_1 = $.sibling(time, 2);
				var text_11 = $.only_child(small_1, true);
				$.reset(span_10);
				$.reset(div);
				var node_12 = $.sibling(div, 2);
				var consequent_1 = ($$anchor) => {
					var p_2 = root_3();
					var text_12 = $.only_child(p_2, true);
					$.template_effect(($0) => $.set_text(text_12, $0), [() => t("settings.in_mdi")]);
					$.append($$anchor, p_2);
				};
				$.if(node_12, ($$render) => {
					if (!$.get(inMdi)) $$render(consequent_1);
				});
				$.template_effect(($0, $1, $2, $3, $4, $5, $6, $7, $8, $9) => {
					$.set_text(text_3, $0);
					$.set_text(text_4, $1);
					$.set_text(text_5, $2);
					$.set_text(text_6, `${$3 ?? ""} `);
					$.set_attribute(span_4, "data-setting", names.step);
					$.set_text(text_7, $4);
					$.set_attribute(input, "aria-label", $5);
					$.set_attribute(input, "placeholder", $.get(status)?.program.selected ?? "O0001");
					$.set_text(text_8, $.get(stop) ? `${$.get(stop).program ?? ""} N${$.get(stop).sequence}` : "–");
					$.set_text(text_9, $6);
					$.set_attribute(time, "datetime", $7);
					$.set_text(text_10, $8);
					$.set_text(text_11, $9);
				}, [
					() => t("offsets.switch"),
					() => t("settings.unit_text"),
					() => t("settings.channel_text"),
					() => t("settings.increment"),
					() => t("settings.stop"),
					() => t("program.title"),
					() => t("settings.clock"),
					() => $.get(ahead) === null ? "" : new Date($.get(now) + $.get(ahead)).toISOString(),
					() => $.get(ahead) === null ? "" : moment($.get(now) + $.get(ahead)),
					() => t("settings.clock_text")
				]);
				$.bind_value(input, () => $.get(program), ($$value) => $.set(program, $$value));
				$.append($$anchor, fragment_2);
			},
			$$slots: { default: true }
		});
	}
	$.pop();
}
export { Switches as default };
