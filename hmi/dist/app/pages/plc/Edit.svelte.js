import { http } from "../../lib/api/http.js";
import { Refused } from "../../lib/api/socket.js";
import { language, t } from "../../lib/i18n/index.svelte.js";
import Editor from "../../lib/editor/Editor.svelte.js";
import Findings from "../../lib/editor/Findings.svelte.js";
import KeypadSwitch from "../../lib/editor/KeypadSwitch.svelte.js";
import { readLadder } from "../../lib/ladder/ladder.js";
import Button from "../../lib/parts/Button.svelte.js";
import Dialog from "../../lib/parts/Dialog.svelte.js";
import { alarmText } from "../../lib/state/alarm-texts.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { notify } from "../../lib/state/notices.svelte.js";
import { untrack } from "svelte";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/plc/Edit.svelte
var root = $.from_html(`<span class="need s-iyog2j"> </span>`);
var root_1 = $.from_html(`<!> <!>`, 1);
var root_2 = $.from_html(`<p> </p>`);
var root_3 = $.from_html(`<div class="row wrap"><span class="muted"> </span> <!> <span class="grow"></span> <!> <!> <!> <!> <!> <!> <!></div> <div class="text s-iyog2j"><!></div> <!> <!>`, 1);
function Edit($$anchor, $$props) {
	$.push($$props, true);
	let editor = $.state(void 0);
	let text = $.state("");
	let changed = $.state(false);
	let asking = $.state(false);
	let facts = $.state($.proxy({
		rungs: 0,
		instructions: 0
	}));
	/** What is wrong with the text, as it was when it was looked at. */
	let faults = $.state([]);
	const level = $.derived(() => machine.level);
	const findings = $.derived(() => $.get(faults).map((alarm) => ({
		line: alarm.line,
		id: alarm.id,
		text: alarmText(alarm).text,
		severity: "error"
	})));
	async function read() {
		const reply = await machine.fetch("text", { do: "ladder" });
		if (!reply) return;
		$.set(text, reply.text, true);
		$.set(changed, false);
		$.set(faults, []);
		const ladder = readLadder(reply.text);
		$.set(facts, {
			rungs: ladder.rungs.length,
			instructions: ladder.instructions
		}, true);
	}
	let seen = -1;
	$.user_effect(() => {
		const exchanges = machine.changed("ladder");
		if (machine.link !== "open" || exchanges === seen || untrack(() => $.get(changed))) return;
		seen = exchanges;
		read();
	});
	async function exchange() {
		$.set(asking, false);
		$.set(faults, []);
		const now = $.get(editor)?.value() ?? $.get(text);
		try {
			await machine.ask({
				do: "exchange_ladder",
				text: now
			});
		} catch (refused) {
			const alarm = refused instanceof Refused ? refused.alarm : null;
			if (alarm?.line) {
				await tellFault(alarm);
				await check(now);
			} else machine.refused(refused);
			return;
		}
		notify({
			kind: "done",
			title: t("plc.exchanged")
		});
		$.set(text, now, true);
		$.set(changed, false);
	}
	/** What is wrong with a ladder that was refused: its first fault, by its number in the list of the GSK990MC. */
	async function tellFault({ id, line, values }) {
		$.get(editor)?.show(line);
		const about = await http.alarm(id, values, language()).catch(() => null);
		notify({
			kind: "warning",
			title: t("plc.faulty", { line }),
			text: about ? `${about.text}. ${about.help}` : "",
			code: id
		});
	}
	/** Looks at a text without running it; how many steps it has, 0 where it has faults. */
	async function check(now) {
		const reply = await machine.fetch("ladder_checked", {
			do: "check_ladder",
			text: now
		});
		$.set(faults, reply?.faults ?? []);
		return reply?.steps ?? 0;
	}
	async function look() {
		const steps = await check($.get(editor)?.value() ?? $.get(text));
		if (steps) notify({
			kind: "done",
			title: t("plc.faultless", { steps })
		});
	}
	async function back() {
		if (await machine.tell({ do: "roll_back_ladder" })) await read();
	}
	var fragment = root_3();
	var div = $.first_child(fragment);
	var span = $.child(div);
	var text_1 = $.only_child(span, true);
	var node = $.sibling(span, 2);
	var consequent = ($$anchor) => {
		var span_1 = root();
		var text_2 = $.only_child(span_1, true);
		$.template_effect(($0) => $.set_text(text_2, $0), [() => t("offsets.need", {
			level: 2,
			name: t("rights.level_2")
		})]);
		$.append($$anchor, span_1);
	};
	$.if(node, ($$render) => {
		if ($.get(level) > 2) $$render(consequent);
	});
	var node_1 = $.sibling(node, 4);
	KeypadSwitch(node_1, {});
	var node_2 = $.sibling(node_1, 2);
	{
		let $0 = $.derived(() => t("program.find"));
		Button(node_2, {
			icon: "search",
			get "aria-label"() {
				return $.get($0);
			},
			onclick: () => $.get(editor)?.find()
		});
	}
	var node_3 = $.sibling(node_2, 2);
	{
		let $0 = $.derived(() => t("editor.line"));
		let $1 = $.derived(() => t("editor.line"));
		Button(node_3, {
			icon: "target",
			get "aria-label"() {
				return $.get($0);
			},
			get title() {
				return $.get($1);
			},
			onclick: () => $.get(editor)?.toLine()
		});
	}
	var node_4 = $.sibling(node_3, 2);
	Button(node_4, {
		icon: "check",
		onclick: () => void look(),
		"data-testid": "check-ladder",
		children: ($$anchor, $$slotProps) => {
			$.next();
			var text_3 = $.text();
			$.template_effect(($0) => $.set_text(text_3, $0), [() => t("plc.check")]);
			$.append($$anchor, text_3);
		},
		$$slots: { default: true }
	});
	var node_5 = $.sibling(node_4, 2);
	Button(node_5, {
		icon: "undo",
		onclick: () => void back(),
		children: ($$anchor, $$slotProps) => {
			$.next();
			var text_4 = $.text();
			$.template_effect(($0) => $.set_text(text_4, $0), [() => t("plc.roll_back")]);
			$.append($$anchor, text_4);
		},
		$$slots: { default: true }
	});
	var node_6 = $.sibling(node_5, 2);
	Button(node_6, {
		icon: "play",
		onclick: () => void machine.tell({ do: "start_ladder" }),
		children: ($$anchor, $$slotProps) => {
			$.next();
			var text_5 = $.text();
			$.template_effect(($0) => $.set_text(text_5, $0), [() => t("plc.start")]);
			$.append($$anchor, text_5);
		},
		$$slots: { default: true }
	});
	var node_7 = $.sibling(node_6, 2);
	{
		let $0 = $.derived(() => !$.get(changed));
		Button(node_7, {
			kind: "primary",
			icon: "upload",
			get disabled() {
				return $.get($0);
			},
			onclick: () => $.set(asking, true),
			"data-testid": "exchange",
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_6 = $.text();
				$.template_effect(($0) => $.set_text(text_6, $0), [() => t("plc.exchange")]);
				$.append($$anchor, text_6);
			},
			$$slots: { default: true }
		});
	}
	$.reset(div);
	var div_1 = $.sibling(div, 2);
	var node_8 = $.child(div_1);
	{
		let $0 = $.derived(() => t("plc.edit"));
		$.bind_this(Editor(node_8, {
			get text() {
				return $.get(text);
			},
			plain: true,
			get label() {
				return $.get($0);
			},
			onchange: () => $.set(changed, true),
			onsave: () => $.set(asking, true)
		}), ($$value) => $.set(editor, $$value, true), () => $.get(editor));
	}
	$.reset(div_1);
	var node_9 = $.sibling(div_1, 2);
	Findings(node_9, {
		get findings() {
			return $.get(findings);
		},
		onshow: (line) => $.get(editor)?.show(line)
	});
	var node_10 = $.sibling(node_9, 2);
	{
		const actions = ($$anchor) => {
			var fragment_5 = root_1();
			var node_11 = $.first_child(fragment_5);
			Button(node_11, {
				onclick: () => $.set(asking, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_7 = $.text();
					$.template_effect(($0) => $.set_text(text_7, $0), [() => t("app.cancel")]);
					$.append($$anchor, text_7);
				},
				$$slots: { default: true }
			});
			var node_12 = $.sibling(node_11, 2);
			Button(node_12, {
				kind: "danger",
				onclick: () => void exchange(),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_8 = $.text();
					$.template_effect(($0) => $.set_text(text_8, $0), [() => t("plc.exchange")]);
					$.append($$anchor, text_8);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_5);
		};
		let $0 = $.derived(() => t("plc.exchange"));
		Dialog(node_10, {
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
				var p = root_2();
				var text_9 = $.only_child(p, true);
				$.template_effect(($0) => $.set_text(text_9, $0), [() => t("plc.exchange_text")]);
				$.append($$anchor, p);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.template_effect(($0) => $.set_text(text_1, $0), [() => t("plc.facts", $.get(facts))]);
	$.append($$anchor, fragment);
	$.pop();
}
export { Edit as default };
