import { t } from "../../lib/i18n/index.svelte.js";
import { fixed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Dialog from "../../lib/parts/Dialog.svelte.js";
import ParameterSwitch from "../../lib/parts/ParameterSwitch.svelte.js";
import { href } from "../../lib/routing.svelte.js";
import { followParameters } from "../../lib/state/again.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { notify } from "../../lib/state/notices.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/settings/MachineZero.svelte
var root = $.from_html(`<tr><td><!></td><td class="right"> </td><td class="right"> </td><td> </td></tr>`);
var root_1 = $.from_html(`<a class="s-ns3zhx"></a>`);
var root_2 = $.from_html(`<p class="need s-ns3zhx"> <!></p>`);
var root_3 = $.from_html(`<div class="form s-ns3zhx"><p class="muted"> </p> <table class="table" data-testid="machine-zero"><thead><tr><th> </th><th class="right"> </th><th class="right"> </th><th> </th></tr></thead><tbody></tbody></table> <!> <div class="row wrap"><!> <!></div></div>`);
var root_4 = $.from_html(`<!> <!>`, 1);
var root_5 = $.from_html(`<p> </p>`);
function MachineZero($$anchor, $$props) {
	$.push($$props, true);
	/** That machine zero may be set by hand. */
	const ALLOWED = "NO20.7";
	const LEVEL = 3;
	let allowed = $.state(false);
	/** Machine coordinates of the first reference points. */
	let reference = $.state({});
	let chosen = $.state($.proxy([]));
	let asking = $.state(false);
	const status = $.derived(() => machine.status);
	const needs = $.derived(() => [
		{
			id: "allowed",
			is: $.get(allowed),
			text: t("settings.machine_zero_allowed")
		},
		{
			id: "level",
			is: machine.level <= LEVEL,
			text: t("offsets.need", {
				level: LEVEL,
				name: t(`rights.level_${LEVEL}`)
			})
		},
		{
			id: "mdi",
			is: $.get(status)?.mode === "mdi",
			text: t("offsets.need_mdi")
		},
		{
			id: "switch",
			is: $.get(status)?.switches.parameters !== false,
			text: t("offsets.need_switch")
		}
	]);
	const may = $.derived(() => $.get(needs).every((need) => need.is) && $.get(chosen).length > 0);
	$.user_effect(() => followParameters([ALLOWED], (values) => $.set(allowed, values[ALLOWED] === 1)));
	$.user_effect(() => {
		machine.changed("reference-points");
		if (machine.link !== "open") return;
		machine.fetch("reference_points", { do: "reference_points" }).then((reply) => {
			if (reply) $.set(reference, reply.points[1] ?? {});
		});
	});
	function toggle(axis) {
		$.set(chosen, machine.axes.filter((one) => one === axis !== $.get(chosen).includes(one)), true);
	}
	async function set() {
		$.set(asking, false);
		const axes = $.get(chosen);
		if (!await machine.tell({
			do: "set_machine_zero",
			axes
		})) return;
		notify({
			kind: "done",
			title: t("settings.machine_zero_done", { axes: axes.join(" ") })
		});
		$.set(chosen, [], true);
	}
	var fragment = root_4();
	var node = $.first_child(fragment);
	{
		let $0 = $.derived(() => t("settings.machine_zero"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div = root_3();
				var p = $.child(div);
				var text = $.only_child(p, true);
				var table = $.sibling(p, 2);
				var thead = $.child(table);
				var tr = $.child(thead);
				var th = $.child(tr);
				var text_1 = $.only_child(th, true);
				var th_1 = $.sibling(th);
				var text_2 = $.only_child(th_1, true);
				var th_2 = $.sibling(th_1);
				var text_3 = $.only_child(th_2, true);
				var th_3 = $.sibling(th_2);
				var text_4 = $.only_child(th_3, true);
				$.reset(tr);
				$.reset(thead);
				var tbody = $.sibling(thead);
				$.each(tbody, 20, () => machine.axes, (axis) => axis, ($$anchor, axis) => {
					var tr_1 = root();
					var td = $.child(tr_1);
					var node_1 = $.child(td);
					{
						let $0 = $.derived(() => $.get(chosen).includes(axis));
						Button(node_1, {
							get pressed() {
								return $.get($0);
							},
							onclick: () => toggle(axis),
							children: ($$anchor, $$slotProps) => {
								$.next();
								var text_5 = $.text();
								$.template_effect(() => $.set_text(text_5, axis));
								$.append($$anchor, text_5);
							},
							$$slots: { default: true }
						});
					}
					$.reset(td);
					var td_1 = $.sibling(td);
					var text_6 = $.only_child(td_1, true);
					var td_2 = $.sibling(td_1);
					var text_7 = $.only_child(td_2, true);
					var td_3 = $.sibling(td_2);
					var text_8 = $.only_child(td_3, true);
					$.reset(tr_1);
					$.template_effect(($0, $1, $2) => {
						$.set_attribute(tr_1, "data-axis", axis);
						$.set_text(text_6, $0);
						$.set_text(text_7, $1);
						$.set_text(text_8, $2);
					}, [
						() => fixed($.get(status)?.position.machine[axis]),
						() => fixed($.get(reference)[axis] ?? 0),
						() => $.get(status)?.referenced.includes(axis) ? t("app.yes") : t("app.no")
					]);
					$.append($$anchor, tr_1);
				});
				$.reset(tbody);
				$.reset(table);
				var node_2 = $.sibling(table, 2);
				$.each(node_2, 17, () => $.get(needs), (need) => need.id, ($$anchor, need) => {
					var fragment_2 = $.comment();
					var node_3 = $.first_child(fragment_2);
					var consequent_1 = ($$anchor) => {
						var p_1 = root_2();
						var text_9 = $.child(p_1);
						var node_4 = $.sibling(text_9);
						var consequent = ($$anchor) => {
							var a = root_1();
							a.textContent = "NO20.7";
							$.template_effect(($0) => $.set_attribute(a, "href", $0), [() => href("offsets", "parameters", "NO20")]);
							$.append($$anchor, a);
						};
						$.if(node_4, ($$render) => {
							if ($.get(need).id === "allowed") $$render(consequent);
						});
						$.reset(p_1);
						$.template_effect(() => {
							$.set_attribute(p_1, "data-need", $.get(need).id);
							$.set_text(text_9, `${$.get(need).text ?? ""} `);
						});
						$.append($$anchor, p_1);
					};
					$.if(node_3, ($$render) => {
						if (!$.get(need).is) $$render(consequent_1);
					});
					$.append($$anchor, fragment_2);
				});
				var div_1 = $.sibling(node_2, 2);
				var node_5 = $.child(div_1);
				ParameterSwitch(node_5, {});
				var node_6 = $.sibling(node_5, 2);
				{
					let $0 = $.derived(() => !$.get(may));
					Button(node_6, {
						kind: "danger",
						icon: "target",
						get disabled() {
							return $.get($0);
						},
						onclick: () => $.set(asking, true),
						"data-testid": "set-machine-zero",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_10 = $.text();
							$.template_effect(($0) => $.set_text(text_10, $0), [() => t("settings.machine_zero_set")]);
							$.append($$anchor, text_10);
						},
						$$slots: { default: true }
					});
				}
				$.reset(div_1);
				$.reset(div);
				$.template_effect(($0, $1, $2, $3, $4) => {
					$.set_text(text, $0);
					$.set_text(text_1, $1);
					$.set_text(text_2, $2);
					$.set_text(text_3, $3);
					$.set_text(text_4, $4);
				}, [
					() => t("settings.machine_zero_text"),
					() => t("settings.axes"),
					() => t("settings.now"),
					() => t("settings.becomes"),
					() => t("settings.referenced")
				]);
				$.append($$anchor, div);
			},
			$$slots: { default: true }
		});
	}
	var node_7 = $.sibling(node, 2);
	{
		const actions = ($$anchor) => {
			var fragment_4 = root_4();
			var node_8 = $.first_child(fragment_4);
			Button(node_8, {
				onclick: () => $.set(asking, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_11 = $.text();
					$.template_effect(($0) => $.set_text(text_11, $0), [() => t("app.cancel")]);
					$.append($$anchor, text_11);
				},
				$$slots: { default: true }
			});
			var node_9 = $.sibling(node_8, 2);
			Button(node_9, {
				kind: "danger",
				onclick: () => void set(),
				"data-testid": "set-machine-zero-go",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_12 = $.text();
					$.template_effect(($0) => $.set_text(text_12, $0), [() => t("settings.machine_zero_set")]);
					$.append($$anchor, text_12);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_4);
		};
		let $0 = $.derived(() => t("settings.machine_zero_ask", { axes: $.get(chosen).join(" ") }));
		Dialog(node_7, {
			get title() {
				return $.get($0);
			},
			get open() {
				return $.get(asking);
			},
			set open($$value) {
				$.set(asking, $$value, true);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var p_2 = root_5();
				var text_13 = $.only_child(p_2, true);
				$.template_effect(($0) => $.set_text(text_13, $0), [() => t("settings.machine_zero_warning")]);
				$.append($$anchor, p_2);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.append($$anchor, fragment);
	$.pop();
}
export { MachineZero as default };
