import { number, t } from "../../lib/i18n/index.svelte.js";
import { headOf, readLadder } from "../../lib/ladder/ladder.js";
import Card from "../../lib/parts/Card.svelte.js";
import { go } from "../../lib/routing.svelte.js";
import { again, followParameters } from "../../lib/state/again.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/plc/Info.svelte
var list = ($$anchor, rows = $.noop) => {
	var table = root_1();
	var tbody = $.child(table);
	$.each(tbody, 21, rows, ([key, value]) => key, ($$anchor, $$item) => {
		var $$array = $.derived(() => $.to_array($.get($$item), 2));
		let key = () => $.get($$array)[0];
		let value = () => $.get($$array)[1];
		var tr = root();
		var th = $.child(tr);
		var text_1 = $.only_child(th, true);
		var td = $.sibling(th);
		var text_2 = $.only_child(td, true);
		$.reset(tr);
		$.template_effect(($0) => {
			$.set_attribute(tr, "data-fact", key());
			$.set_text(text_1, $0);
			$.set_text(text_2, value());
		}, [() => t(key())]);
		$.append($$anchor, tr);
	});
	$.reset(tbody);
	$.reset(table);
	$.append($$anchor, table);
};
var root = $.from_html(`<tr><th scope="row"> </th><td class="s-1meldeo"> </td></tr>`);
var root_1 = $.from_html(`<table class="table"><tbody></tbody></table>`);
var root_2 = $.from_html(`<tr><th scope="row"><span class="code"> </span></th><td class="muted s-1meldeo"> </td><td class="number right s-1meldeo"> </td></tr>`);
var root_3 = $.from_html(`<div class="grid s-1meldeo" data-testid="plc-info"><!> <!> <!></div>`);
function Info($$anchor, $$props) {
	$.push($$props, true);
	/** Whether the version of the software is shown; controls that have no such parameter show it. */
	const SHOWS_VERSION = "NO53.7";
	const areas = [
		"X",
		"Y",
		"F",
		"G",
		"R",
		"K",
		"T",
		"C",
		"D",
		"A"
	];
	let text = $.state("");
	let steps = $.state(null);
	let timing = $.state(null);
	let showsVersion = $.state(true);
	const ladder = $.derived(() => readLadder($.get(text)));
	const named = $.derived(() => {
		const addresses = [...$.get(ladder).symbols.values()].map((one) => one.address);
		return areas.map((area) => ({
			area,
			count: addresses.filter((address) => address.startsWith(area)).length
		}));
	});
	const facts = $.derived(() => [
		["plc.info_name", headOf($.get(text))],
		...$.get(showsVersion) ? [["plc.info_version", machine.version?.software ?? ""]] : [],
		["plc.info_rungs", number($.get(ladder).rungs.length)],
		["plc.info_instructions", number($.get(ladder).instructions)],
		["plc.info_steps", $.get(steps) === null ? "–" : number($.get(steps))]
	]);
	const times = $.derived(() => $.get(timing) ? [
		["diagnosis.level_1", `${number($.get(timing).worst_level_1_us)} ${t("unit.us")}`],
		["diagnosis.level_2", `${number($.get(timing).worst_level_2_us)} ${t("unit.us")}`],
		["plc.info_scan", `${number($.get(timing).level_2_periods * $.get(timing).period_us / 1e3)} ${t("unit.ms")}`]
	] : []);
	$.user_effect(() => {
		machine.changed("ladder");
		if (machine.link !== "open") return;
		machine.fetch("text", { do: "ladder" }).then(async (reply) => {
			if (!reply) return;
			$.set(text, reply.text, true);
			$.set(steps, (await machine.fetch("ladder_checked", {
				do: "check_ladder",
				text: $.get(text)
			}))?.steps ?? null, true);
		});
	});
	$.user_effect(() => followParameters([SHOWS_VERSION], (values) => $.set(showsVersion, values[SHOWS_VERSION] !== 0)));
	$.user_effect(() => again(1e3, async (wanted) => {
		const reply = await machine.ask({
			do: "timing",
			forget: false
		}).catch(() => null);
		if (wanted() && reply?.reply === "timing") $.set(timing, reply);
	}));
	var div = root_3();
	var node = $.child(div);
	{
		let $0 = $.derived(() => t("plc.info_ladder"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			flush: true,
			children: ($$anchor, $$slotProps) => {
				list($$anchor, () => $.get(facts));
			},
			$$slots: { default: true }
		});
	}
	var node_1 = $.sibling(node, 2);
	{
		let $0 = $.derived(() => t("plc.info_times"));
		Card(node_1, {
			get title() {
				return $.get($0);
			},
			flush: true,
			children: ($$anchor, $$slotProps) => {
				list($$anchor, () => $.get(times));
			},
			$$slots: { default: true }
		});
	}
	var node_2 = $.sibling(node_1, 2);
	{
		const actions = ($$anchor) => {
			Button($$anchor, {
				icon: "diagnosis",
				onclick: () => go("diagnosis", "bytes"),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_3 = $.text();
					$.template_effect(($0) => $.set_text(text_3, $0), [() => t("diagnosis.bytes")]);
					$.append($$anchor, text_3);
				},
				$$slots: { default: true }
			});
		};
		let $0 = $.derived(() => t("plc.info_signals"));
		Card(node_2, {
			get title() {
				return $.get($0);
			},
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var table_1 = root_1();
				var tbody_1 = $.child(table_1);
				$.each(tbody_1, 21, () => $.get(named), ({ area, count }) => area, ($$anchor, $$item) => {
					let area = () => $.get($$item).area;
					let count = () => $.get($$item).count;
					var tr_1 = root_2();
					var th_1 = $.child(tr_1);
					var span = $.child(th_1);
					var text_4 = $.only_child(span, true);
					$.reset(th_1);
					var td_1 = $.sibling(th_1);
					var text_5 = $.only_child(td_1, true);
					var td_2 = $.sibling(td_1);
					var text_6 = $.only_child(td_2, true);
					$.reset(tr_1);
					$.template_effect(($0, $1) => {
						$.set_attribute(tr_1, "data-area", area());
						$.set_text(text_4, area());
						$.set_text(text_5, $0);
						$.set_text(text_6, $1);
					}, [() => t(`plc.info_area_${area()}`), () => number(count())]);
					$.append($$anchor, tr_1);
				});
				$.reset(tbody_1);
				$.reset(table_1);
				$.append($$anchor, table_1);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.reset(div);
	$.append($$anchor, div);
	$.pop();
}
export { Info as default };
