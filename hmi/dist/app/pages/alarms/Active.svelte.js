import { t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import ParameterSwitch from "../../lib/parts/ParameterSwitch.svelte.js";
import { go } from "../../lib/routing.svelte.js";
import { alarmText, messageText } from "../../lib/state/alarm-texts.svelte.js";
import { editing } from "../../lib/state/editing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { restart } from "../../lib/state/restart.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/alarms/Active.svelte
var root = $.from_html(`<span class="muted"> </span>`);
var root_1 = $.from_html(`<p data-testid="remedy" class="s-tveqzr"><strong class="s-tveqzr"> </strong> </p>`);
var root_2 = $.from_html(`<article data-testid="alarm"><!> <div class="grow"><header class="s-tveqzr"><span class="code"> </span><!></header> <h2 class="s-tveqzr"> </h2> <!> <div class="row wrap"><!> <!> <!></div></div></article>`);
var root_3 = $.from_html(`<article class="warning s-tveqzr"><!><div class="grow"><header class="s-tveqzr"><span class="code"> </span></header><h2 class="s-tveqzr"> </h2></div></article>`);
var root_4 = $.from_html(`<!> <!>`, 1);
var root_5 = $.from_html(`<article class="told s-tveqzr" data-testid="interrupted"><!> <div class="grow"><h2 class="s-tveqzr"> </h2> <p class="code s-tveqzr"> </p> <!></div></article>`);
function Active($$anchor, $$props) {
	$.push($$props, true);
	const alarms = $.derived(() => machine.status?.alarms ?? []);
	const interrupted = $.derived(() => machine.status?.interrupted ?? null);
	const program = $.derived(() => machine.status?.program.running ?? machine.status?.program.selected ?? "");
	/** Blocks of MDI and a program that comes from outside are no programs of the memory; what they call is. */
	const isTyped = $.derived(() => $.get(program) === "MDI" || machine.status?.program_mode === "mdi" && !machine.status.program.running);
	const isSent = $.derived(() => $.get(program) === "DNC" || machine.status?.program_mode === "dnc" && !machine.status.program.running);
	function toProgram(line) {
		if ($.get(isTyped)) return go("program", "mdi");
		editing.goTo($.get(program), line);
		go("program", "edit", $.get(program));
	}
	var fragment = root_4();
	var node = $.first_child(fragment);
	var consequent = ($$anchor) => {
		{
			let $0 = $.derived(() => t("alarms.none"));
			let $1 = $.derived(() => t("alarms.none_text"));
			Empty($$anchor, {
				icon: "check",
				get title() {
					return $.get($0);
				},
				get text() {
					return $.get($1);
				}
			});
		}
	};
	var alternate_1 = ($$anchor) => {
		var fragment_2 = root_4();
		var node_1 = $.first_child(fragment_2);
		$.each(node_1, 17, () => $.get(alarms), $.index, ($$anchor, alarm) => {
			const about = $.derived(() => alarmText($.get(alarm)));
			var article = root_2();
			let classes;
			var node_2 = $.child(article);
			Icon(node_2, {
				name: "alarms",
				size: "2rem"
			});
			var div = $.sibling(node_2, 2);
			var header = $.child(div);
			var span = $.child(header);
			var text = $.only_child(span, true);
			var node_3 = $.sibling(span);
			var consequent_1 = ($$anchor) => {
				var span_1 = root();
				var text_1 = $.only_child(span_1);
				$.template_effect(($0) => $.set_text(text_1, `${$.get(program) ?? ""} · ${$0 ?? ""}`), [() => t("graphics.line", { line: $.get(alarm).line })]);
				$.append($$anchor, span_1);
			};
			$.if(node_3, ($$render) => {
				if ($.get(alarm).line > 0) $$render(consequent_1);
			});
			$.reset(header);
			var h2 = $.sibling(header, 2);
			var text_2 = $.only_child(h2, true);
			var node_4 = $.sibling(h2, 2);
			var consequent_2 = ($$anchor) => {
				var p = root_1();
				var strong = $.child(p);
				var text_3 = $.only_child(strong, true);
				var text_4 = $.sibling(strong);
				$.reset(p);
				$.template_effect(($0) => {
					$.set_text(text_3, $0);
					$.set_text(text_4, ` ${$.get(about).help ?? ""}`);
				}, [() => t("alarms.remedy")]);
				$.append($$anchor, p);
			};
			$.if(node_4, ($$render) => {
				if ($.get(about).help) $$render(consequent_2);
			});
			var div_1 = $.sibling(node_4, 2);
			var node_5 = $.child(div_1);
			var consequent_3 = ($$anchor) => {
				ParameterSwitch($$anchor, {});
			};
			var alternate = ($$anchor) => {
				Button($$anchor, {
					kind: "primary",
					icon: "reset",
					onclick: () => void machine.tell({ do: "reset" }),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_5 = $.text();
						$.template_effect(($0) => $.set_text(text_5, $0), [() => t("panel.reset")]);
						$.append($$anchor, text_5);
					},
					$$slots: { default: true }
				});
			};
			$.if(node_5, ($$render) => {
				if ($.get(alarm).id === "gsk990mc:0100") $$render(consequent_3);
				else $$render(alternate, -1);
			});
			var node_6 = $.sibling(node_5, 2);
			var consequent_4 = ($$anchor) => {
				Button($$anchor, {
					icon: "edit",
					onclick: () => toProgram($.get(alarm).line),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_6 = $.text();
						$.template_effect(($0) => $.set_text(text_6, $0), [() => t("alarms.to_program")]);
						$.append($$anchor, text_6);
					},
					$$slots: { default: true }
				});
			};
			$.if(node_6, ($$render) => {
				if ($.get(alarm).line > 0 && $.get(program) && !$.get(isSent)) $$render(consequent_4);
			});
			var node_7 = $.sibling(node_6, 2);
			Button(node_7, {
				icon: "help",
				onclick: () => go("help", "search", $.get(alarm).id),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_7 = $.text();
					$.template_effect(($0) => $.set_text(text_7, $0), [() => t("help.title")]);
					$.append($$anchor, text_7);
				},
				$$slots: { default: true }
			});
			$.reset(div_1);
			$.reset(div);
			$.reset(article);
			$.template_effect(() => {
				classes = $.set_class(article, 1, "s-tveqzr", null, classes, { warning: $.get(alarm).warning });
				$.set_text(text, $.get(alarm).id);
				$.set_text(text_2, $.get(about).text || $.get(alarm).id);
			});
			$.append($$anchor, article);
		});
		var node_8 = $.sibling(node_1, 2);
		$.each(node_8, 16, () => machine.messages, (message) => message, ($$anchor, message) => {
			var article_1 = root_3();
			var node_9 = $.child(article_1);
			Icon(node_9, {
				name: "plc",
				size: "2rem"
			});
			var div_2 = $.sibling(node_9);
			var header_1 = $.child(div_2);
			var span_2 = $.child(header_1);
			var text_8 = $.only_child(span_2, true);
			$.reset(header_1);
			var h2_1 = $.sibling(header_1);
			var text_9 = $.only_child(h2_1, true);
			$.reset(div_2);
			$.reset(article_1);
			$.template_effect(($0) => {
				$.set_attribute(article_1, "data-message", message);
				$.set_text(text_8, message);
				$.set_text(text_9, $0);
			}, [() => messageText(message)]);
			$.append($$anchor, article_1);
		});
		$.append($$anchor, fragment_2);
	};
	$.if(node, ($$render) => {
		if ($.get(alarms).length === 0 && machine.messages.length === 0) $$render(consequent);
		else $$render(alternate_1, -1);
	});
	var node_10 = $.sibling(node, 2);
	var consequent_5 = ($$anchor) => {
		var article_2 = root_5();
		var node_11 = $.child(article_2);
		Icon(node_11, {
			name: "undo",
			size: "2rem"
		});
		var div_3 = $.sibling(node_11, 2);
		var h2_2 = $.child(div_3);
		var text_10 = $.only_child(h2_2, true);
		var p_1 = $.sibling(h2_2, 2);
		var text_11 = $.only_child(p_1, true);
		var node_12 = $.sibling(p_1, 2);
		Button(node_12, {
			icon: "undo",
			onclick: () => {
				restart.ask(null);
				go("program", "run");
			},
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_12 = $.text();
				$.template_effect(($0) => $.set_text(text_12, $0), [() => t("restart.take_up")]);
				$.append($$anchor, text_12);
			},
			$$slots: { default: true }
		});
		$.reset(div_3);
		$.reset(article_2);
		$.template_effect(($0) => {
			$.set_text(text_10, $0);
			$.set_text(text_11, $.get(interrupted).text);
		}, [() => t("restart.interrupted", {
			program: $.get(interrupted).file,
			line: $.get(interrupted).line
		})]);
		$.append($$anchor, article_2);
	};
	$.if(node_10, ($$render) => {
		if ($.get(interrupted) && $.get(alarms).length === 0) $$render(consequent_5);
	});
	$.append($$anchor, fragment);
	$.pop();
}
export { Active as default };
