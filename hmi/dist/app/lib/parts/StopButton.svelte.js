import { t } from "../i18n/index.svelte.js";
import { machine } from "../state/machine.svelte.js";
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
var root = $.from_html(`<button><!><span> </span></button>`);
function StopButton($$anchor, $$props) {
	$.push($$props, true);
	let flat = $.prop(
		$$props,
		"flat",
		3,
		false
		/** The sign beside the text. */
	), rest = $.rest_props($$props, rest_excludes);
	const emergency = $.derived(() => machine.status?.activity === "emergency");
	function stop() {
		machine.tell({
			do: "emergency_stop",
			pressed: !$.get(emergency)
		});
	}
	var button = root();
	$.attribute_effect(button, () => ({
		type: "button",
		...rest,
		class: "estop",
		onclick: stop,
		"aria-pressed": $.get(emergency),
		[$.CLASS]: {
			flat: flat(),
			emergency: $.get(emergency)
		}
	}), void 0, void 0, void 0, "s-1eiflxa");
	var node = $.child(button);
	{
		let $0 = $.derived(() => $.get(emergency) ? "undo" : "stop");
		Icon(node, { get name() {
			return $.get($0);
		} });
	}
	var span = $.sibling(node);
	var text = $.only_child(span, true);
	$.reset(button);
	$.template_effect(($0) => $.set_text(text, $0), [() => $.get(emergency) ? t("panel.release") : t("panel.emergency")]);
	$.append($$anchor, button);
	$.pop();
}
export { StopButton as default };
