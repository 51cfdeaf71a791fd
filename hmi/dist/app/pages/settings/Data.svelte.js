import { t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Dialog from "../../lib/parts/Dialog.svelte.js";
import Labelled from "../../lib/parts/Labelled.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { notify } from "../../lib/state/notices.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/settings/Data.svelte
var root = $.from_html(`<button type="button" role="checkbox"><i class="s-1ygypkj"></i><span> </span><small class="muted"> </small></button>`);
var root_1 = $.from_html(`<input class="code" spellcheck="false"/>`);
var root_2 = $.from_html(`<div class="data s-1ygypkj"><div class="items s-1ygypkj"></div> <div class="row wrap"><!> <!></div> <!> <div class="row wrap"><!> <!></div></div>`);
var root_3 = $.from_html(`<!> <!>`, 1);
var root_4 = $.from_html(`<p> </p> <p class="muted"> </p>`, 1);
function Data($$anchor, $$props) {
	$.push($$props, true);
	/** Items and the level that may restore each. */
	const items = [
		["programs", 3],
		["parameters", 3],
		["offsets", 5],
		["zeros", 5],
		["reference-points", 3],
		["variables", 5],
		["pitch", 3],
		["plc", 2],
		["counters", 2],
		["alarms", 3],
		["log", 3],
		["position", 2]
	];
	/** All but what is of another moment, and is restored only by who names it. */
	const lasting = items.map(([name]) => name).filter((name) => name !== "position");
	let chosen = $.state($.proxy(lasting));
	let file = $.state(`${(/* @__PURE__ */ new Date()).toISOString().slice(0, 10)}.backup`);
	let asking = $.state(false);
	let busy = $.state(false);
	function toggle(name) {
		$.set(chosen, $.get(chosen).includes(name) ? $.get(chosen).filter((one) => one !== name) : [...$.get(chosen), name], true);
	}
	async function backUp() {
		$.set(busy, true);
		const whole = lasting.every((name) => $.get(chosen).includes(name));
		if (await machine.tell({
			do: "backup",
			file: $.get(file),
			items: whole ? [] : $.get(chosen)
		})) notify({
			kind: "done",
			title: t("settings.backed_up", { file: $.get(file) })
		});
		$.set(busy, false);
	}
	async function restore() {
		$.set(asking, false);
		$.set(busy, true);
		if (await machine.tell({
			do: "restore",
			file: $.get(file),
			items: $.get(chosen)
		})) notify({
			kind: "done",
			title: t("settings.restored", { file: $.get(file) })
		});
		$.set(busy, false);
	}
	var fragment = root_3();
	var node = $.first_child(fragment);
	{
		let $0 = $.derived(() => t("settings.data"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var div = root_2();
				var div_1 = $.child(div);
				$.each(div_1, 21, () => items, ([name, level]) => name, ($$anchor, $$item) => {
					var $$array = $.derived(() => $.to_array($.get($$item), 2));
					let name = () => $.get($$array)[0];
					let level = () => $.get($$array)[1];
					var button = root();
					let classes;
					var span = $.sibling($.child(button));
					var text = $.only_child(span, true);
					var small = $.sibling(span);
					var text_1 = $.only_child(small, true);
					$.reset(button);
					$.template_effect(($0, $1, $2, $3) => {
						$.set_attribute(button, "aria-checked", $0);
						classes = $.set_class(button, 1, "s-1ygypkj", null, classes, { on: $1 });
						$.set_text(text, $2);
						$.set_text(text_1, $3);
					}, [
						() => $.get(chosen).includes(name()),
						() => $.get(chosen).includes(name()),
						() => t(`item.${name()}`),
						() => t("settings.restore_level", { level: level() })
					]);
					$.delegated("click", button, () => toggle(name()));
					$.append($$anchor, button);
				});
				$.reset(div_1);
				var div_2 = $.sibling(div_1, 2);
				var node_1 = $.child(div_2);
				Button(node_1, {
					onclick: () => $.set(chosen, lasting, true),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_2 = $.text();
						$.template_effect(($0) => $.set_text(text_2, $0), [() => t("app.all")]);
						$.append($$anchor, text_2);
					},
					$$slots: { default: true }
				});
				var node_2 = $.sibling(node_1, 2);
				Button(node_2, {
					onclick: () => $.set(chosen, [], true),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_3 = $.text();
						$.template_effect(($0) => $.set_text(text_3, $0), [() => t("app.none")]);
						$.append($$anchor, text_3);
					},
					$$slots: { default: true }
				});
				$.reset(div_2);
				var node_3 = $.sibling(div_2, 2);
				{
					let $0 = $.derived(() => t("settings.file"));
					let $1 = $.derived(() => t("settings.file_hint"));
					Labelled(node_3, {
						get label() {
							return $.get($0);
						},
						get hint() {
							return $.get($1);
						},
						children: ($$anchor, $$slotProps) => {
							var input = root_1();
							$.remove_input_defaults(input);
							$.bind_value(input, () => $.get(file), ($$value) => $.set(file, $$value));
							$.append($$anchor, input);
						},
						$$slots: { default: true }
					});
				}
				var div_3 = $.sibling(node_3, 2);
				var node_4 = $.child(div_3);
				{
					let $0 = $.derived(() => $.get(chosen).length === 0 || !/^[\w.-]+\.backup$/.test($.get(file)));
					Button(node_4, {
						kind: "primary",
						icon: "save",
						get busy() {
							return $.get(busy);
						},
						get disabled() {
							return $.get($0);
						},
						onclick: () => void backUp(),
						"data-testid": "back-up",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_4 = $.text();
							$.template_effect(($0) => $.set_text(text_4, $0), [() => t("settings.back_up")]);
							$.append($$anchor, text_4);
						},
						$$slots: { default: true }
					});
				}
				var node_5 = $.sibling(node_4, 2);
				{
					let $0 = $.derived(() => $.get(busy) || $.get(chosen).length === 0);
					Button(node_5, {
						kind: "danger",
						icon: "undo",
						get disabled() {
							return $.get($0);
						},
						onclick: () => $.set(asking, true),
						"data-testid": "restore",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_5 = $.text();
							$.template_effect(($0) => $.set_text(text_5, $0), [() => t("settings.restore")]);
							$.append($$anchor, text_5);
						},
						$$slots: { default: true }
					});
				}
				$.reset(div_3);
				$.reset(div);
				$.append($$anchor, div);
			},
			$$slots: { default: true }
		});
	}
	var node_6 = $.sibling(node, 2);
	{
		const actions = ($$anchor) => {
			var fragment_5 = root_3();
			var node_7 = $.first_child(fragment_5);
			Button(node_7, {
				onclick: () => $.set(asking, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_6 = $.text();
					$.template_effect(($0) => $.set_text(text_6, $0), [() => t("app.cancel")]);
					$.append($$anchor, text_6);
				},
				$$slots: { default: true }
			});
			var node_8 = $.sibling(node_7, 2);
			Button(node_8, {
				kind: "danger",
				onclick: () => void restore(),
				"data-testid": "restore-go",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_7 = $.text();
					$.template_effect(($0) => $.set_text(text_7, $0), [() => t("settings.restore")]);
					$.append($$anchor, text_7);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_5);
		};
		let $0 = $.derived(() => t("settings.restore_ask", { file: $.get(file) }));
		Dialog(node_6, {
			get title() {
				return $.get($0);
			},
			get open() {
				return $.get(asking);
			},
			set open($$value) {
				$.set(asking, $$value, true);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_8 = root_4();
				var p = $.first_child(fragment_8);
				var text_8 = $.only_child(p, true);
				var p_1 = $.sibling(p, 2);
				var text_9 = $.only_child(p_1, true);
				$.template_effect(($0, $1) => {
					$.set_text(text_8, $0);
					$.set_text(text_9, $1);
				}, [() => t("settings.restore_text"), () => $.get(chosen).map((name) => t(`item.${name}`)).join(", ")]);
				$.append($$anchor, fragment_8);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["click"]);
export { Data as default };
