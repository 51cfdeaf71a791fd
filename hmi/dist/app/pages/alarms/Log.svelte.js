import { has, moment, t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Older from "./Older.svelte.js";
import { logged } from "./logged.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/alarms/Log.svelte
var root = $.from_html(`<input type="search"/> <!>`, 1);
var root_1 = $.from_html(`<span class="muted number"> </span>`);
var root_2 = $.from_html(`<span class="muted"> </span>`);
var root_3 = $.from_html(`<tr><td class="muted time s-1no94ym"> </td><td class="s-1no94ym"> <!></td><td class="s-1no94ym"> <span class="code"> </span></td><td class="number s-1no94ym"><!> </td></tr>`);
var root_4 = $.from_html(`<table class="table" data-testid="log"><thead><tr><th> </th><th> </th><th> </th><th> </th></tr></thead><tbody></tbody></table> <!>`, 1);
function Log($$anchor, $$props) {
	$.push($$props, true);
	let entries = $.state([]);
	let sought = $.state("");
	const STEP = 500;
	let most = $.state(STEP);
	const level = $.derived(() => machine.level);
	const told = $.derived(() => $.get(entries).map((entry) => ({
		...entry,
		...logged(entry, {
			t,
			has
		})
	})));
	const shown = $.derived(() => $.get(told).filter(({ who, item, name, from, to }) => `${who} ${item} ${name} ${from} ${to}`.toLowerCase().includes($.get(sought).toLowerCase())));
	async function read() {
		const reply = await machine.fetch("operation_log", {
			do: "operation_log",
			most: $.get(most)
		});
		if (reply) $.set(entries, reply.entries);
	}
	$.user_effect(() => {
		machine.changed("log");
		machine.changed("parameters");
		machine.changed("offsets");
		$.get(most);
		if (machine.link === "open") read();
	});
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var input = $.first_child(fragment_1);
			$.remove_input_defaults(input);
			var node = $.sibling(input, 2);
			{
				let $0 = $.derived(() => $.get(level) > 3 || $.get(entries).length === 0);
				let $1 = $.derived(() => t("alarms.clear_right"));
				Button(node, {
					kind: "danger",
					icon: "trash",
					get disabled() {
						return $.get($0);
					},
					get title() {
						return $.get($1);
					},
					onclick: () => void machine.tell({ do: "clear_operation_log" }).then(() => read()),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text = $.text();
						$.template_effect(($0) => $.set_text(text, $0), [() => t("alarms.clear")]);
						$.append($$anchor, text);
					},
					$$slots: { default: true }
				});
			}
			$.template_effect(($0, $1) => {
				$.set_attribute(input, "placeholder", $0);
				$.set_attribute(input, "aria-label", $1);
			}, [() => t("app.search"), () => t("app.search")]);
			$.bind_value(input, () => $.get(sought), ($$value) => $.set(sought, $$value));
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("alarms.log"));
		Card($$anchor, {
			get title() {
				return $.get($0);
			},
			fill: true,
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_3 = root_4();
				var table = $.first_child(fragment_3);
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
				$.each(tbody, 21, () => $.get(shown), $.index, ($$anchor, entry) => {
					var tr_1 = root_3();
					var td = $.child(tr_1);
					var text_5 = $.only_child(td, true);
					var td_1 = $.sibling(td);
					var text_6 = $.child(td_1, true);
					var node_1 = $.sibling(text_6);
					var consequent = ($$anchor) => {
						var span = root_1();
						var text_7 = $.only_child(span);
						$.template_effect(() => $.set_text(text_7, ` · ${$.get(entry).level ?? ""}`));
						$.append($$anchor, span);
					};
					$.if(node_1, ($$render) => {
						if ($.get(entry).level !== null) $$render(consequent);
					});
					$.reset(td_1);
					var td_2 = $.sibling(td_1);
					var text_8 = $.child(td_2);
					var span_1 = $.sibling(text_8);
					var text_9 = $.only_child(span_1, true);
					$.reset(td_2);
					var td_3 = $.sibling(td_2);
					var node_2 = $.child(td_3);
					var consequent_1 = ($$anchor) => {
						var span_2 = root_2();
						var text_10 = $.only_child(span_2);
						$.template_effect(() => $.set_text(text_10, `${$.get(entry).from ?? ""} → `));
						$.append($$anchor, span_2);
					};
					$.if(node_2, ($$render) => {
						if ($.get(entry).from) $$render(consequent_1);
					});
					var text_11 = $.sibling(node_2, 1, true);
					$.reset(td_3);
					$.reset(tr_1);
					$.template_effect(($0) => {
						$.set_text(text_5, $0);
						$.set_text(text_6, $.get(entry).who);
						$.set_text(text_8, `${$.get(entry).item ?? ""} `);
						$.set_text(text_9, $.get(entry).name);
						$.set_text(text_11, $.get(entry).to);
					}, [() => moment($.get(entry).time)]);
					$.append($$anchor, tr_1);
				});
				$.reset(tbody);
				$.reset(table);
				var node_3 = $.sibling(table, 2);
				Older(node_3, {
					get count() {
						return $.get(entries).length;
					},
					step: STEP,
					last: 1e4,
					get most() {
						return $.get(most);
					},
					set most($$value) {
						$.set(most, $$value, true);
					}
				});
				$.template_effect(($0, $1, $2, $3) => {
					$.set_text(text_1, $0);
					$.set_text(text_2, $1);
					$.set_text(text_3, $2);
					$.set_text(text_4, $3);
				}, [
					() => t("alarms.time"),
					() => t("alarms.who"),
					() => t("alarms.what"),
					() => t("alarms.change")
				]);
				$.append($$anchor, fragment_3);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.pop();
}
export { Log as default };
