import { moment, t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import { alarmText } from "../../lib/state/alarm-texts.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Older from "./Older.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/alarms/History.svelte
var root = $.from_html(`<p class="muted s-10tehwv"> </p>`);
var root_1 = $.from_html(`<tr><td class="muted time s-10tehwv"> </td><td class="code"> </td><td> <!></td><td class="code muted"> </td></tr>`);
var root_2 = $.from_html(`<table class="table"><thead><tr><th> </th><th> </th><th> </th><th> </th></tr></thead><tbody></tbody></table> <!>`, 1);
function History($$anchor, $$props) {
	$.push($$props, true);
	let alarms = $.state([]);
	let known = $.state(false);
	const STEP = 200;
	let most = $.state(STEP);
	const level = $.derived(() => machine.level);
	async function read() {
		const reply = await machine.fetch("alarm_history", {
			do: "alarm_history",
			most: $.get(most)
		});
		if (!reply) return;
		$.set(alarms, reply.alarms);
		$.set(known, true);
	}
	$.user_effect(() => {
		machine.changed("alarms");
		machine.status?.alarms.length;
		$.get(most);
		if (machine.link === "open") read();
	});
	{
		const actions = ($$anchor) => {
			{
				let $0 = $.derived(() => $.get(level) > 3 || $.get(alarms).length === 0);
				let $1 = $.derived(() => t("alarms.clear_right"));
				Button($$anchor, {
					kind: "danger",
					icon: "trash",
					get disabled() {
						return $.get($0);
					},
					get title() {
						return $.get($1);
					},
					onclick: () => void machine.tell({ do: "clear_alarm_history" }).then(() => read()),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text = $.text();
						$.template_effect(($0) => $.set_text(text, $0), [() => t("alarms.clear")]);
						$.append($$anchor, text);
					},
					$$slots: { default: true }
				});
			}
		};
		let $0 = $.derived(() => t("alarms.history"));
		Card($$anchor, {
			get title() {
				return $.get($0);
			},
			fill: true,
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_3 = $.comment();
				var node = $.first_child(fragment_3);
				var consequent = ($$anchor) => {
					{
						let $0 = $.derived(() => t("alarms.none_past"));
						let $1 = $.derived(() => t("alarms.none_past_text"));
						Empty($$anchor, {
							icon: "alarms",
							get title() {
								return $.get($0);
							},
							get text() {
								return $.get($1);
							}
						});
					}
				};
				var alternate = ($$anchor) => {
					var fragment_5 = root_2();
					var table = $.first_child(fragment_5);
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
					$.each(tbody, 21, () => $.get(alarms), $.index, ($$anchor, alarm) => {
						const about = $.derived(() => alarmText($.get(alarm)));
						var tr_1 = root_1();
						var td = $.child(tr_1);
						var text_5 = $.only_child(td, true);
						var td_1 = $.sibling(td);
						var text_6 = $.only_child(td_1, true);
						var td_2 = $.sibling(td_1);
						var text_7 = $.child(td_2, true);
						var node_1 = $.sibling(text_7);
						var consequent_1 = ($$anchor) => {
							var p = root();
							var text_8 = $.only_child(p, true);
							$.template_effect(() => $.set_text(text_8, $.get(about).help));
							$.append($$anchor, p);
						};
						$.if(node_1, ($$render) => {
							if ($.get(about).help) $$render(consequent_1);
						});
						$.reset(td_2);
						var td_3 = $.sibling(td_2);
						var text_9 = $.only_child(td_3);
						$.reset(tr_1);
						$.template_effect(($0) => {
							$.set_text(text_5, $0);
							$.set_text(text_6, $.get(alarm).id);
							$.set_text(text_7, $.get(about).text);
							$.set_text(text_9, `${$.get(alarm).program ?? ""}${$.get(alarm).line ? `:${$.get(alarm).line}` : ""}`);
						}, [() => moment($.get(alarm).time)]);
						$.append($$anchor, tr_1);
					});
					$.reset(tbody);
					$.reset(table);
					var node_2 = $.sibling(table, 2);
					Older(node_2, {
						get count() {
							return $.get(alarms).length;
						},
						step: STEP,
						last: 1e3,
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
						() => t("alarms.number"),
						() => t("alarms.text"),
						() => t("alarms.program")
					]);
					$.append($$anchor, fragment_5);
				};
				$.if(node, ($$render) => {
					if ($.get(known) && $.get(alarms).length === 0) $$render(consequent);
					else $$render(alternate, -1);
				});
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
export { History as default };
