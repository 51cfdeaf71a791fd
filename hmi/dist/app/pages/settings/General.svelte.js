import { http } from "../../lib/api/http.js";
import { language, t } from "../../lib/i18n/index.svelte.js";
import { duration } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import { go } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Switches from "./Switches.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/settings/General.svelte
var root = $.from_html(`<dl class="s-t73axo"><dt class="s-t73axo"> </dt><dd class="s-t73axo"> </dd> <dt class="s-t73axo"> </dt><dd class="code s-t73axo"> </dd> <dt class="s-t73axo"> </dt><dd class="s-t73axo"> </dd> <dt class="s-t73axo"> </dt><dd class="number s-t73axo"> </dd> <dt class="s-t73axo"> </dt><dd class="number s-t73axo"> </dd> <dt class="s-t73axo"> </dt><dd class="number s-t73axo"> </dd></dl>`);
var root_1 = $.from_html(`<div class="long s-t73axo"><!></div>`);
var root_2 = $.from_html(`<tr><th class="code"> </th><td> </td><td class="right number"> <small class="muted"> </small></td><td><!></td></tr>`);
var root_3 = $.from_html(`<table class="table"><tbody></tbody></table>`);
var root_4 = $.from_html(`<div class="grid s-t73axo"><!> <!> <!></div>`);
function General($$anchor, $$props) {
	$.push($$props, true);
	let all = $.state([]);
	let values = $.state({});
	/** What people set most often beside the switches, of the GSK990MC: speeds of dry run, jog and rapid, times. */
	const wanted = [
		"P86",
		"P93",
		"P98",
		"P242",
		"P258",
		"P202"
	];
	const shown = $.derived(() => $.get(all).filter((one) => wanted.includes(one.name)));
	$.user_effect(() => {
		http.parameters(language()).then((now) => $.set(all, now), (failed) => machine.refused(failed));
	});
	$.user_effect(() => {
		machine.changed("parameters");
		const names = $.get(shown).map((one) => one.name);
		if (machine.link !== "open" || names.length === 0) return;
		machine.fetch("parameters", {
			do: "parameters",
			names
		}).then((reply) => {
			if (reply) $.set(values, reply.parameters);
		});
	});
	var div = root_4();
	var node = $.child(div);
	{
		let $0 = $.derived(() => t("settings.machine"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var dl = root();
				var dt = $.child(dl);
				var text = $.only_child(dt, true);
				var dd = $.sibling(dt);
				var text_1 = $.only_child(dd, true);
				var dt_1 = $.sibling(dd, 2);
				var text_2 = $.only_child(dt_1, true);
				var dd_1 = $.sibling(dt_1);
				var text_3 = $.only_child(dd_1, true);
				var dt_2 = $.sibling(dd_1, 2);
				var text_4 = $.only_child(dt_2, true);
				var dd_2 = $.sibling(dt_2);
				var text_5 = $.only_child(dd_2, true);
				var dt_3 = $.sibling(dd_2, 2);
				var text_6 = $.only_child(dt_3, true);
				var dd_3 = $.sibling(dt_3);
				var text_7 = $.only_child(dd_3);
				var dt_4 = $.sibling(dd_3, 2);
				var text_8 = $.only_child(dt_4, true);
				var dd_4 = $.sibling(dt_4);
				var text_9 = $.only_child(dd_4, true);
				var dt_5 = $.sibling(dd_4, 2);
				var text_10 = $.only_child(dt_5, true);
				var dd_5 = $.sibling(dt_5);
				var text_11 = $.only_child(dd_5, true);
				$.reset(dl);
				$.template_effect(($0, $1, $2, $3, $4, $5, $6, $7, $8) => {
					$.set_text(text, $0);
					$.set_text(text_1, machine.version?.machine);
					$.set_text(text_2, $1);
					$.set_text(text_3, machine.version?.dialect);
					$.set_text(text_4, $2);
					$.set_text(text_5, $3);
					$.set_text(text_6, $4);
					$.set_text(text_7, `${machine.version?.period_ms ?? ""} ${$5 ?? ""}`);
					$.set_text(text_8, $6);
					$.set_text(text_9, machine.version?.software);
					$.set_text(text_10, $7);
					$.set_text(text_11, $8);
				}, [
					() => t("settings.name"),
					() => t("settings.dialect"),
					() => t("settings.axes"),
					() => machine.axes.join(" "),
					() => t("settings.period"),
					() => t("unit.ms"),
					() => t("settings.software"),
					() => t("position.power_on_time"),
					() => duration(machine.status?.counters.power_on_time ?? 0)
				]);
				$.append($$anchor, dl);
			},
			$$slots: { default: true }
		});
	}
	var node_1 = $.sibling(node, 2);
	var consequent = ($$anchor) => {
		var div_1 = root_1();
		var node_2 = $.child(div_1);
		Switches(node_2, { get all() {
			return $.get(all);
		} });
		$.reset(div_1);
		$.append($$anchor, div_1);
	};
	$.if(node_1, ($$render) => {
		if (machine.status && machine.status.switches.programs !== null) $$render(consequent);
	});
	var node_3 = $.sibling(node_1, 2);
	var consequent_1 = ($$anchor) => {
		{
			let $0 = $.derived(() => t("settings.often"));
			Card($$anchor, {
				get title() {
					return $.get($0);
				},
				flush: true,
				children: ($$anchor, $$slotProps) => {
					var table = root_3();
					var tbody = $.child(table);
					$.each(tbody, 21, () => $.get(shown), (one) => one.name, ($$anchor, one) => {
						var tr = root_2();
						var th = $.child(tr);
						var text_12 = $.only_child(th, true);
						var td = $.sibling(th);
						var text_13 = $.only_child(td, true);
						var td_1 = $.sibling(td);
						var text_14 = $.child(td_1);
						var small = $.sibling(text_14);
						var text_15 = $.only_child(small, true);
						$.reset(td_1);
						var td_2 = $.sibling(td_1);
						var node_4 = $.child(td_2);
						Button(node_4, {
							icon: "edit",
							get "aria-label"() {
								return $.get(one).name;
							},
							onclick: () => go("offsets", "parameters", $.get(one).name)
						});
						$.reset(td_2);
						$.reset(tr);
						$.template_effect(() => {
							$.set_text(text_12, $.get(one).name);
							$.set_text(text_13, $.get(one).meaning);
							$.set_text(text_14, `${$.get(values)[$.get(one).name] ?? $.get(one).standard ?? ""} `);
							$.set_text(text_15, $.get(one).unit);
						});
						$.append($$anchor, tr);
					});
					$.reset(tbody);
					$.reset(table);
					$.append($$anchor, table);
				},
				$$slots: { default: true }
			});
		}
	};
	$.if(node_3, ($$render) => {
		if ($.get(shown).length) $$render(consequent_1);
	});
	$.reset(div);
	$.append($$anchor, div);
	$.pop();
}
export { General as default };
