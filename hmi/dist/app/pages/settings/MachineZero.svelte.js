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
var root_1 = $.from_html(`<p class="need" data-need="none"> </p>`);
var root_2 = $.from_html(`<a class="s-ns3zhx"></a>`);
var root_3 = $.from_html(`<p class="need s-ns3zhx"> <!></p>`);
var root_4 = $.from_html(`<div class="form s-ns3zhx"><p class="muted"> </p> <table class="table" data-testid="machine-zero"><thead><tr><th> </th><th class="right"> </th><th class="right"> </th><th> </th></tr></thead><tbody></tbody></table> <!> <!> <div class="row wrap"><!> <!></div></div>`);
var root_5 = $.from_html(`<!> <!>`, 1);
var root_6 = $.from_html(`<p> </p>`);
function MachineZero($$anchor, $$props) {
	$.push($$props, true);
	/** That machine zero may be set by hand. */
	const ALLOWED = "NO20.7";
	const LEVEL = 3;
	let allowed = $.state(false);
	/** Controls of other dialects have no such parameter, and no machine zero by hand. */
	let lacks = $.state(false);
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
	$.user_effect(() => followParameters([ALLOWED], (values) => {
		$.set(allowed, values[ALLOWED] === 1);
		$.set(lacks, !(ALLOWED in values));
	}));
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
	var fragment = root_5();
	var node = $.first_child(fragment);
	{
		let $0 = $.derived(() => t("settings.machine_zero"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div = root_4();
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
				var consequent = ($$anchor) => {
					var p_1 = root_1();
					var text_9 = $.only_child(p_1, true);
					$.template_effect(($0) => $.set_text(text_9, $0), [() => t("settings.machine_zero_none")]);
					$.append($$anchor, p_1);
				};
				$.if(node_2, ($$render) => {
					if ($.get(lacks)) $$render(consequent);
				});
				var node_3 = $.sibling(node_2, 2);
				$.each(node_3, 17, () => $.get(needs), (need) => need.id, ($$anchor, need) => {
					var fragment_2 = $.comment();
					var node_4 = $.first_child(fragment_2);
					var consequent_2 = ($$anchor) => {
						var p_2 = root_3();
						var text_10 = $.child(p_2);
						var node_5 = $.sibling(text_10);
						var consequent_1 = ($$anchor) => {
							var a = root_2();
							a.textContent = "NO20.7";
							$.template_effect(($0) => $.set_attribute(a, "href", $0), [() => href("offsets", "parameters", "NO20")]);
							$.append($$anchor, a);
						};
						$.if(node_5, ($$render) => {
							if ($.get(need).id === "allowed") $$render(consequent_1);
						});
						$.reset(p_2);
						$.template_effect(() => {
							$.set_attribute(p_2, "data-need", $.get(need).id);
							$.set_text(text_10, `${$.get(need).text ?? ""} `);
						});
						$.append($$anchor, p_2);
					};
					$.if(node_4, ($$render) => {
						if (!$.get(need).is && !$.get(lacks)) $$render(consequent_2);
					});
					$.append($$anchor, fragment_2);
				});
				var div_1 = $.sibling(node_3, 2);
				var node_6 = $.child(div_1);
				var consequent_3 = ($$anchor) => {
					ParameterSwitch($$anchor, {});
				};
				$.if(node_6, ($$render) => {
					if (!$.get(lacks)) $$render(consequent_3);
				});
				var node_7 = $.sibling(node_6, 2);
				{
					let $0 = $.derived(() => !$.get(may));
					Button(node_7, {
						kind: "danger",
						icon: "target",
						get disabled() {
							return $.get($0);
						},
						onclick: () => $.set(asking, true),
						"data-testid": "set-machine-zero",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_11 = $.text();
							$.template_effect(($0) => $.set_text(text_11, $0), [() => t("settings.machine_zero_set")]);
							$.append($$anchor, text_11);
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
	var node_8 = $.sibling(node, 2);
	{
		const actions = ($$anchor) => {
			var fragment_5 = root_5();
			var node_9 = $.first_child(fragment_5);
			Button(node_9, {
				onclick: () => $.set(asking, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_12 = $.text();
					$.template_effect(($0) => $.set_text(text_12, $0), [() => t("app.cancel")]);
					$.append($$anchor, text_12);
				},
				$$slots: { default: true }
			});
			var node_10 = $.sibling(node_9, 2);
			Button(node_10, {
				kind: "danger",
				onclick: () => void set(),
				"data-testid": "set-machine-zero-go",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_13 = $.text();
					$.template_effect(($0) => $.set_text(text_13, $0), [() => t("settings.machine_zero_set")]);
					$.append($$anchor, text_13);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_5);
		};
		let $0 = $.derived(() => t("settings.machine_zero_ask", { axes: $.get(chosen).join(" ") }));
		Dialog(node_8, {
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
				var p_3 = root_6();
				var text_14 = $.only_child(p_3, true);
				$.template_effect(($0) => $.set_text(text_14, $0), [() => t("settings.machine_zero_warning")]);
				$.append($$anchor, p_3);
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
