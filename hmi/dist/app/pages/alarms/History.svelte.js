import { moment, t } from "../../lib/i18n/index.svelte.js";
import { pastText } from "../../lib/state/alarm-texts.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Listed from "./Listed.svelte.js";
import Older from "./Older.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/alarms/History.svelte
var root = $.from_html(`<p class="muted s-1mgorka"> </p>`);
var root_1 = $.from_html(`<tr><td class="muted time"> </td><td class="code"> </td><td> <!></td><td class="code muted"> </td></tr>`);
function History($$anchor, $$props) {
	$.push($$props, true);
	let alarms = $.state([]);
	let known = $.state(false);
	const STEP = 200;
	let most = $.state(STEP);
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
		const rows = ($$anchor) => {
			var fragment_1 = $.comment();
			var node = $.first_child(fragment_1);
			$.each(node, 17, () => $.get(alarms), $.index, ($$anchor, alarm) => {
				const about = $.derived(() => pastText($.get(alarm)));
				var tr = root_1();
				var td = $.child(tr);
				var text = $.only_child(td, true);
				var td_1 = $.sibling(td);
				var text_1 = $.only_child(td_1, true);
				var td_2 = $.sibling(td_1);
				var text_2 = $.child(td_2, true);
				var node_1 = $.sibling(text_2);
				var consequent = ($$anchor) => {
					var p = root();
					var text_3 = $.only_child(p, true);
					$.template_effect(() => $.set_text(text_3, $.get(about).help));
					$.append($$anchor, p);
				};
				$.if(node_1, ($$render) => {
					if ($.get(about).help) $$render(consequent);
				});
				$.reset(td_2);
				var td_3 = $.sibling(td_2);
				var text_4 = $.only_child(td_3);
				$.reset(tr);
				$.template_effect(($0) => {
					$.set_text(text, $0);
					$.set_text(text_1, $.get(alarm).id);
					$.set_text(text_2, $.get(about).text);
					$.set_text(text_4, `${$.get(alarm).program ?? ""}${$.get(alarm).line ? `:${$.get(alarm).line}` : ""}`);
				}, [() => moment($.get(alarm).time)]);
				$.append($$anchor, tr);
			});
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("alarms.history"));
		let $1 = $.derived(() => [
			t("alarms.time"),
			t("alarms.number"),
			t("alarms.text"),
			t("alarms.program")
		]);
		let $2 = $.derived(() => $.get(known) ? {
			title: t("alarms.none_past"),
			text: t("alarms.none_past_text")
		} : void 0);
		Listed($$anchor, {
			get title() {
				return $.get($0);
			},
			get heads() {
				return $.get($1);
			},
			get count() {
				return $.get(alarms).length;
			},
			clear: () => machine.tell({ do: "clear_alarm_history" }).then(read),
			get none() {
				return $.get($2);
			},
			id: "past",
			rows,
			children: ($$anchor, $$slotProps) => {
				Older($$anchor, {
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
			},
			$$slots: {
				rows: true,
				default: true
			}
		});
	}
	$.pop();
}
export { History as default };
