import { http } from "../../lib/api/http.js";
import { moment, t } from "../../lib/i18n/index.svelte.js";
import { bytes } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Dialog from "../../lib/parts/Dialog.svelte.js";
import Icon from "../../lib/parts/Icon.svelte.js";
import Labelled from "../../lib/parts/Labelled.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { notify } from "../../lib/state/notices.svelte.js";
import { isRestored } from "./restoring.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/settings/Data.svelte
var root = $.from_html(`<button type="button" role="checkbox"><i class="s-1u4vlhf"></i><span> </span><small class="muted"> </small></button>`);
var root_1 = $.from_html(`<input class="code" spellcheck="false"/>`);
var root_2 = $.from_html(`<div class="data s-1u4vlhf"><div class="items s-1u4vlhf"></div> <div class="row wrap"><!> <!></div> <!> <div class="row wrap"><!> <!></div></div>`);
var root_3 = $.from_html(`<span class="muted hint s-1u4vlhf"> </span> <!> <input type="file" accept=".backup" hidden="" data-testid="bring-backup"/>`, 1);
var root_4 = $.from_html(`<a class="take s-1u4vlhf"><!></a>`);
var root_5 = $.from_html(`<tr><td><button type="button" class="pick code s-1u4vlhf"> </button></td><td class="right"> </td><td class="muted"> </td><td><!></td></tr>`);
var root_6 = $.from_html(`<tr><td class="muted"> </td></tr>`);
var root_7 = $.from_html(`<p class="muted note s-1u4vlhf"> </p>`);
var root_8 = $.from_html(`<table class="table" data-testid="backups"><tbody></tbody></table> <!>`, 1);
var root_9 = $.from_html(`<!> <!>`, 1);
var root_10 = $.from_html(`<p> </p>`);
var root_11 = $.from_html(`<p> </p> <p class="muted"> </p>`, 1);
var root_12 = $.from_html(`<!> <div role="region" data-testid="backup-drop"><!></div> <!> <!>`, 1);
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
		["ladder", 2],
		["counters", 2],
		["alarms", 3],
		["log", 3],
		["position", 2],
		["interrupted", 2]
	];
	/** All but what is of another moment, and is restored only by who names it. */
	const lasting = items.map(([name]) => name).filter((name) => name !== "position" && name !== "interrupted");
	let chosen = $.state($.proxy(lasting));
	let file = $.state(`${(/* @__PURE__ */ new Date()).toISOString().slice(0, 10)}.backup`);
	let asking = $.state(false);
	let busy = $.state(false);
	let backups = $.state([]);
	/** The level that takes a backup away. */
	const TAKES = 3;
	const restored = $.derived(() => $.get(chosen).filter(isRestored));
	const takes = $.derived(() => machine.level <= TAKES);
	let over = $.state(false);
	let picker = $.state(void 0);
	/** A backup that is brought, and has the name of one that there is. */
	let double = $.state(null);
	let replacing = $.state(false);
	/** The name that a file has in the folder of the memory. */
	const nameOf = (file) => `${file.name.replace(/\.backup$/i, "").replace(/[^\p{L}\p{N}._-]/gu, "_").replace(/^[._-]+/, "").slice(0, 30)}.backup`;
	function brought(files) {
		const given = files?.[0];
		if (!given) return;
		const name = nameOf(given);
		if (!$.get(backups).some((one) => one.name === name)) return void bring(name, given);
		$.set(double, {
			name,
			file: given
		});
		$.set(replacing, true);
	}
	async function bring(name, given) {
		$.set(replacing, false);
		$.set(busy, true);
		try {
			await http.bringBackup(name, given);
			$.set(file, name, true);
			notify({
				kind: "done",
				title: t("settings.brought", { file: name })
			});
		} catch (failed) {
			machine.refused(failed);
		}
		$.set(busy, false);
	}
	$.user_effect(() => {
		machine.changed("backups");
		if (machine.link === "open") http.backups().then((now) => $.set(backups, now), (failed) => machine.refused(failed));
	});
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
			items: $.get(restored)
		})) notify({
			kind: "done",
			title: t("settings.restored", { file: $.get(file) })
		});
		$.set(busy, false);
	}
	var fragment = root_12();
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
						classes = $.set_class(button, 1, "s-1u4vlhf", null, classes, { on: $1 });
						$.set_text(text, $2);
						$.set_text(text_1, $3);
					}, [
						() => $.get(chosen).includes(name()),
						() => $.get(chosen).includes(name()),
						() => t(`item.${name()}`),
						() => isRestored(name()) ? t("settings.restore_level", { level: level() }) : t("settings.backup_only")
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
					let $0 = $.derived(() => $.get(busy) || $.get(restored).length === 0);
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
	var div_4 = $.sibling(node, 2);
	let classes_1;
	var node_6 = $.child(div_4);
	{
		const actions = ($$anchor) => {
			var fragment_5 = $.comment();
			var node_7 = $.first_child(fragment_5);
			var consequent = ($$anchor) => {
				var fragment_6 = root_3();
				var span_1 = $.first_child(fragment_6);
				var text_6 = $.only_child(span_1, true);
				var node_8 = $.sibling(span_1, 2);
				Button(node_8, {
					icon: "upload",
					get busy() {
						return $.get(busy);
					},
					onclick: () => $.get(picker)?.click(),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_7 = $.text();
						$.template_effect(($0) => $.set_text(text_7, $0), [() => t("settings.bring")]);
						$.append($$anchor, text_7);
					},
					$$slots: { default: true }
				});
				var input_1 = $.sibling(node_8, 2);
				$.bind_this(input_1, ($$value) => $.set(picker, $$value), () => $.get(picker));
				$.template_effect(($0) => $.set_text(text_6, $0), [() => t("settings.bring_hint")]);
				$.delegated("change", input_1, (event) => {
					brought(event.currentTarget.files);
					event.currentTarget.value = "";
				});
				$.append($$anchor, fragment_6);
			};
			$.if(node_7, ($$render) => {
				if ($.get(takes)) $$render(consequent);
			});
			$.append($$anchor, fragment_5);
		};
		let $0 = $.derived(() => t("settings.backups"));
		Card(node_6, {
			get title() {
				return $.get($0);
			},
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_8 = root_8();
				var table = $.first_child(fragment_8);
				var tbody = $.child(table);
				$.each(tbody, 21, () => $.get(backups), (one) => one.name, ($$anchor, one) => {
					var tr = root_5();
					let classes_2;
					var td = $.child(tr);
					var button_1 = $.child(td);
					var text_8 = $.only_child(button_1, true);
					$.reset(td);
					var td_1 = $.sibling(td);
					var text_9 = $.only_child(td_1, true);
					var td_2 = $.sibling(td_1);
					var text_10 = $.only_child(td_2, true);
					var td_3 = $.sibling(td_2);
					var node_9 = $.child(td_3);
					var consequent_1 = ($$anchor) => {
						var a = root_4();
						var node_10 = $.child(a);
						Icon(node_10, { name: "download" });
						$.reset(a);
						$.template_effect(($0, $1, $2) => {
							$.set_attribute(a, "href", $0);
							$.set_attribute(a, "download", $.get(one).name);
							$.set_attribute(a, "aria-label", $1);
							$.set_attribute(a, "title", $2);
						}, [
							() => http.backup($.get(one).name),
							() => t("settings.take_away", { file: $.get(one).name }),
							() => t("settings.take_away", { file: $.get(one).name })
						]);
						$.append($$anchor, a);
					};
					$.if(node_9, ($$render) => {
						if ($.get(takes)) $$render(consequent_1);
					});
					$.reset(td_3);
					$.reset(tr);
					$.template_effect(($0, $1) => {
						$.set_attribute(tr, "data-backup", $.get(one).name);
						classes_2 = $.set_class(tr, 1, "s-1u4vlhf", null, classes_2, { chosen: $.get(one).name === $.get(file) });
						$.set_text(text_8, $.get(one).name);
						$.set_text(text_9, $0);
						$.set_text(text_10, $1);
					}, [() => bytes($.get(one).bytes), () => moment($.get(one).changed)]);
					$.delegated("click", button_1, () => $.set(file, $.get(one).name, true));
					$.append($$anchor, tr);
				}, ($$anchor) => {
					var tr_1 = root_6();
					var td_4 = $.child(tr_1);
					var text_11 = $.only_child(td_4, true);
					$.reset(tr_1);
					$.template_effect(($0) => $.set_text(text_11, $0), [() => t("settings.no_backups")]);
					$.append($$anchor, tr_1);
				});
				$.reset(tbody);
				$.reset(table);
				var node_11 = $.sibling(table, 2);
				var consequent_2 = ($$anchor) => {
					var p = root_7();
					var text_12 = $.only_child(p, true);
					$.template_effect(($0) => $.set_text(text_12, $0), [() => t("settings.take_level", { level: TAKES })]);
					$.append($$anchor, p);
				};
				$.if(node_11, ($$render) => {
					if (!$.get(takes)) $$render(consequent_2);
				});
				$.append($$anchor, fragment_8);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.reset(div_4);
	var node_12 = $.sibling(div_4, 2);
	{
		const actions = ($$anchor) => {
			var fragment_9 = root_9();
			var node_13 = $.first_child(fragment_9);
			Button(node_13, {
				onclick: () => $.set(replacing, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_13 = $.text();
					$.template_effect(($0) => $.set_text(text_13, $0), [() => t("app.cancel")]);
					$.append($$anchor, text_13);
				},
				$$slots: { default: true }
			});
			var node_14 = $.sibling(node_13, 2);
			Button(node_14, {
				kind: "danger",
				onclick: () => $.get(double) && void bring($.get(double).name, $.get(double).file),
				"data-testid": "bring-replace",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_14 = $.text();
					$.template_effect(($0) => $.set_text(text_14, $0), [() => t("program.replace")]);
					$.append($$anchor, text_14);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_9);
		};
		let $0 = $.derived(() => t("settings.bring_replace", { file: $.get(double)?.name ?? "" }));
		Dialog(node_12, {
			get title() {
				return $.get($0);
			},
			get open() {
				return $.get(replacing);
			},
			set open($$value) {
				$.set(replacing, $$value, true);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var p_1 = root_10();
				var text_15 = $.only_child(p_1, true);
				$.template_effect(($0) => $.set_text(text_15, $0), [() => t("settings.bring_replace_text")]);
				$.append($$anchor, p_1);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var node_15 = $.sibling(node_12, 2);
	{
		const actions = ($$anchor) => {
			var fragment_12 = root_9();
			var node_16 = $.first_child(fragment_12);
			Button(node_16, {
				onclick: () => $.set(asking, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_16 = $.text();
					$.template_effect(($0) => $.set_text(text_16, $0), [() => t("app.cancel")]);
					$.append($$anchor, text_16);
				},
				$$slots: { default: true }
			});
			var node_17 = $.sibling(node_16, 2);
			Button(node_17, {
				kind: "danger",
				onclick: () => void restore(),
				"data-testid": "restore-go",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_17 = $.text();
					$.template_effect(($0) => $.set_text(text_17, $0), [() => t("settings.restore")]);
					$.append($$anchor, text_17);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_12);
		};
		let $0 = $.derived(() => t("settings.restore_ask", { file: $.get(file) }));
		Dialog(node_15, {
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
				var fragment_15 = root_11();
				var p_2 = $.first_child(fragment_15);
				var text_18 = $.only_child(p_2, true);
				var p_3 = $.sibling(p_2, 2);
				var text_19 = $.only_child(p_3, true);
				$.template_effect(($0, $1) => {
					$.set_text(text_18, $0);
					$.set_text(text_19, $1);
				}, [() => t("settings.restore_text"), () => $.get(restored).map((name) => t(`item.${name}`)).join(", ")]);
				$.append($$anchor, fragment_15);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.template_effect(($0) => {
		classes_1 = $.set_class(div_4, 1, "drop s-1u4vlhf", null, classes_1, { over: $.get(over) });
		$.set_attribute(div_4, "aria-label", $0);
	}, [() => t("settings.backups")]);
	$.event("dragover", div_4, (event) => {
		event.preventDefault();
		$.set(over, $.get(takes), true);
	});
	$.event("dragleave", div_4, () => $.set(over, false));
	$.event("drop", div_4, (event) => {
		event.preventDefault();
		$.set(over, false);
		if ($.get(takes)) brought(event.dataTransfer?.files);
	});
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["click", "change"]);
export { Data as default };
