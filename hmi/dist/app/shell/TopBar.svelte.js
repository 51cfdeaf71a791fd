import Digits from "../lib/digits/Digits.svelte.js";
import { t } from "../lib/i18n/index.svelte.js";
import Icon from "../lib/parts/Icon.svelte.js";
import { go, href } from "../lib/routing.svelte.js";
import { alarmText, messageText } from "../lib/state/alarm-texts.svelte.js";
import { machine } from "../lib/state/machine.svelte.js";
import { prefs } from "../lib/state/prefs.svelte.js";
import { ui } from "../lib/state/ui.svelte.js";
import { tone } from "./tone.js";
import UserMenu from "./UserMenu.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/TopBar.svelte
var root = $.from_html(`<span class="line muted"><!></span>`);
var root_1 = $.from_html(`<a class="program code s-1221wew"> <!></a>`);
var root_2 = $.from_html(`<span class="mode s-1221wew" data-testid="mode"> </span> <!>`, 1);
var root_3 = $.from_html(`<button type="button" data-testid="alarm-strip"><!><span class="code"> </span><span class="text s-1221wew"> </span></button>`);
var root_4 = $.from_html(`<span class="message s-1221wew"><!><span class="text s-1221wew"> </span></span>`);
var root_5 = $.from_html(`<header class="s-1221wew"><div data-testid="activity"><i class="s-1221wew"></i> <span> </span></div> <!> <div class="middle s-1221wew"><!></div> <button type="button" data-testid="command"><!> <span class="wide s-1221wew"> </span></button> <!> <button type="button" class="icon s-1221wew" data-testid="keyboard"><!></button> <button type="button" class="icon s-1221wew" data-testid="panel-toggle"><!></button> <time class="number s-1221wew"> </time></header>`);
function TopBar($$anchor, $$props) {
	$.push($$props, true);
	const status = $.derived(() => machine.status);
	const activity = $.derived(() => $.get(status)?.activity ?? "idle");
	const standing = $.derived(() => $.get(status)?.alarms.find((alarm) => !alarm.warning) ?? $.get(status)?.alarms[0]);
	const program = $.derived(() => $.get(status)?.program);
	const line = $.derived(() => $.get(program)?.line || $.get(program)?.cursor || 0);
	const hasLine = $.derived(() => $.get(line) > 0);
	/** As it is drawn. */
	const lineOf = ({ program }) => `:${program.line || program.cursor}`;
	/** Room for its number, ch: of four digits, and of more where a program has them. */
	const room = $.derived(() => Math.max(4, String($.get(line)).length));
	const clock = $.derived(() => new Intl.DateTimeFormat(prefs.language, {
		hour: "2-digit",
		minute: "2-digit"
	}));
	const MINUTE_MS = 6e4;
	const minuteNow = () => Math.floor(Date.now() / MINUTE_MS);
	let minute = $.state($.proxy(minuteNow()));
	$.user_effect(() => {
		const timer = setInterval(() => $.set(minute, minuteNow(), true), 1e3);
		return () => clearInterval(timer);
	});
	function command() {
		if (machine.inCommand) machine.giveCommand();
		else if (machine.holder !== null) machine.tell({ do: machine.asksForCommand ? "withdraw_request" : "ask_for_command" });
		else machine.tell({ do: "take_command" });
	}
	var header = root_5();
	var div = $.child(header);
	var span = $.sibling($.child(div), 2);
	var text = $.only_child(span, true);
	$.reset(div);
	var node = $.sibling(div, 2);
	var consequent_2 = ($$anchor) => {
		var fragment = root_2();
		var span_1 = $.first_child(fragment);
		var text_1 = $.only_child(span_1, true);
		var node_1 = $.sibling(span_1, 2);
		var consequent_1 = ($$anchor) => {
			var a = root_1();
			var text_2 = $.child(a, true);
			var node_2 = $.sibling(text_2);
			var consequent = ($$anchor) => {
				var span_2 = root();
				let styles;
				var node_3 = $.child(span_2);
				Digits(node_3, { of: lineOf });
				$.reset(span_2);
				$.template_effect(() => styles = $.set_style(span_2, "", styles, { width: `${$.get(room) + 1}ch` }));
				$.append($$anchor, span_2);
			};
			$.if(node_2, ($$render) => {
				if ($.get(hasLine)) $$render(consequent);
			});
			$.reset(a);
			$.template_effect(($0) => {
				$.set_attribute(a, "href", $0);
				$.set_text(text_2, $.get(program).running ?? $.get(program).selected);
			}, [() => href("program", "run")]);
			$.append($$anchor, a);
		};
		$.if(node_1, ($$render) => {
			if ($.get(program)?.running || $.get(program)?.selected) $$render(consequent_1);
		});
		$.template_effect(($0) => $.set_text(text_1, $0), [() => t(`mode.${$.get(status).mode}`)]);
		$.append($$anchor, fragment);
	};
	$.if(node, ($$render) => {
		if ($.get(status)) $$render(consequent_2);
	});
	var div_1 = $.sibling(node, 2);
	var node_4 = $.child(div_1);
	var consequent_3 = ($$anchor) => {
		var button = root_3();
		let classes;
		var node_5 = $.child(button);
		Icon(node_5, { name: "alarms" });
		var span_3 = $.sibling(node_5);
		var text_3 = $.only_child(span_3, true);
		var span_4 = $.sibling(span_3);
		var text_4 = $.only_child(span_4, true);
		$.reset(button);
		$.template_effect(($0) => {
			classes = $.set_class(button, 1, "alarm s-1221wew", null, classes, { warning: $.get(standing).warning });
			$.set_text(text_3, $.get(standing).id);
			$.set_text(text_4, $0);
		}, [() => alarmText($.get(standing)).text]);
		$.delegated("click", button, () => go("alarms"));
		$.append($$anchor, button);
	};
	var consequent_4 = ($$anchor) => {
		var span_5 = root_4();
		var node_6 = $.child(span_5);
		Icon(node_6, { name: "program" });
		var span_6 = $.sibling(node_6);
		var text_5 = $.only_child(span_6, true);
		$.reset(span_5);
		$.template_effect(() => $.set_text(text_5, machine.programMessage));
		$.append($$anchor, span_5);
	};
	var consequent_5 = ($$anchor) => {
		var span_7 = root_4();
		var node_7 = $.child(span_7);
		Icon(node_7, { name: "alarms" });
		var span_8 = $.sibling(node_7);
		var text_6 = $.only_child(span_8, true);
		$.reset(span_7);
		$.template_effect(($0) => $.set_text(text_6, $0), [() => machine.messages.map(messageText).join(" · ")]);
		$.append($$anchor, span_7);
	};
	$.if(node_4, ($$render) => {
		if ($.get(standing)) $$render(consequent_3);
		else if (machine.programMessage) $$render(consequent_4, 1);
		else if (machine.messages.length) $$render(consequent_5, 2);
	});
	$.reset(div_1);
	var button_1 = $.sibling(div_1, 2);
	let classes_1;
	var node_8 = $.child(button_1);
	{
		let $0 = $.derived(() => machine.inCommand ? "hand" : "eye");
		Icon(node_8, { get name() {
			return $.get($0);
		} });
	}
	var span_9 = $.sibling(node_8, 2);
	var text_7 = $.only_child(span_9, true);
	$.reset(button_1);
	var node_9 = $.sibling(button_1, 2);
	UserMenu(node_9, {});
	var button_2 = $.sibling(node_9, 2);
	var node_10 = $.child(button_2);
	Icon(node_10, { name: "keyboard" });
	$.reset(button_2);
	var button_3 = $.sibling(button_2, 2);
	var node_11 = $.child(button_3);
	Icon(node_11, { name: "panel" });
	$.reset(button_3);
	var time = $.sibling(button_3, 2);
	var text_8 = $.only_child(time, true);
	$.reset(header);
	$.template_effect(($0, $1, $2, $3, $4, $5, $6, $7) => {
		$.set_class(div, 1, `state ${$0 ?? ""}`, "s-1221wew");
		$.set_attribute(div, "data-activity", $.get(activity));
		$.set_text(text, $1);
		classes_1 = $.set_class(button_1, 1, "who s-1221wew", null, classes_1, { you: machine.inCommand });
		button_1.disabled = machine.link !== "open";
		$.set_text(text_7, $2);
		$.set_attribute(button_2, "aria-label", $3);
		$.set_attribute(button_2, "title", $4);
		$.set_attribute(button_3, "aria-pressed", prefs.panel);
		$.set_attribute(button_3, "aria-label", $5);
		$.set_attribute(button_3, "title", $6);
		$.set_text(text_8, $7);
	}, [
		() => machine.link === "open" ? tone($.get(activity)) : "lost",
		() => machine.link === "open" ? t(`activity.${$.get(activity)}`) : t("app.no_connection"),
		() => machine.inCommand ? t("app.in_command") : machine.holder === null ? t("app.take_command") : t(machine.asksForCommand ? "app.asked" : "app.watching"),
		() => t("keymap.title"),
		() => t("keymap.title"),
		() => t("panel.title"),
		() => t("panel.title"),
		() => $.get(clock).format($.get(minute) * MINUTE_MS)
	]);
	$.delegated("click", button_1, command);
	$.delegated("click", button_2, () => ui.keyMap = true);
	$.delegated("click", button_3, () => prefs.panel = !prefs.panel);
	$.append($$anchor, header);
	$.pop();
}
$.delegate(["click"]);
export { TopBar as default };
