import { t } from "../../lib/i18n/index.svelte.js";
import { bytes } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import Key from "../../lib/parts/Key.svelte.js";
import { dnc } from "../../lib/state/dnc.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/program/Dnc.svelte
var root = $.from_html(`<!> <!> <!> <input type="file" hidden="" data-testid="dnc-file"/>`, 1);
var root_1 = $.from_html(`<div class="row wrap left s-13mu6wm" role="status" data-testid="dnc-left"><span class="grow"> </span> <!></div>`);
var root_2 = $.from_html(`<span class="muted" role="status"> </span>`);
var root_3 = $.from_html(`<div class="row wrap" data-testid="dnc"><strong class="code"> </strong> <progress class="grow s-13mu6wm"></progress> <span class="number"> </span> <!> <!></div>`);
var root_4 = $.from_html(`<div class="dnc s-13mu6wm"><p class="muted"> </p> <!> <!> <p class="block code s-13mu6wm"> </p></div>`);
function Dnc($$anchor, $$props) {
	$.push($$props, true);
	let picker = $.state(void 0);
	/** What somebody sent and nobody goes on with: a page that was closed or loaded anew. */
	const left = $.derived(() => dnc.sending || !machine.status?.dnc?.awaited ? null : machine.status.dnc);
	let onward = false;
	const ready = $.derived(() => machine.status?.mode === "dnc");
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
					onclick: () => {
						onward = false;
						$.get(picker)?.click();
					},
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
				if (file) dnc.send(file, onward);
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
				var consequent_1 = ($$anchor) => {
					var div_1 = root_1();
					var span = $.child(div_1);
					var text_2 = $.only_child(span, true);
					var node_4 = $.sibling(span, 2);
					{
						let $0 = $.derived(() => !machine.inCommand);
						Button(node_4, {
							kind: "primary",
							icon: "upload",
							get disabled() {
								return $.get($0);
							},
							onclick: () => {
								onward = true;
								$.get(picker)?.click();
							},
							children: ($$anchor, $$slotProps) => {
								$.next();
								var text_3 = $.text();
								$.template_effect(($0) => $.set_text(text_3, $0), [() => t("program.dnc_onward")]);
								$.append($$anchor, text_3);
							},
							$$slots: { default: true }
						});
					}
					$.reset(div_1);
					$.template_effect(($0) => {
						$.set_attribute(div_1, "data-taken", $.get(left).taken);
						$.set_text(text_2, $0);
					}, [() => t("program.dnc_left", { taken: bytes($.get(left).taken) })]);
					$.append($$anchor, div_1);
				};
				$.if(node_3, ($$render) => {
					if ($.get(left)) $$render(consequent_1);
				});
				var node_5 = $.sibling(node_3, 2);
				var consequent_4 = ($$anchor) => {
					var div_2 = root_3();
					var strong = $.child(div_2);
					var text_4 = $.only_child(strong, true);
					var progress = $.sibling(strong, 2);
					var span_1 = $.sibling(progress, 2);
					var text_5 = $.only_child(span_1, true);
					var node_6 = $.sibling(span_1, 2);
					var consequent_2 = ($$anchor) => {
						var span_2 = root_2();
						var text_6 = $.only_child(span_2, true);
						$.template_effect(($0) => $.set_text(text_6, $0), [() => t("program.dnc_waits")]);
						$.append($$anchor, span_2);
					};
					$.if(node_6, ($$render) => {
						if (dnc.waiting) $$render(consequent_2);
					});
					var node_7 = $.sibling(node_6, 2);
					var consequent_3 = ($$anchor) => {
						Button($$anchor, {
							icon: "stop",
							onclick: () => dnc.stop(),
							children: ($$anchor, $$slotProps) => {
								$.next();
								var text_7 = $.text();
								$.template_effect(($0) => $.set_text(text_7, $0), [() => t("program.dnc_stop")]);
								$.append($$anchor, text_7);
							},
							$$slots: { default: true }
						});
					};
					$.if(node_7, ($$render) => {
						if (dnc.sending) $$render(consequent_3);
					});
					$.reset(div_2);
					$.template_effect(($0, $1) => {
						$.set_attribute(div_2, "data-sent", dnc.sent);
						$.set_attribute(div_2, "data-sending", dnc.sending);
						$.set_text(text_4, dnc.file.name);
						$.set_attribute(progress, "max", $0);
						$.set_value(progress, dnc.sent);
						$.set_text(text_5, $1);
					}, [() => Math.max(1, dnc.file.size), () => t("program.dnc_sent", {
						sent: bytes(dnc.sent),
						size: bytes(dnc.file.size)
					})]);
					$.append($$anchor, div_2);
				};
				$.if(node_5, ($$render) => {
					if (dnc.file) $$render(consequent_4);
				});
				var p_1 = $.sibling(node_5, 2);
				var text_8 = $.only_child(p_1, true);
				$.reset(div);
				$.template_effect(($0) => {
					$.set_text(text_1, $0);
					$.set_text(text_8, machine.status?.program_mode === "dnc" ? machine.status.program.block : "");
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
