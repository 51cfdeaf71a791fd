import { t } from "../lib/i18n/index.svelte.js";
import Dialog from "../lib/parts/Dialog.svelte.js";
import { go } from "../lib/routing.svelte.js";
import { machine } from "../lib/state/machine.svelte.js";
import { ui } from "../lib/state/ui.svelte.js";
import { pages } from "../pages/index.js";
import { modes, rapids } from "./keys.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/KeyMap.svelte
var root = $.from_html(`<kbd class="s-1u04ry5"> </kbd>`);
var root_1 = $.from_html(`<div class="s-1u04ry5"><dt class="s-1u04ry5"></dt> <dd class="s-1u04ry5"> </dd></div>`);
var root_2 = $.from_html(`<dl class="s-1u04ry5"></dl> <p class="muted"> </p>`, 1);
function KeyMap($$anchor, $$props) {
	$.push($$props, true);
	/** Keys that are held like those of the machine panel. */
	const heldKeys = {
		F9: "KEY_HOLD",
		F10: "KEY_START"
	};
	/** Axis keys; they move in the mode JOG alone, and only with Ctrl, so that a cursor key never moves a machine. */
	const axisKeys = {
		ArrowRight: "KEY_X+",
		ArrowLeft: "KEY_X-",
		ArrowUp: "KEY_Y+",
		ArrowDown: "KEY_Y-",
		PageUp: "KEY_Z+",
		PageDown: "KEY_Z-"
	};
	const down = /* @__PURE__ */ new Map();
	function typing(target) {
		return target instanceof HTMLElement && (target.isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName));
	}
	/** Switches of the panel that a key turns by a step: with the position that they have unless told, and the last one. */
	const overrideKeys = {
		ArrowUp: [
			"SWITCH_FEED",
			1,
			10,
			20
		],
		ArrowDown: [
			"SWITCH_FEED",
			-1,
			10,
			20
		],
		ArrowRight: [
			"SWITCH_SPINDLE",
			1,
			5,
			7
		],
		ArrowLeft: [
			"SWITCH_SPINDLE",
			-1,
			5,
			7
		]
	};
	/** Steps of the rapid override. */
	const rapidKeys = {
		PageUp: 1,
		PageDown: -1
	};
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
	function keydown(event) {
		const page = event.altKey && !event.shiftKey && /^Digit\d$/.test(event.code) ? pages[(Number(event.code.slice(5)) + 9) % 10] : void 0;
		const jogs = event.ctrlKey && !event.altKey && machine.status?.mode === "jog" && !typing(event.target);
		const chooses = event.altKey && event.shiftKey && !event.ctrlKey && !typing(event.target) && !event.defaultPrevented;
		const override = chooses ? overrideKeys[event.key] : void 0;
		const signal = heldKeys[event.key] ?? (jogs ? axisKeys[event.key] : void 0) ?? (chooses ? chosen(event) : void 0);
		if (page) go(page.id);
		else if (override) turn(...override);
		else if (event.key === "F1") {
			if (!event.repeat) machine.tell({
				do: "emergency_stop",
				pressed: true
			});
		} else if (event.key === "F8") {
			if (!event.repeat) machine.tell({ do: "reset" });
		} else if (signal) {
			if (!event.repeat && !down.has(event.code)) {
				if (!machine.inCommand) machine.refuse("not_in_command");
				else {
					down.set(event.code, signal);
					machine.hold(signal);
				}
			}
		} else if (event.key === "?" && !typing(event.target)) ui.keyMap = !ui.keyMap;
		else return;
		event.preventDefault();
	}
	function keyup(event) {
		const signal = down.get(event.code);
		if (signal) {
			down.delete(event.code);
			machine.release(signal);
		}
		if (event.key === "Control") letGo();
	}
	function letGo() {
		for (const signal of down.values()) machine.release(signal);
		down.clear();
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
			text: t("keymap.jog_xy")
		},
		{
			keys: ["Ctrl", "PgUp PgDn"],
			text: t("keymap.jog_z")
		},
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
	$.event("blur", $.window, letGo);
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
