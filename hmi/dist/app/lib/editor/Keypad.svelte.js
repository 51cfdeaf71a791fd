import { t } from "../i18n/index.svelte.js";
import { held } from "../parts/held.js";
import Icon from "../parts/Icon.svelte.js";
import { LAYERS, MOVES, copy, cut, endBlock, erase, paste, redo, type, undo } from "./keypad.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/editor/Keypad.svelte
var key = ($$anchor, name = $.noop, icon = $.noop, work = $.noop, pressed = $.noop) => {
	var button = root();
	var node = $.child(button);
	Icon(node, { get name() {
		return icon();
	} });
	$.reset(button);
	$.template_effect(($0, $1) => {
		$.set_attribute(button, "data-pad", name());
		$.set_attribute(button, "aria-label", $0);
		$.set_attribute(button, "title", $1);
		$.set_attribute(button, "aria-pressed", pressed());
	}, [() => t(`editor.key_${name()}`), () => t(`editor.key_${name()}`)]);
	$.delegated("click", button, function(...$$args) {
		work()?.apply(this, $$args);
	});
	$.append($$anchor, button);
};
var root = $.from_html(`<button type="button" class="s-xgav0k"><!></button>`);
var root_1 = $.from_html(`<button type="button" class="code s-xgav0k"> </button>`);
var root_2 = $.from_html(`<div class="keypad s-xgav0k" role="toolbar" tabindex="-1" data-testid="keypad"><div class="s-xgav0k"><!> <!></div> <div class="s-xgav0k"><!> <button type="button" data-pad="space" class="s-xgav0k"><!></button> <button type="button" class="eob s-xgav0k" data-pad="eob"> </button></div> <div class="s-xgav0k"><button type="button" class="code s-xgav0k" data-pad="layer"> </button> <!> <!> <!> <!> <!> <!> <!></div></div>`);
function Keypad($$anchor, $$props) {
	$.push($$props, true);
	const repeating = ($$anchor, name = $.noop, icon = $.noop, work = $.noop) => {
		var button_1 = root();
		var node_1 = $.child(button_1);
		Icon(node_1, { get name() {
			return icon();
		} });
		$.reset(button_1);
		$.attach(button_1, () => held(() => repeated(work())));
		$.template_effect(($0, $1) => {
			$.set_attribute(button_1, "data-pad", name());
			$.set_attribute(button_1, "aria-label", $0);
			$.set_attribute(button_1, "title", $1);
		}, [() => t(`editor.key_${name()}`), () => t(`editor.key_${name()}`)]);
		$.append($$anchor, button_1);
	};
	const typing = ($$anchor, text = $.noop) => {
		var button_2 = root_1();
		var text_1 = $.only_child(button_2, true);
		$.template_effect(() => {
			$.set_attribute(button_2, "data-pad", text());
			$.set_text(text_1, text());
		});
		$.delegated("click", button_2, () => act((it) => type(it, text())));
		$.append($$anchor, button_2);
	};
	const [PAUSE, EVERY] = [450, 60];
	let layer = $.state(0);
	let selecting = $.state(false);
	const keys = $.derived(() => LAYERS[$.get(layer)]);
	const next = $.derived(() => ($.get(layer) + 1) % LAYERS.length);
	const half = $.derived(() => Math.ceil($.get(keys).length / 2));
	function act(work, goesOn = false) {
		const it = $$props.view();
		if (!it) return;
		it.focus();
		work(it);
		if (!goesOn) $.set(selecting, false);
	}
	/** Acts at once, and again while it is held. */
	function repeated(work) {
		let timer;
		let isHeld = true;
		const again = (pause) => {
			work();
			if (isHeld) timer = setTimeout(() => again(EVERY), pause);
		};
		return {
			down: () => again(PAUSE),
			up: () => {
				isHeld = false;
				clearTimeout(timer);
			}
		};
	}
	var div = root_2();
	var div_1 = $.child(div);
	var node_2 = $.child(div_1);
	$.each(node_2, 16, () => $.get(keys).slice(0, $.get(half)), (text) => text, ($$anchor, text) => {
		typing($$anchor, () => text);
	});
	repeating($.sibling(node_2, 2), () => "erase", () => "erase", () => () => act(erase));
	$.reset(div_1);
	var div_2 = $.sibling(div_1, 2);
	var node_4 = $.child(div_2);
	$.each(node_4, 16, () => $.get(keys).slice($.get(half)), (text) => text, ($$anchor, text) => {
		typing($$anchor, () => text);
	});
	var button_3 = $.sibling(node_4, 2);
	var node_5 = $.child(button_3);
	Icon(node_5, { name: "space" });
	$.reset(button_3);
	var button_4 = $.sibling(button_3, 2);
	var text_2 = $.only_child(button_4, true);
	$.reset(div_2);
	var div_3 = $.sibling(div_2, 2);
	var button_5 = $.child(div_3);
	var text_3 = $.only_child(button_5);
	var node_6 = $.sibling(button_5, 2);
	$.each(node_6, 17, () => Object.entries(MOVES), ([name, { icon, move, select }]) => name, ($$anchor, $$item) => {
		var $$array = $.derived(() => $.to_array($.get($$item), 2));
		let name = () => $.get($$array)[0];
		let icon = () => $.get($$array)[1].icon;
		let move = () => $.get($$array)[1].move;
		let select = () => $.get($$array)[1].select;
		repeating($$anchor, name, icon, () => () => act($.get(selecting) ? select() : move(), true));
	});
	var node_7 = $.sibling(node_6, 2);
	key(node_7, () => "select", () => "select", () => () => $.set(selecting, !$.get(selecting)), () => $.get(selecting));
	var node_8 = $.sibling(node_7, 2);
	key(node_8, () => "copy", () => "copy", () => () => act(copy));
	var node_9 = $.sibling(node_8, 2);
	key(node_9, () => "cut", () => "cut", () => () => act(cut));
	var node_10 = $.sibling(node_9, 2);
	key(node_10, () => "paste", () => "paste", () => () => act(paste));
	var node_11 = $.sibling(node_10, 2);
	key(node_11, () => "undo", () => "undo", () => () => act(undo));
	key($.sibling(node_11, 2), () => "redo", () => "cw", () => () => act(redo));
	$.reset(div_3);
	$.reset(div);
	$.template_effect(($0, $1, $2, $3, $4, $5, $6, $7, $8) => {
		$.set_attribute(div, "aria-label", $0);
		$.set_attribute(button_3, "aria-label", $1);
		$.set_attribute(button_3, "title", $2);
		$.set_attribute(button_4, "title", $3);
		$.set_text(text_2, $4);
		$.set_attribute(button_5, "aria-label", $5);
		$.set_attribute(button_5, "title", $6);
		$.set_attribute(button_5, "aria-pressed", $.get(layer) > 0);
		$.set_text(text_3, `${$7 ?? ""}…${$8 ?? ""}`);
	}, [
		() => t("editor.keypad"),
		() => t("editor.key_space"),
		() => t("editor.key_space"),
		() => t("editor.key_end_of_block"),
		() => t("editor.key_eob"),
		() => t("editor.key_layer"),
		() => t("editor.key_layer"),
		() => LAYERS[$.get(next)].at(0),
		() => LAYERS[$.get(next)].at(-1)
	]);
	$.delegated("mousedown", div, (event) => event.preventDefault());
	$.delegated("click", button_3, () => act((it) => type(it, " ")));
	$.delegated("click", button_4, () => act((it) => $$props.online(it) || endBlock(it)));
	$.delegated("click", button_5, () => $.set(layer, $.get(next), true));
	$.append($$anchor, div);
	$.pop();
}
$.delegate(["click", "mousedown"]);
export { Keypad as default };
