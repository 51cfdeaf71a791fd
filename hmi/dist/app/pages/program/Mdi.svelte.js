import { t } from "../../lib/i18n/index.svelte.js";
import Editor from "../../lib/editor/Editor.svelte.js";
import KeypadSwitch from "../../lib/editor/KeypadSwitch.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import Key from "../../lib/parts/Key.svelte.js";
import { fixed } from "../../lib/numbers.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { mdi } from "../../lib/state/mdi.svelte.js";
import { prefs } from "../../lib/state/prefs.svelte.js";
import { restart } from "../../lib/state/restart.svelte.js";
import Modal from "../position/Modal.svelte.js";
import Differences from "./Differences.svelte.js";
import { untrack } from "svelte";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/program/Mdi.svelte
var root = $.from_html(`<!> <!> <!> <!> <!>`, 1);
var root_1 = $.from_html(`<div class="text s-1ml193g"><div class="s-1ml193g"><!></div> <p role="status" data-testid="mdi-state"> </p></div>`);
var root_2 = $.from_html(`<div class="row waits s-1ml193g"><code class="code grow"> </code> <!></div>`);
var root_3 = $.from_html(`<form class="row"><input class="code grow s-1ml193g" spellcheck="false" autocapitalize="characters" placeholder="G0 X0 Y0"/> <!></form> <!> <p class="muted s-1ml193g"> </p>`, 1);
var root_4 = $.from_html(`<p class="code values s-1ml193g" data-testid="mdi-values"> </p>`);
var root_5 = $.from_html(`<button type="button" class="past code s-1ml193g"> </button>`);
var root_6 = $.from_html(`<p class="muted empty s-1ml193g"> </p>`);
var root_7 = $.from_html(`<div><!> <div class="side s-1ml193g"><!> <!> <!> <!></div></div>`);
function Mdi($$anchor, $$props) {
	$.push($$props, true);
	const KEY = "ferrocut.mdi";
	let editor = $.state(void 0);
	const text = mdi.draft ?? "";
	let past = $.state(read());
	const ready = $.derived(() => machine.status?.mode === "mdi");
	const prepared = $.derived(() => machine.status?.restart_ready ?? false);
	let plan = $.state(null);
	mdi.forget();
	$.user_effect(() => {
		machine.changed("mdi");
		if (machine.link === "open") mdi.read();
		else mdi.forget();
	});
	$.user_effect(() => {
		const now = mdi.held;
		if (now && $.get(editor)) untrack(() => mdi.draft === null && open(now.text));
	});
	const shown = $.derived(() => {
		if (mdi.isUnsent) return t("program.mdi_unsent");
		if (!mdi.held) return t("program.mdi_unknown");
		if (mdi.held.block.trim()) return t("program.mdi_runs_block", { block: mdi.held.block.trim() });
		return t(mdi.held.text.trim() ? "program.mdi_runs" : "program.mdi_nothing");
	});
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
	/** Shows a text in the place of the one that stands there. */
	function open(now) {
		if ($.get(editor) && $.get(editor).value() !== now) $.get(editor).reopen(now);
	}
	function takeBack() {
		mdi.drop();
		open(mdi.held?.text ?? "");
	}
	async function send() {
		const sent = $.get(editor)?.value() ?? "";
		if (await mdi.send(sent) && sent.trim()) keep(sent.trim());
	}
	async function sendBlock(event) {
		event.preventDefault();
		const sent = mdi.block.trim();
		mdi.block = sent;
		if (await mdi.sendBlock(sent) && sent) keep(sent);
	}
	function again(sent) {
		if (!sent.includes("\n") && mdi.block) mdi.block = sent;
		else {
			open(sent);
			mdi.type(sent);
		}
	}
	var div = root_7();
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
			{
				let $0 = $.derived(() => t("program.mdi_take_back"));
				let $1 = $.derived(() => t("program.mdi_take_back"));
				let $2 = $.derived(() => !mdi.isUnsent);
				Button(node_3, {
					kind: "quiet",
					icon: "undo",
					get "aria-label"() {
						return $.get($0);
					},
					get title() {
						return $.get($1);
					},
					get disabled() {
						return $.get($2);
					},
					onclick: takeBack,
					"data-testid": "mdi-take-back"
				});
			}
			var node_4 = $.sibling(node_3, 2);
			Button(node_4, {
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
			var node_5 = $.sibling(node_4, 2);
			{
				let $0 = $.derived(() => t("panel.start"));
				let $1 = $.derived(() => !$.get(ready) || !mdi.isShown);
				Key(node_5, {
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
				var div_2 = $.child(div_1);
				var node_6 = $.child(div_2);
				{
					let $0 = $.derived(() => t("program.mdi_text"));
					$.bind_this(Editor(node_6, {
						get text() {
							return text;
						},
						get label() {
							return $.get($0);
						},
						onchange: () => mdi.type($.get(editor)?.value() ?? ""),
						onsave: () => void send()
					}), ($$value) => $.set(editor, $$value, true), () => $.get(editor));
				}
				$.reset(div_2);
				var p = $.sibling(div_2, 2);
				let classes_1;
				var text_2 = $.only_child(p, true);
				$.reset(div_1);
				$.template_effect(() => {
					classes_1 = $.set_class(p, 1, "s-1ml193g", null, classes_1, { unsent: mdi.isUnsent });
					$.set_text(text_2, $.get(shown));
				});
				$.append($$anchor, div_1);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var div_3 = $.sibling(node, 2);
	var node_7 = $.child(div_3);
	{
		let $0 = $.derived(() => t("program.one_block"));
		Card(node_7, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var fragment_4 = root_3();
				var form = $.first_child(fragment_4);
				var input = $.child(form);
				$.remove_input_defaults(input);
				var node_8 = $.sibling(input, 2);
				{
					let $0 = $.derived(() => t("program.send"));
					Button(node_8, {
						type: "submit",
						icon: "upload",
						get "aria-label"() {
							return $.get($0);
						}
					});
				}
				$.reset(form);
				var node_9 = $.sibling(form, 2);
				var consequent_1 = ($$anchor) => {
					var div_4 = root_2();
					var code = $.child(div_4);
					var text_3 = $.only_child(code, true);
					var node_10 = $.sibling(code, 2);
					{
						let $0 = $.derived(() => t("program.block_take_back"));
						let $1 = $.derived(() => t("program.block_take_back"));
						Button(node_10, {
							kind: "quiet",
							icon: "trash",
							get "aria-label"() {
								return $.get($0);
							},
							get title() {
								return $.get($1);
							},
							onclick: () => void mdi.sendBlock("")
						});
					}
					$.reset(div_4);
					$.template_effect(() => $.set_text(text_3, mdi.held.block));
					$.append($$anchor, div_4);
				};
				var d = $.derived(() => mdi.held?.block.trim());
				$.if(node_9, ($$render) => {
					if ($.get(d)) $$render(consequent_1);
				});
				var p_1 = $.sibling(node_9, 2);
				var text_4 = $.only_child(p_1, true);
				$.template_effect(($0, $1) => {
					$.set_attribute(input, "aria-label", $0);
					$.set_text(text_4, $1);
				}, [() => t("program.one_block"), () => t("program.one_block_text")]);
				$.event("submit", form, sendBlock);
				$.bind_value(input, () => mdi.block, ($$value) => mdi.block = $$value);
				$.append($$anchor, fragment_4);
			},
			$$slots: { default: true }
		});
	}
	var node_11 = $.sibling(node_7, 2);
	var consequent_2 = ($$anchor) => {
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
	$.if(node_11, ($$render) => {
		if ($.get(plan)?.differences.length) $$render(consequent_2);
	});
	var node_12 = $.sibling(node_11, 2);
	var consequent_3 = ($$anchor) => {
		Modal($$anchor, {
			children: ($$anchor, $$slotProps) => {
				const computed_const = $.derived(() => {
					return machine.status;
				});
				var p_2 = root_4();
				var text_5 = $.only_child(p_2);
				$.template_effect(($0, $1) => $.set_text(text_5, `F${$0 ?? ""} S${$1 ?? ""} T${$.get(computed_const).spindle.called_tool ?? ""} H${$.get(computed_const).program.h ?? ""} D${$.get(computed_const).program.d ?? ""}`), [() => fixed($.get(computed_const).feed.programmed, 0), () => fixed($.get(computed_const).spindle.programmed, 0)]);
				$.append($$anchor, p_2);
			},
			$$slots: { default: true }
		});
	};
	$.if(node_12, ($$render) => {
		if (machine.status) $$render(consequent_3);
	});
	var node_13 = $.sibling(node_12, 2);
	{
		let $0 = $.derived(() => t("program.past"));
		Card(node_13, {
			get title() {
				return $.get($0);
			},
			flush: true,
			children: ($$anchor, $$slotProps) => {
				var fragment_8 = $.comment();
				var node_14 = $.first_child(fragment_8);
				$.each(node_14, 16, () => $.get(past), (one) => one, ($$anchor, one) => {
					var button = root_5();
					var text_6 = $.only_child(button, true);
					$.template_effect(() => $.set_text(text_6, one));
					$.delegated("click", button, () => again(one));
					$.append($$anchor, button);
				}, ($$anchor) => {
					var p_3 = root_6();
					var text_7 = $.only_child(p_3, true);
					$.template_effect(($0) => $.set_text(text_7, $0), [() => t("program.past_none")]);
					$.append($$anchor, p_3);
				});
				$.append($$anchor, fragment_8);
			},
			$$slots: { default: true }
		});
	}
	$.reset(div_3);
	$.reset(div);
	$.template_effect(() => classes = $.set_class(div, 1, "mdi s-1ml193g", null, classes, { keypad: prefs.keypad }));
	$.append($$anchor, div);
	$.pop();
}
$.delegate(["click"]);
export { Mdi as default };
