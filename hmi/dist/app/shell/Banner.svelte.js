import { t } from "../lib/i18n/index.svelte.js";
import Button from "../lib/parts/Button.svelte.js";
import Icon from "../lib/parts/Icon.svelte.js";
import { machine } from "../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/Banner.svelte
var root = $.from_html(`<div class="banner lost s-mhxwtp" role="alert"><!><span> </span></div>`);
var root_1 = $.from_html(`<div class="banner s-mhxwtp" role="alert" data-testid="asks"><!><span class="said s-mhxwtp"> </span> <!> <!></div>`);
var root_2 = $.from_html(`<div class="banner s-mhxwtp"><!><span class="said s-mhxwtp" role="status"> </span> <!></div>`);
function Banner($$anchor, $$props) {
	$.push($$props, true);
	const nameOf = ({ connection, from }) => t(from ? "log.connection_from" : "log.connection", {
		number: connection,
		address: from
	});
	const first = $.derived(() => machine.asking[0]);
	var fragment = $.comment();
	var node = $.first_child(fragment);
	var consequent = ($$anchor) => {};
	var consequent_1 = ($$anchor) => {
		var div = root();
		var node_1 = $.child(div);
		Icon(node_1, { name: "link" });
		var span = $.sibling(node_1);
		var text = $.only_child(span, true);
		$.reset(div);
		$.template_effect(($0) => $.set_text(text, $0), [() => t("app.lost_text")]);
		$.append($$anchor, div);
	};
	var consequent_2 = ($$anchor) => {
		var div_1 = root_1();
		var node_2 = $.child(div_1);
		Icon(node_2, { name: "hand" });
		var span_1 = $.sibling(node_2);
		var text_1 = $.only_child(span_1, true);
		var node_3 = $.sibling(span_1, 2);
		Button(node_3, {
			kind: "primary",
			onclick: () => void machine.tell({
				do: "hand_over",
				to: $.get(first).connection
			}),
			"data-testid": "hand-over",
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_2 = $.text();
				$.template_effect(($0) => $.set_text(text_2, $0), [() => t("app.hand_over")]);
				$.append($$anchor, text_2);
			},
			$$slots: { default: true }
		});
		var node_4 = $.sibling(node_3, 2);
		Button(node_4, {
			onclick: () => void machine.tell({
				do: "decline",
				to: $.get(first).connection
			}),
			"data-testid": "decline",
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_3 = $.text();
				$.template_effect(($0) => $.set_text(text_3, $0), [() => t("app.decline")]);
				$.append($$anchor, text_3);
			},
			$$slots: { default: true }
		});
		$.reset(div_1);
		$.template_effect(($0) => $.set_text(text_1, $0), [() => t("app.asks", {
			who: nameOf($.get(first)),
			level: t(`rights.level_${$.get(first).level}`)
		})]);
		$.append($$anchor, div_1);
	};
	var consequent_4 = ($$anchor) => {
		var div_2 = root_2();
		var node_5 = $.child(div_2);
		Icon(node_5, { name: "eye" });
		var span_2 = $.sibling(node_5);
		var text_4 = $.only_child(span_2, true);
		var node_6 = $.sibling(span_2, 2);
		var consequent_3 = ($$anchor) => {
			Button($$anchor, {
				onclick: () => void machine.tell({ do: "withdraw_request" }),
				"data-testid": "withdraw",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_5 = $.text();
					$.template_effect(($0) => $.set_text(text_5, $0), [() => t("app.withdraw")]);
					$.append($$anchor, text_5);
				},
				$$slots: { default: true }
			});
		};
		var alternate = ($$anchor) => {
			Button($$anchor, {
				onclick: () => void machine.tell({ do: "ask_for_command" }),
				"data-testid": "ask",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_6 = $.text();
					$.template_effect(($0) => $.set_text(text_6, $0), [() => t("app.ask")]);
					$.append($$anchor, text_6);
				},
				$$slots: { default: true }
			});
		};
		$.if(node_6, ($$render) => {
			if (machine.asksForCommand) $$render(consequent_3);
			else $$render(alternate, -1);
		});
		$.reset(div_2);
		$.template_effect(($0) => $.set_text(text_4, $0), [() => t(machine.asksForCommand ? "app.asked_text" : "app.watching_text")]);
		$.append($$anchor, div_2);
	};
	$.if(node, ($$render) => {
		if (machine.gate) $$render(consequent);
		else if (machine.link !== "open") $$render(consequent_1, 1);
		else if (machine.inCommand && $.get(first)) $$render(consequent_2, 2);
		else if (machine.holder !== null && !machine.inCommand) $$render(consequent_4, 3);
	});
	$.append($$anchor, fragment);
	$.pop();
}
export { Banner as default };
