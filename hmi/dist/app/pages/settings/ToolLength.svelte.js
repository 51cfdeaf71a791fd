import { moment, t } from "../../lib/i18n/index.svelte.js";
import { fixed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Labelled from "../../lib/parts/Labelled.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { notify } from "../../lib/state/notices.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/settings/ToolLength.svelte
var root = $.from_html(`<div class="form s-1prgaxy"><p class="muted"> </p> <!> <p class="number big s-1prgaxy"><span class="muted s-1prgaxy"> </span> </p> <!> <p class="number"> </p></div>`);
var root_1 = $.from_html(`<div class="form s-1prgaxy"><p class="muted"> </p> <!> <p class="number big s-1prgaxy"><span class="muted s-1prgaxy"> </span> </p> <!></div>`);
var root_2 = $.from_html(`<div class="steps s-1prgaxy"><!> <!></div>`);
function ToolLength($$anchor, $$props) {
	$.push($$props, true);
	/** Where Z stood on the reference, when by the clock and by the periods of the control, and whether Z was homed: of a control
	that was switched off since, or homed, the place may be another one. */
	const KEY = "ferrocut.reference";
	let taken = $.state(read());
	const homed = $.derived(() => machine.status?.referenced.includes("Z") ?? false);
	$.user_effect(() => {
		const status = machine.status;
		if ($.get(taken) && status && (status.periods < $.get(taken).periods || $.get(homed) !== $.get(taken).homed)) keep(null);
	});
	const reference = $.derived(() => $.get(taken)?.z ?? null);
	let block = $.state(0);
	let number = $.state(1);
	const z = $.derived(() => machine.status?.position.machine.Z ?? 0);
	const length = $.derived(() => $.get(reference) === null ? null : $.get(z) - $.get(reference) - $.get(block));
	function read() {
		try {
			const kept = JSON.parse(sessionStorage.getItem(KEY) ?? "null");
			return kept && [
				kept.z,
				kept.at,
				kept.periods
			].every(Number.isFinite) ? kept : null;
		} catch {
			return null;
		}
	}
	function keep(now) {
		$.set(taken, now);
		if (now) sessionStorage.setItem(KEY, JSON.stringify(now));
		else sessionStorage.removeItem(KEY);
	}
	function refer() {
		keep({
			z: $.get(z) - $.get(block),
			at: Date.now(),
			periods: machine.status?.periods ?? 0,
			homed: $.get(homed)
		});
	}
	async function set() {
		if ($.get(length) === null || !await machine.tell({
			do: "set_offset",
			number: $.get(number),
			length: $.get(length),
			length_wear: 0
		})) return;
		notify({
			kind: "done",
			title: t("settings.length_set", {
				number: $.get(number),
				length: fixed($.get(length))
			})
		});
		$.set(number, Math.min(256, $.get(number) + 1), true);
	}
	var div = root_2();
	var node = $.child(div);
	{
		let $0 = $.derived(() => t("settings.step_reference"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div_1 = root();
				var p = $.child(div_1);
				var text = $.only_child(p, true);
				var node_1 = $.sibling(p, 2);
				{
					let $0 = $.derived(() => t("settings.block"));
					Labelled(node_1, {
						get label() {
							return $.get($0);
						},
						children: ($$anchor, $$slotProps) => {
							{
								let $0 = $.derived(() => t("unit.mm"));
								let $1 = $.derived(() => t("settings.block"));
								NumberField($$anchor, {
									get value() {
										return $.get(block);
									},
									minimum: 0,
									get unit() {
										return $.get($0);
									},
									get label() {
										return $.get($1);
									},
									onvalue: (value) => $.set(block, value ?? 0, true)
								});
							}
						},
						$$slots: { default: true }
					});
				}
				var p_1 = $.sibling(node_1, 2);
				var span = $.child(p_1);
				var text_1 = $.only_child(span, true);
				var text_2 = $.sibling(span);
				$.reset(p_1);
				var node_2 = $.sibling(p_1, 2);
				Button(node_2, {
					icon: "target",
					onclick: refer,
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_3 = $.text();
						$.template_effect(($0) => $.set_text(text_3, $0), [() => t("settings.take_reference")]);
						$.append($$anchor, text_3);
					},
					$$slots: { default: true }
				});
				var p_2 = $.sibling(node_2, 2);
				var text_4 = $.only_child(p_2, true);
				$.reset(div_1);
				$.template_effect(($0, $1, $2, $3) => {
					$.set_text(text, $0);
					$.set_text(text_1, $1);
					$.set_text(text_2, ` ${$2 ?? ""}`);
					$.set_text(text_4, $3);
				}, [
					() => t("settings.step_reference_text"),
					() => t("settings.machine_z"),
					() => fixed($.get(z)),
					() => $.get(taken) ? t("settings.reference", {
						z: fixed($.get(taken).z),
						time: moment($.get(taken).at)
					}) : t("settings.no_reference")
				]);
				$.append($$anchor, div_1);
			},
			$$slots: { default: true }
		});
	}
	var node_3 = $.sibling(node, 2);
	{
		let $0 = $.derived(() => t("settings.step_tool"));
		Card(node_3, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div_2 = root_1();
				var p_3 = $.child(div_2);
				var text_5 = $.only_child(p_3, true);
				var node_4 = $.sibling(p_3, 2);
				{
					let $0 = $.derived(() => t("settings.offset_number"));
					Labelled(node_4, {
						get label() {
							return $.get($0);
						},
						children: ($$anchor, $$slotProps) => {
							{
								let $0 = $.derived(() => t("settings.offset_number"));
								NumberField($$anchor, {
									get value() {
										return $.get(number);
									},
									whole: true,
									minimum: 1,
									maximum: 256,
									unit: "H",
									get label() {
										return $.get($0);
									},
									onvalue: (value) => $.set(number, value ?? 1, true)
								});
							}
						},
						$$slots: { default: true }
					});
				}
				var p_4 = $.sibling(node_4, 2);
				var span_1 = $.child(p_4);
				var text_6 = $.only_child(span_1, true);
				var text_7 = $.sibling(span_1);
				$.reset(p_4);
				var node_5 = $.sibling(p_4, 2);
				{
					let $0 = $.derived(() => $.get(length) === null);
					Button(node_5, {
						kind: "primary",
						icon: "check",
						get disabled() {
							return $.get($0);
						},
						onclick: () => void set(),
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_8 = $.text();
							$.template_effect(($0) => $.set_text(text_8, $0), [() => t("settings.set_length", { number: $.get(number) })]);
							$.append($$anchor, text_8);
						},
						$$slots: { default: true }
					});
				}
				$.reset(div_2);
				$.template_effect(($0, $1, $2) => {
					$.set_text(text_5, $0);
					$.set_text(text_6, $1);
					$.set_text(text_7, ` ${$2 ?? ""}`);
				}, [
					() => t("settings.step_tool_text"),
					() => t("settings.length"),
					() => fixed($.get(length))
				]);
				$.append($$anchor, div_2);
			},
			$$slots: { default: true }
		});
	}
	$.reset(div);
	$.append($$anchor, div);
	$.pop();
}
export { ToolLength as default };
