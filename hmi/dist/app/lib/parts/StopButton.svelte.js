import { t } from "../i18n/index.svelte.js";
import { machine } from "../state/machine.svelte.js";
import { held } from "./held.js";
import Icon from "./Icon.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/StopButton.svelte
var rest_excludes = /* @__PURE__ */ new Set([
	"$$slots",
	"$$events",
	"$$legacy",
	"flat"
]);
var root = $.from_html(`<small> </small>`);
var root_1 = $.from_html(`<button><!><span> </span> <!></button>`);
function StopButton($$anchor, $$props) {
	$.push($$props, true);
	let flat = $.prop(
		$$props,
		"flat",
		3,
		false
		/** The sign beside the text. */
	), rest = $.rest_props($$props, rest_excludes);
	const locked = $.derived(() => machine.gate === true);
	const emergency = $.derived(() => machine.status?.activity === "emergency");
	/** How long the key is held to release it, and how long after a press it does not begin to, ms. */
	const HELD_MS = 1e3;
	const FRESH_MS = 1e3;
	let since = 0;
	let timer;
	let releasing = $.state(false);
	$.user_effect(() => {
		if ($.get(emergency)) since = performance.now();
		else letGo();
	});
	function letGo() {
		clearTimeout(timer);
		$.set(releasing, false);
	}
	function press(at) {
		const latched = $.get(emergency) && at - since >= FRESH_MS;
		machine.tell({
			do: "emergency_stop",
			pressed: true
		});
		if (!latched) return;
		$.set(releasing, true);
		timer = setTimeout(() => {
			$.set(releasing, false);
			machine.tell({
				do: "emergency_stop",
				pressed: false
			});
		}, HELD_MS);
	}
	/** A press without a pointer or a key, as programs that read the screen aloud make it. */
	function click(event) {
		if (event.detail === 0) machine.tell({
			do: "emergency_stop",
			pressed: true
		});
	}
	var button = root_1();
	$.attribute_effect(button, ($0) => ({
		type: "button",
		...rest,
		class: "estop",
		onclick: click,
		disabled: $.get(locked),
		"aria-pressed": $.get(emergency),
		title: $0,
		[$.CLASS]: {
			flat: flat(),
			emergency: $.get(emergency),
			releasing: $.get(releasing)
		},
		[$.STYLE]: { "--held": `${HELD_MS}ms` }
	}), [() => $.get(locked) ? t("panel.emergency_locked") : $.get(emergency) ? t("panel.release_hint") : t("panel.emergency")], void 0, void 0, "s-6n0ffw");
	var node = $.child(button);
	{
		let $0 = $.derived(() => $.get(emergency) ? "undo" : "stop");
		Icon(node, { get name() {
			return $.get($0);
		} });
	}
	var span = $.sibling(node);
	var text = $.only_child(span, true);
	var node_1 = $.sibling(span, 2);
	var consequent = ($$anchor) => {
		var small = root();
		var text_1 = $.only_child(small, true);
		$.template_effect(($0) => $.set_text(text_1, $0), [() => t("rights.gate")]);
		$.append($$anchor, small);
	};
	$.if(node_1, ($$render) => {
		if ($.get(locked)) $$render(consequent);
	});
	$.reset(button);
	$.attach(button, () => held(() => ({
		down: press,
		up: letGo
	})));
	$.template_effect(($0) => $.set_text(text, $0), [() => $.get(emergency) ? t("panel.release") : t("panel.emergency")]);
	$.append($$anchor, button);
	$.pop();
}
export { StopButton as default };
