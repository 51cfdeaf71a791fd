import { t } from "../../lib/i18n/index.svelte.js";
import Key from "../../lib/parts/Key.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/panel/Handwheel.svelte
var root = $.from_html(`<b> </b>`);
var root_1 = $.from_html(`<section class="s-9lvs4d"><h3> </h3> <div class="wheel s-9lvs4d"><div role="slider" tabindex="0" data-testid="handwheel"><i class="s-9lvs4d"></i></div> <div class="axes s-9lvs4d" role="group"></div></div></section>`);
function Handwheel($$anchor, $$props) {
	$.push($$props, true);
	/** The axis that it moves, from 1; 0 for none. */
	/** Counts of a whole turn, as handwheels of machines have them. */
	const TURN = 100;
	let angle = $.state(0);
	let wheel = $.state(void 0);
	let last = null;
	let rest = 0;
	let waiting = 0;
	let sent = false;
	/** Whether a program runs by it; it does with dry run alone (GSK990MC part 2, 6.4). */
	const drives = $.derived(() => machine.mode === "auto" && machine.lamps.has("LAMP_HDRV") && machine.status?.switches.dry_run === true);
	const ready = $.derived(() => machine.inCommand && (machine.mode === "handle" || $.get(drives)));
	function at(event) {
		const box = $.get(wheel).getBoundingClientRect();
		return Math.atan2(event.clientY - (box.top + box.height / 2), event.clientX - (box.left + box.width / 2));
	}
	function turn(counts) {
		if (!$.get(ready) || counts === 0) return;
		$.set(angle, $.get(angle) + counts / TURN * 360);
		waiting += counts;
		if (sent) return;
		sent = true;
		requestAnimationFrame(() => {
			sent = false;
			const now = waiting;
			waiting = 0;
			if (now !== 0 && $.get(ready)) machine.tell({
				do: "handwheel",
				counts: now
			});
		});
	}
	function move(event) {
		if (last === null) return;
		if (!(event.buttons & 1)) return void (last = null);
		const here = at(event);
		let by = here - last;
		if (by > Math.PI) by -= 2 * Math.PI;
		if (by < -Math.PI) by += 2 * Math.PI;
		last = here;
		rest += by / (2 * Math.PI) * TURN;
		const whole = Math.trunc(rest);
		rest -= whole;
		turn(whole);
	}
	/** Who looks away turns no more: what was not sent yet is not made up for. */
	function away() {
		last = null;
		waiting = 0;
	}
	function rolled(event) {
		if (event.ctrlKey || event.shiftKey) return;
		event.preventDefault();
		if (event.deltaY !== 0) turn(event.deltaY < 0 ? 1 : -1);
	}
	function keydown(event) {
		const by = {
			ArrowUp: 1,
			ArrowRight: 1,
			"+": 1,
			ArrowDown: -1,
			ArrowLeft: -1,
			"-": -1,
			PageUp: 10,
			PageDown: -10
		}[event.key];
		if (by === void 0 || event.ctrlKey || event.altKey) return;
		event.preventDefault();
		turn(by);
	}
	var section = root_1();
	$.event("blur", $.window, away);
	$.event("visibilitychange", $.document, () => document.visibilityState === "hidden" && away());
	var h3 = $.child(section);
	var text = $.only_child(h3, true);
	var div = $.sibling(h3, 2);
	var div_1 = $.child(div);
	let classes;
	let styles;
	$.bind_this(div_1, ($$value) => $.set(wheel, $$value), () => $.get(wheel));
	var div_2 = $.sibling(div_1, 2);
	$.each(div_2, 21, () => $$props.axes, ({ letter, place, wheel: key }) => key, ($$anchor, $$item) => {
		let letter = () => $.get($$item).letter;
		let place = () => $.get($$item).place;
		let key = () => $.get($$item).wheel;
		{
			let $0 = $.derived(() => $$props.axis === place());
			let $1 = $.derived(() => t("panel.wheel_of", { axis: letter() }));
			Key($$anchor, {
				get signal() {
					return key();
				},
				get chosen() {
					return $.get($0);
				},
				get label() {
					return $.get($1);
				},
				children: ($$anchor, $$slotProps) => {
					var b = root();
					var text_1 = $.only_child(b, true);
					$.template_effect(() => $.set_text(text_1, letter()));
					$.append($$anchor, b);
				},
				$$slots: { default: true }
			});
		}
	});
	$.reset(div_2);
	$.reset(div);
	$.reset(section);
	$.template_effect(($0, $1, $2, $3) => {
		$.set_text(text, $0);
		classes = $.set_class(div_1, 1, "dial s-9lvs4d", null, classes, { ready: $.get(ready) });
		$.set_attribute(div_1, "aria-label", $1);
		$.set_attribute(div_1, "aria-valuenow", $2);
		$.set_attribute(div_1, "aria-disabled", !$.get(ready));
		styles = $.set_style(div_1, "", styles, { "--angle": `${$.get(angle)}deg` });
		$.set_attribute(div_2, "aria-label", $3);
	}, [
		() => t("panel.wheel"),
		() => t("panel.wheel"),
		() => Math.round($.get(angle) / 360 * TURN),
		() => t("panel.wheel_axis")
	]);
	$.delegated("pointerdown", div_1, (event) => {
		if (event.button !== 0) return;
		$.get(wheel).setPointerCapture(event.pointerId);
		last = at(event);
		rest = 0;
	});
	$.delegated("pointermove", div_1, move);
	$.delegated("pointerup", div_1, () => last = null);
	$.event("pointercancel", div_1, () => last = null);
	$.event("lostpointercapture", div_1, () => last = null);
	$.delegated("contextmenu", div_1, (event) => event.preventDefault());
	$.event("wheel", div_1, rolled);
	$.delegated("keydown", div_1, keydown);
	$.append($$anchor, section);
	$.pop();
}
$.delegate([
	"pointerdown",
	"pointermove",
	"pointerup",
	"contextmenu",
	"keydown"
]);
export { Handwheel as default };
