import { t } from "../../lib/i18n/index.svelte.js";
import Editor from "../../lib/editor/Editor.svelte.js";
import KeypadSwitch from "../../lib/editor/KeypadSwitch.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import Key from "../../lib/parts/Key.svelte.js";
import { fixed } from "../../lib/numbers.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { prefs } from "../../lib/state/prefs.svelte.js";
import { restart } from "../../lib/state/restart.svelte.js";
import Modal from "../position/Modal.svelte.js";
import Differences from "./Differences.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/program/Mdi.svelte
var root = $.from_html(`<!> <!> <!> <!>`, 1);
var root_1 = $.from_html(`<div class="text s-1tnbj1o"><!></div>`);
var root_2 = $.from_html(`<form class="row"><input class="code grow s-1tnbj1o" spellcheck="false" autocapitalize="characters" placeholder="G0 X0 Y0"/> <!></form> <p class="muted s-1tnbj1o"> </p>`, 1);
var root_3 = $.from_html(`<p class="code values s-1tnbj1o" data-testid="mdi-values"> </p>`);
var root_4 = $.from_html(`<button type="button" class="past code s-1tnbj1o"> </button>`);
var root_5 = $.from_html(`<p class="muted empty s-1tnbj1o"> </p>`);
var root_6 = $.from_html(`<div><!> <div class="side s-1tnbj1o"><!> <!> <!> <!></div></div>`);
function Mdi($$anchor, $$props) {
	$.push($$props, true);
	const KEY = "ferrocut.mdi";
	let editor = $.state(void 0);
	let text = $.state("");
	let block = $.state("");
	let past = $.state(read());
	const ready = $.derived(() => machine.status?.mode === "mdi");
	const prepared = $.derived(() => machine.status?.restart_ready ?? false);
	let plan = $.state(null);
	$.user_effect(() => {
		if ($.get(prepared)) return restart.follow((now) => $.set(plan, now.ready));
		$.set(plan, null);
	});
	function read() {
		try {
			return JSON.parse(localStorage.getItem(KEY) ?? "[]").map(String).slice(0, 20);
		} catch {
			return [];
		}
	}
	function keep(sent) {
		$.set(past, [sent, ...$.get(past).filter((one) => one !== sent)].slice(0, 20));
		try {
			localStorage.setItem(KEY, JSON.stringify($.get(past)));
		} catch {}
	}
	async function send() {
		const sent = $.get(editor)?.value() ?? "";
		if (await machine.tell({
			do: "mdi",
			text: sent
		})) keep(sent.trim());
	}
	async function sendBlock(event) {
		event.preventDefault();
		if (await machine.tell({
			do: "mdi_block",
			block: $.get(block)
		})) keep($.get(block));
	}
	var div = root_6();
	let classes;
	var node = $.child(div);
	{
		const actions = ($$anchor) => {
			var fragment = root();
			var node_1 = $.first_child(fragment);
			KeypadSwitch(node_1, {});
			var node_2 = $.sibling(node_1, 2);
			var consequent = ($$anchor) => {
				{
					let $0 = $.derived(() => t("mode.mdi"));
					Key($$anchor, {
						signal: "KEY_MDI",
						lamp: "LAMP_MDI",
						get label() {
							return $.get($0);
						}
					});
				}
			};
			$.if(node_2, ($$render) => {
				if (!$.get(ready)) $$render(consequent);
			});
			var node_3 = $.sibling(node_2, 2);
			Button(node_3, {
				kind: "primary",
				icon: "upload",
				onclick: () => void send(),
				"data-testid": "mdi-send",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_1 = $.text();
					$.template_effect(($0) => $.set_text(text_1, $0), [() => t("program.send")]);
					$.append($$anchor, text_1);
				},
				$$slots: { default: true }
			});
			var node_4 = $.sibling(node_3, 2);
			{
				let $0 = $.derived(() => t("panel.start"));
				let $1 = $.derived(() => !$.get(ready));
				Key(node_4, {
					signal: "KEY_START",
					lamp: "LAMP_START",
					get label() {
						return $.get($0);
					},
					kind: "start",
					get disabled() {
						return $.get($1);
					},
					children: ($$anchor, $$slotProps) => {
						Icon($$anchor, {
							name: "play",
							fill: true
						});
					},
					$$slots: { default: true }
				});
			}
			$.append($$anchor, fragment);
		};
		let $0 = $.derived(() => t("program.mdi_text"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			fill: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var div_1 = root_1();
				var node_5 = $.child(div_1);
				{
					let $0 = $.derived(() => t("program.mdi_text"));
					$.bind_this(Editor(node_5, {
						get text() {
							return $.get(text);
						},
						get label() {
							return $.get($0);
						},
						onsave: () => void send()
					}), ($$value) => $.set(editor, $$value, true), () => $.get(editor));
				}
				$.reset(div_1);
				$.append($$anchor, div_1);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var div_2 = $.sibling(node, 2);
	var node_6 = $.child(div_2);
	{
		let $0 = $.derived(() => t("program.one_block"));
		Card(node_6, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var fragment_4 = root_2();
				var form = $.first_child(fragment_4);
				var input = $.child(form);
				$.remove_input_defaults(input);
				var node_7 = $.sibling(input, 2);
				{
					let $0 = $.derived(() => t("program.send"));
					Button(node_7, {
						type: "submit",
						icon: "upload",
						get "aria-label"() {
							return $.get($0);
						}
					});
				}
				$.reset(form);
				var p = $.sibling(form, 2);
				var text_2 = $.only_child(p, true);
				$.template_effect(($0, $1) => {
					$.set_attribute(input, "aria-label", $0);
					$.set_text(text_2, $1);
				}, [() => t("program.one_block"), () => t("program.one_block_text")]);
				$.event("submit", form, sendBlock);
				$.bind_value(input, () => $.get(block), ($$value) => $.set(block, $$value));
				$.append($$anchor, fragment_4);
			},
			$$slots: { default: true }
		});
	}
	var node_8 = $.sibling(node_6, 2);
	var consequent_1 = ($$anchor) => {
		{
			let $0 = $.derived(() => t("restart.yours"));
			Card($$anchor, {
				get title() {
					return $.get($0);
				},
				flush: true,
				children: ($$anchor, $$slotProps) => {
					Differences($$anchor, { get plan() {
						return $.get(plan);
					} });
				},
				$$slots: { default: true }
			});
		}
	};
	$.if(node_8, ($$render) => {
		if ($.get(plan)?.differences.length) $$render(consequent_1);
	});
	var node_9 = $.sibling(node_8, 2);
	var consequent_2 = ($$anchor) => {
		Modal($$anchor, {
			children: ($$anchor, $$slotProps) => {
				const computed_const = $.derived(() => {
					return machine.status;
				});
				var p_1 = root_3();
				var text_3 = $.only_child(p_1);
				$.template_effect(($0, $1) => $.set_text(text_3, `F${$0 ?? ""} S${$1 ?? ""} T${$.get(computed_const).spindle.called_tool ?? ""} H${$.get(computed_const).program.h ?? ""} D${$.get(computed_const).program.d ?? ""}`), [() => fixed($.get(computed_const).feed.programmed, 0), () => fixed($.get(computed_const).spindle.programmed, 0)]);
				$.append($$anchor, p_1);
			},
			$$slots: { default: true }
		});
	};
	$.if(node_9, ($$render) => {
		if (machine.status) $$render(consequent_2);
	});
	var node_10 = $.sibling(node_9, 2);
	{
		let $0 = $.derived(() => t("program.past"));
		Card(node_10, {
			get title() {
				return $.get($0);
			},
			flush: true,
			children: ($$anchor, $$slotProps) => {
				var fragment_8 = $.comment();
				var node_11 = $.first_child(fragment_8);
				$.each(node_11, 16, () => $.get(past), (one) => one, ($$anchor, one) => {
					var button = root_4();
					var text_4 = $.only_child(button, true);
					$.template_effect(() => $.set_text(text_4, one));
					$.delegated("click", button, () => one.includes("\n") || !$.get(block) ? $.set(text, one, true) : $.set(block, one, true));
					$.append($$anchor, button);
				}, ($$anchor) => {
					var p_2 = root_5();
					var text_5 = $.only_child(p_2, true);
					$.template_effect(($0) => $.set_text(text_5, $0), [() => t("program.past_none")]);
					$.append($$anchor, p_2);
				});
				$.append($$anchor, fragment_8);
			},
			$$slots: { default: true }
		});
	}
	$.reset(div_2);
	$.reset(div);
	$.template_effect(() => classes = $.set_class(div, 1, "mdi s-1tnbj1o", null, classes, { keypad: prefs.keypad }));
	$.append($$anchor, div);
	$.pop();
}
$.delegate(["click"]);
export { Mdi as default };
