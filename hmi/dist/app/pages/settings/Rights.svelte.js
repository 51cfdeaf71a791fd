import { t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Labelled from "../../lib/parts/Labelled.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { notify } from "../../lib/state/notices.svelte.js";
import { ui } from "../../lib/state/ui.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/settings/Rights.svelte
var root = $.from_html(`<li><span class="number"> </span> <div><strong> </strong><p class="muted s-16225tr"> </p></div></li>`);
var root_1 = $.from_html(`<ol class="s-16225tr"></ol> <div class="row"><!> <!></div>`, 1);
var root_2 = $.from_html(`<option> </option>`);
var root_3 = $.from_html(`<select></select>`);
var root_4 = $.from_html(`<input type="password" autocomplete="new-password"/>`);
var root_5 = $.from_html(`<form class="s-16225tr"><!> <!> <!> <!></form>`);
var root_6 = $.from_html(`<div class="grid s-16225tr"><!> <!></div>`);
function Rights($$anchor, $$props) {
	$.push($$props, true);
	const level = $.derived(() => machine.level);
	let target = $.state(4);
	let password = $.state("");
	let again = $.state("");
	async function set(event) {
		event.preventDefault();
		if ($.get(password) !== $.get(again)) return;
		if (await machine.tell({
			do: "set_password",
			level: $.get(target),
			password: $.get(password)
		})) {
			notify({
				kind: "done",
				title: t("settings.password_set", { level: t(`rights.level_${$.get(target)}`) })
			});
			$.set(password, $.set(again, ""), true);
		}
	}
	var div = root_6();
	var node = $.child(div);
	{
		let $0 = $.derived(() => t("rights.title"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var fragment = root_1();
				var ol = $.first_child(fragment);
				$.each(ol, 20, () => [
					5,
					4,
					3,
					2,
					1
				], (one) => one, ($$anchor, one) => {
					var li = root();
					let classes;
					var span = $.child(li);
					var text = $.only_child(span, true);
					var div_1 = $.sibling(span, 2);
					var strong = $.child(div_1);
					var text_1 = $.only_child(strong, true);
					var p = $.sibling(strong);
					var text_2 = $.only_child(p, true);
					$.reset(div_1);
					$.reset(li);
					$.template_effect(($0, $1) => {
						classes = $.set_class(li, 1, "s-16225tr", null, classes, { now: one === $.get(level) });
						$.set_text(text, one);
						$.set_text(text_1, $0);
						$.set_text(text_2, $1);
					}, [() => t(`rights.level_${one}`), () => t(`settings.may_${one}`)]);
					$.append($$anchor, li);
				});
				$.reset(ol);
				var div_2 = $.sibling(ol, 2);
				var node_1 = $.child(div_2);
				Button(node_1, {
					kind: "primary",
					icon: "user",
					onclick: () => ui.logIn = true,
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_3 = $.text();
						$.template_effect(($0) => $.set_text(text_3, $0), [() => t("rights.log_in")]);
						$.append($$anchor, text_3);
					},
					$$slots: { default: true }
				});
				var node_2 = $.sibling(node_1, 2);
				var consequent = ($$anchor) => {
					Button($$anchor, {
						onclick: () => void machine.logOut(),
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_4 = $.text();
							$.template_effect(($0) => $.set_text(text_4, $0), [() => t("rights.log_out")]);
							$.append($$anchor, text_4);
						},
						$$slots: { default: true }
					});
				};
				$.if(node_2, ($$render) => {
					if ($.get(level) < 5) $$render(consequent);
				});
				$.reset(div_2);
				$.append($$anchor, fragment);
			},
			$$slots: { default: true }
		});
	}
	var node_3 = $.sibling(node, 2);
	{
		let $0 = $.derived(() => t("settings.password"));
		Card(node_3, {
			get title() {
				return $.get($0);
			},
			children: ($$anchor, $$slotProps) => {
				var form = root_5();
				var node_4 = $.child(form);
				{
					let $0 = $.derived(() => t("rights.level_label"));
					Labelled(node_4, {
						get label() {
							return $.get($0);
						},
						children: ($$anchor, $$slotProps) => {
							var select = root_3();
							$.each(select, 20, () => [
								4,
								3,
								2,
								1
							], (one) => one, ($$anchor, one) => {
								var option = root_2();
								var text_5 = $.only_child(option);
								var option_value = {};
								$.template_effect(($0) => {
									$.set_text(text_5, `${one ?? ""} · ${$0 ?? ""}`);
									if (option_value !== (option_value = one)) option.value = (option.__value = option_value) ?? "";
								}, [() => t(`rights.level_${one}`)]);
								$.append($$anchor, option);
							});
							$.reset(select);
							$.init_select(select);
							$.bind_select_value(select, () => $.get(target), ($$value) => $.set(target, $$value));
							$.append($$anchor, select);
						},
						$$slots: { default: true }
					});
				}
				var node_5 = $.sibling(node_4, 2);
				{
					let $0 = $.derived(() => t("settings.new_password"));
					Labelled(node_5, {
						get label() {
							return $.get($0);
						},
						children: ($$anchor, $$slotProps) => {
							var input = root_4();
							$.remove_input_defaults(input);
							$.bind_value(input, () => $.get(password), ($$value) => $.set(password, $$value));
							$.append($$anchor, input);
						},
						$$slots: { default: true }
					});
				}
				var node_6 = $.sibling(node_5, 2);
				{
					let $0 = $.derived(() => t("settings.password_again"));
					let $1 = $.derived(() => $.get(again) && $.get(again) !== $.get(password) ? t("settings.differ") : "");
					Labelled(node_6, {
						get label() {
							return $.get($0);
						},
						get hint() {
							return $.get($1);
						},
						children: ($$anchor, $$slotProps) => {
							var input_1 = root_4();
							$.remove_input_defaults(input_1);
							$.bind_value(input_1, () => $.get(again), ($$value) => $.set(again, $$value));
							$.append($$anchor, input_1);
						},
						$$slots: { default: true }
					});
				}
				var node_7 = $.sibling(node_6, 2);
				{
					let $0 = $.derived(() => !$.get(password) || $.get(password) !== $.get(again));
					Button(node_7, {
						type: "submit",
						kind: "primary",
						get disabled() {
							return $.get($0);
						},
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_6 = $.text();
							$.template_effect(($0) => $.set_text(text_6, $0), [() => t("settings.set_password")]);
							$.append($$anchor, text_6);
						},
						$$slots: { default: true }
					});
				}
				$.reset(form);
				$.event("submit", form, set);
				$.append($$anchor, form);
			},
			$$slots: { default: true }
		});
	}
	$.reset(div);
	$.append($$anchor, div);
	$.pop();
}
export { Rights as default };
