import { has, moment, t } from "../../lib/i18n/index.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Listed from "./Listed.svelte.js";
import Older from "./Older.svelte.js";
import { logged } from "./logged.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/alarms/Log.svelte
var root = $.from_html(`<input type="search"/>`);
var root_1 = $.from_html(`<span class="muted number"> </span>`);
var root_2 = $.from_html(`<span class="muted"> </span>`);
var root_3 = $.from_html(`<tr><td class="muted time s-v3wjz1"> </td><td class="s-v3wjz1"> <!></td><td class="s-v3wjz1"> <span class="code"> </span></td><td class="number s-v3wjz1"><!> </td></tr>`);
function Log($$anchor, $$props) {
	$.push($$props, true);
	let entries = $.state([]);
	let sought = $.state("");
	const STEP = 500;
	let most = $.state(STEP);
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
		const tools = ($$anchor) => {
			var input = root();
			$.remove_input_defaults(input);
			$.template_effect(($0, $1) => {
				$.set_attribute(input, "placeholder", $0);
				$.set_attribute(input, "aria-label", $1);
			}, [() => t("app.search"), () => t("app.search")]);
			$.bind_value(input, () => $.get(sought), ($$value) => $.set(sought, $$value));
			$.append($$anchor, input);
		};
		const rows = ($$anchor) => {
			var fragment_1 = $.comment();
			var node = $.first_child(fragment_1);
			$.each(node, 17, () => $.get(shown), $.index, ($$anchor, entry) => {
				var tr = root_3();
				var td = $.child(tr);
				var text = $.only_child(td, true);
				var td_1 = $.sibling(td);
				var text_1 = $.child(td_1, true);
				var node_1 = $.sibling(text_1);
				var consequent = ($$anchor) => {
					var span = root_1();
					var text_2 = $.only_child(span);
					$.template_effect(() => $.set_text(text_2, ` · ${$.get(entry).level ?? ""}`));
					$.append($$anchor, span);
				};
				$.if(node_1, ($$render) => {
					if ($.get(entry).level !== null) $$render(consequent);
				});
				$.reset(td_1);
				var td_2 = $.sibling(td_1);
				var text_3 = $.child(td_2);
				var span_1 = $.sibling(text_3);
				var text_4 = $.only_child(span_1, true);
				$.reset(td_2);
				var td_3 = $.sibling(td_2);
				var node_2 = $.child(td_3);
				var consequent_1 = ($$anchor) => {
					var span_2 = root_2();
					var text_5 = $.only_child(span_2);
					$.template_effect(() => $.set_text(text_5, `${$.get(entry).from ?? ""} → `));
					$.append($$anchor, span_2);
				};
				$.if(node_2, ($$render) => {
					if ($.get(entry).from) $$render(consequent_1);
				});
				var text_6 = $.sibling(node_2, 1, true);
				$.reset(td_3);
				$.reset(tr);
				$.template_effect(($0) => {
					$.set_text(text, $0);
					$.set_text(text_1, $.get(entry).who);
					$.set_text(text_3, `${$.get(entry).item ?? ""} `);
					$.set_text(text_4, $.get(entry).name);
					$.set_text(text_6, $.get(entry).to);
				}, [() => moment($.get(entry).time)]);
				$.append($$anchor, tr);
			});
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("alarms.log"));
		let $1 = $.derived(() => [
			t("alarms.time"),
			t("alarms.who"),
			t("alarms.what"),
			t("alarms.change")
		]);
		Listed($$anchor, {
			get title() {
				return $.get($0);
			},
			get heads() {
				return $.get($1);
			},
			get count() {
				return $.get(entries).length;
			},
			clear: () => machine.tell({ do: "clear_operation_log" }).then(read),
			id: "log",
			tools,
			rows,
			children: ($$anchor, $$slotProps) => {
				Older($$anchor, {
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
			},
			$$slots: {
				tools: true,
				rows: true,
				default: true
			}
		});
	}
	$.pop();
}
export { Log as default };
