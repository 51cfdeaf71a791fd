import { t } from "../lib/i18n/index.svelte.js";
import Dialog from "../lib/parts/Dialog.svelte.js";
import { go } from "../lib/routing.svelte.js";
import { display } from "../lib/state/display.svelte.js";
import { machine } from "../lib/state/machine.svelte.js";
import { mdi } from "../lib/state/mdi.svelte.js";
import { notify } from "../lib/state/notices.svelte.js";
import { ui } from "../lib/state/ui.svelte.js";
import { pages } from "../pages/index.js";
import { axisKey, ended, heldKey, overrideKeys, rapidKeys } from "./bindings.js";
import { modes, rapids } from "./keys.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/KeyMap.svelte
var root = $.from_html(`<kbd class="s-1u04ry5"> </kbd>`);
var root_1 = $.from_html(`<div class="s-1u04ry5"><dt class="s-1u04ry5"></dt> <dd class="s-1u04ry5"> </dd></div>`);
var root_2 = $.from_html(`<dl class="s-1u04ry5"></dl> <p class="muted"> </p>`, 1);
function KeyMap($$anchor, $$props) {
	$.push($$props, true);
	/** Keys that are held, by where they are on the keyboard. */
	const down = /* @__PURE__ */ new Map();
	/** Keys that are down still, also those that a modifier has ended: with another one they are no key before they are let go. */
	const spent = /* @__PURE__ */ new Set();
	function typing(target) {
		return target instanceof HTMLElement && (target.isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName));
	}
	function turn(name, by, standard, last) {
		const position = (machine.status?.panel[name] ?? standard) + by;
		if (position >= 0 && position <= last) machine.tell({
			do: "switch",
			switch: name,
			position
		});
	}
	/** The key of the panel for a mode, or for the next step of the rapid override. */
	function chosen(event) {
		const mode = /^Digit([1-8])$/.exec(event.code)?.[1];
		if (mode) return modes[Number(mode) - 1]?.signal;
		const by = rapidKeys[event.key];
		if (by === void 0) return void 0;
		const now = rapids.findIndex((one) => machine.status?.lamps.includes(one.lamp));
		return rapids[Math.max(0, Math.min(rapids.length - 1, now + by))]?.signal;
	}
	function press(event, chord, signal) {
		if (event.repeat || spent.has(event.code)) return;
		spent.add(event.code);
		if (!machine.inCommand && signal !== "KEY_HOLD") return void machine.refuse("not_in_command");
		down.set(event.code, {
			signal,
			chord
		});
		machine.hold(signal);
	}
	function keydown(event) {
		letGo(({ chord }) => ended(chord, event));
		const page = event.altKey && !event.shiftKey && !typing(event.target) && /^Digit\d$/.test(event.code) ? pages[(Number(event.code.slice(5)) + 9) % 10] : void 0;
		const jog = machine.status?.mode === "jog" && !typing(event.target) ? axisKey(event, machine.axes.length) : void 0;
		const chooses = event.altKey && event.shiftKey && !event.ctrlKey && !typing(event.target) && !event.defaultPrevented;
		const override = chooses ? overrideKeys[event.key] : void 0;
		const signal = heldKey(event) ?? (chooses ? chosen(event) : void 0);
		if (page) {
			if (!event.repeat) go(...display.to(page.id));
		} else if (override) turn(...override);
		else if (event.key === "F1") {
			if (!event.repeat) machine.tell({
				do: "emergency_stop",
				pressed: true
			});
		} else if (event.key === "F8") {
			if (!event.repeat) machine.tell({ do: "reset" });
		} else if (jog) press(event, jog.chord, jog.signal);
		else if (signal === "KEY_START" && mdi.locksStart) {
			if (!event.repeat) notify({
				kind: "warning",
				title: t("panel.start_unsent")
			});
		} else if (signal) press(event, { key: event.key }, signal);
		else if (event.key === "?" && !typing(event.target)) ui.keyMap = !ui.keyMap;
		else return;
		event.preventDefault();
	}
	function keyup(event) {
		spent.delete(event.code);
		letGo(({ chord }, code) => code === event.code || ended(chord, event));
	}
	/** Lets keys go. */
	function letGo(which) {
		for (const [code, held] of down) {
			if (!which(held, code)) continue;
			down.delete(code);
			machine.release(held.signal);
		}
	}
	function away() {
		spent.clear();
		letGo(() => true);
	}
	const map = $.derived(() => [
		{
			keys: ["F1"],
			text: t("panel.emergency")
		},
		{
			keys: ["F8"],
			text: t("panel.reset")
		},
		{
			keys: ["F9"],
			text: t("panel.hold")
		},
		{
			keys: ["F10"],
			text: t("panel.start")
		},
		{
			keys: ["Ctrl", "← → ↑ ↓"],
			text: t("keymap.jog", { axes: machine.axes.slice(0, 2).join(" / ") })
		},
		...machine.axes.slice(2, 4).map((axes, place) => ({
			keys: [
				"Ctrl",
				"⇧",
				["↑ ↓", "← →"][place]
			],
			text: t("keymap.jog", { axes })
		})),
		{
			keys: ["↑ ↓", "+ −"],
			text: t("keymap.wheel")
		},
		...modes.map((mode, index) => ({
			keys: [
				"Alt",
				"⇧",
				String(index + 1)
			],
			text: t(`mode.${mode.mode}`)
		})),
		{
			keys: [
				"Alt",
				"⇧",
				"↑ ↓"
			],
			text: t("keymap.feed")
		},
		{
			keys: [
				"Alt",
				"⇧",
				"← →"
			],
			text: t("keymap.spindle")
		},
		{
			keys: [
				"Alt",
				"⇧",
				"PgUp PgDn"
			],
			text: t("keymap.rapid")
		},
		...pages.map((page, index) => ({
			keys: ["Alt", String((index + 1) % 10)],
			text: t(`${page.id}.title`)
		})),
		{
			keys: ["Ctrl", "S"],
			text: t("keymap.save")
		},
		{
			keys: ["Ctrl", "F"],
			text: t("keymap.find")
		},
		{
			keys: ["Ctrl", t("keymap.space")],
			text: t("keymap.complete")
		},
		{
			keys: ["?"],
			text: t("keymap.title")
		}
	]);
	$.event("keydown", $.window, keydown);
	$.event("keyup", $.window, keyup);
	$.event("blur", $.window, away);
	{
		let $0 = $.derived(() => t("keymap.title"));
		Dialog($$anchor, {
			get title() {
				return $.get($0);
			},
			wide: true,
			get open() {
				return ui.keyMap;
			},
			set open($$value) {
				ui.keyMap = $$value;
			},
			children: ($$anchor, $$slotProps) => {
				var fragment_1 = root_2();
				var dl = $.first_child(fragment_1);
				$.each(dl, 21, () => $.get(map), (row) => row.keys.join(" "), ($$anchor, row) => {
					var div = root_1();
					var dt = $.child(div);
					$.each(dt, 20, () => $.get(row).keys, (key) => key, ($$anchor, key) => {
						var kbd = root();
						var text = $.only_child(kbd, true);
						$.template_effect(() => $.set_text(text, key));
						$.append($$anchor, kbd);
					});
					$.reset(dt);
					var dd = $.sibling(dt, 2);
					var text_1 = $.only_child(dd, true);
					$.reset(div);
					$.template_effect(() => $.set_text(text_1, $.get(row).text));
					$.append($$anchor, div);
				});
				$.reset(dl);
				var p = $.sibling(dl, 2);
				var text_2 = $.only_child(p, true);
				$.template_effect(($0) => $.set_text(text_2, $0), [() => t("keymap.held")]);
				$.append($$anchor, fragment_1);
			},
			$$slots: { default: true }
		});
	}
	$.pop();
}
export { KeyMap as default };
