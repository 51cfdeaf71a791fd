import { t } from "../../lib/i18n/index.svelte.js";
import { bytes } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import Key from "../../lib/parts/Key.svelte.js";
import { alarmText } from "../../lib/state/alarm-texts.svelte.js";
import { dnc } from "../../lib/state/dnc.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/program/Dnc.svelte
var root = $.from_html(`<!> <!> <!> <input type="file" hidden="" data-testid="dnc-file"/>`, 1);
var root_1 = $.from_html(`<p class="bad" role="status"> </p>`);
var root_2 = $.from_html(`<p class="muted" role="status" data-testid="dnc-ended"> </p>`);
var root_3 = $.from_html(`<div class="row wrap" data-testid="dnc"><strong class="code"> </strong> <progress class="grow s-gujldb"></progress> <span class="number"> </span> <!></div> <!>`, 1);
var root_4 = $.from_html(`<div class="dnc s-gujldb"><p class="muted"> </p> <!> <p class="block code s-gujldb"> </p></div>`);
function Dnc($$anchor, $$props) {
	$.push($$props, true);
	let picker = $.state(void 0);
	const ready = $.derived(() => machine.status?.mode === "dnc");
	/** What comes, else what is given. */
	const file = $.derived(() => dnc.coming ?? dnc.file);
	/** ms between two looks at how far it is. */
	const LOOK = 500;
	$.user_effect(() => {
		dnc.look();
		const timer = setInterval(() => void dnc.look(), LOOK);
		return () => clearInterval(timer);
	});
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var node = $.first_child(fragment_1);
			var consequent = ($$anchor) => {
				{
					let $0 = $.derived(() => t("mode.dnc"));
					Key($$anchor, {
						signal: "KEY_DNC",
						lamp: "LAMP_DNC",
						get label() {
							return $.get($0);
						}
					});
				}
			};
			$.if(node, ($$render) => {
				if (!$.get(ready)) $$render(consequent);
			});
			var node_1 = $.sibling(node, 2);
			{
				let $0 = $.derived(() => !machine.inCommand);
				Button(node_1, {
					kind: "primary",
					icon: "upload",
					get disabled() {
						return $.get($0);
					},
					onclick: () => $.get(picker)?.click(),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text = $.text();
						$.template_effect(($0) => $.set_text(text, $0), [() => t("program.dnc_choose")]);
						$.append($$anchor, text);
					},
					$$slots: { default: true }
				});
			}
			var node_2 = $.sibling(node_1, 2);
			{
				let $0 = $.derived(() => t("panel.start"));
				let $1 = $.derived(() => !$.get(ready));
				Key(node_2, {
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
			var input = $.sibling(node_2, 2);
			$.bind_this(input, ($$value) => $.set(picker, $$value), () => $.get(picker));
			$.delegated("change", input, (event) => {
				const file = event.currentTarget.files?.[0];
				event.currentTarget.value = "";
				if (file) dnc.send(file);
			});
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("program.dnc"));
		Card($$anchor, {
			get title() {
				return $.get($0);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var div = root_4();
				var p = $.child(div);
				var text_1 = $.only_child(p, true);
				var node_3 = $.sibling(p, 2);
				var consequent_4 = ($$anchor) => {
					var fragment_5 = root_3();
					var div_1 = $.first_child(fragment_5);
					var strong = $.child(div_1);
					var text_2 = $.only_child(strong, true);
					var progress = $.sibling(strong, 2);
					var span = $.sibling(progress, 2);
					var text_3 = $.only_child(span, true);
					var node_4 = $.sibling(span, 2);
					var consequent_1 = ($$anchor) => {
						{
							let $0 = $.derived(() => !dnc.coming && !machine.inCommand);
							Button($$anchor, {
								icon: "stop",
								get disabled() {
									return $.get($0);
								},
								onclick: () => void dnc.stop(),
								children: ($$anchor, $$slotProps) => {
									$.next();
									var text_4 = $.text();
									$.template_effect(($0) => $.set_text(text_4, $0), [() => t("program.dnc_stop")]);
									$.append($$anchor, text_4);
								},
								$$slots: { default: true }
							});
						}
					};
					$.if(node_4, ($$render) => {
						if (dnc.coming || dnc.file?.sending) $$render(consequent_1);
					});
					$.reset(div_1);
					var node_5 = $.sibling(div_1, 2);
					var consequent_2 = ($$anchor) => {
						var p_1 = root_1();
						var text_5 = $.only_child(p_1, true);
						$.template_effect(($0) => $.set_text(text_5, $0), [() => alarmText(dnc.file.refused.alarm).text]);
						$.append($$anchor, p_1);
					};
					var consequent_3 = ($$anchor) => {
						var p_2 = root_2();
						var text_6 = $.only_child(p_2, true);
						$.template_effect(($0) => $.set_text(text_6, $0), [() => t("program.dnc_ended")]);
						$.append($$anchor, p_2);
					};
					$.if(node_5, ($$render) => {
						if (!dnc.coming && dnc.file?.refused) $$render(consequent_2);
						else if (!dnc.coming && !dnc.file?.sending && $.get(file).sent < $.get(file).bytes) $$render(consequent_3, 1);
					});
					$.template_effect(($0, $1) => {
						$.set_attribute(div_1, "data-sent", $.get(file).sent);
						$.set_attribute(div_1, "data-sending", !!dnc.coming || !!dnc.file?.sending);
						$.set_text(text_2, $.get(file).name);
						$.set_attribute(progress, "max", $0);
						$.set_value(progress, $.get(file).sent);
						$.set_text(text_3, $1);
					}, [() => Math.max(1, $.get(file).bytes), () => t(dnc.coming ? "program.dnc_coming" : "program.dnc_sent", {
						sent: bytes($.get(file).sent),
						size: bytes($.get(file).bytes)
					})]);
					$.append($$anchor, fragment_5);
				};
				$.if(node_3, ($$render) => {
					if ($.get(file)) $$render(consequent_4);
				});
				var p_3 = $.sibling(node_3, 2);
				var text_7 = $.only_child(p_3, true);
				$.reset(div);
				$.template_effect(($0) => {
					$.set_text(text_1, $0);
					$.set_text(text_7, machine.status?.program_mode === "dnc" ? machine.status.program.block : "");
				}, [() => t("program.dnc_text")]);
				$.append($$anchor, div);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.pop();
}
$.delegate(["change"]);
export { Dnc as default };
