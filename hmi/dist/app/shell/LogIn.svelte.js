import { HttpError } from "../lib/api/http.js";
import { t } from "../lib/i18n/index.svelte.js";
import Button from "../lib/parts/Button.svelte.js";
import Dialog from "../lib/parts/Dialog.svelte.js";
import Labelled from "../lib/parts/Labelled.svelte.js";
import { machine } from "../lib/state/machine.svelte.js";
import { notify } from "../lib/state/notices.svelte.js";
import { ui } from "../lib/state/ui.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/LogIn.svelte
var root = $.from_html(`<!> <!>`, 1);
var root_1 = $.from_html(`<p> </p>`);
var root_2 = $.from_html(`<option> </option>`);
var root_3 = $.from_html(`<select></select>`);
var root_4 = $.from_html(`<input type="password" autocomplete="current-password" data-testid="password"/>`);
var root_5 = $.from_html(`<p class="wrong s-av1tew" role="alert"> </p>`);
var root_6 = $.from_html(`<!> <form id="log-in-form" class="s-av1tew"><!> <!> <!></form>`, 1);
function LogIn($$anchor, $$props) {
	$.push($$props, true);
	let level = $.state(4);
	let password = $.state("");
	let wrong = $.state("");
	let busy = $.state(false);
	$.user_effect(() => {
		if (machine.gate) ui.logIn = true;
	});
	async function logIn(event) {
		event.preventDefault();
		$.set(busy, true);
		$.set(wrong, "");
		try {
			await machine.logIn($.get(level), $.get(password));
			ui.logIn = false;
			notify({
				kind: "done",
				title: t("rights.logged_in", { level: t(`rights.level_${$.get(level)}`) })
			});
		} catch (refused) {
			if (refused instanceof HttpError && refused.status === 429) $.set(wrong, t("rights.too_often"), true);
			else $.set(wrong, t("rights.wrong"), true);
		} finally {
			$.set(busy, false);
			$.set(password, "");
		}
	}
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var node = $.first_child(fragment_1);
			Button(node, {
				onclick: () => ui.logIn = false,
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text = $.text();
					$.template_effect(($0) => $.set_text(text, $0), [() => t("app.cancel")]);
					$.append($$anchor, text);
				},
				$$slots: { default: true }
			});
			var node_1 = $.sibling(node, 2);
			Button(node_1, {
				kind: "primary",
				type: "submit",
				form: "log-in-form",
				get busy() {
					return $.get(busy);
				},
				"data-testid": "log-in-go",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_1 = $.text();
					$.template_effect(($0) => $.set_text(text_1, $0), [() => t("rights.log_in")]);
					$.append($$anchor, text_1);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("rights.log_in"));
		Dialog($$anchor, {
			get title() {
				return $.get($0);
			},
			get open() {
				return ui.logIn;
			},
			set open($$value) {
				ui.logIn = $$value;
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_4 = root_6();
				var node_2 = $.first_child(fragment_4);
				var consequent = ($$anchor) => {
					var p = root_1();
					var text_2 = $.only_child(p, true);
					$.template_effect(($0) => $.set_text(text_2, $0), [() => t("rights.gate_text")]);
					$.append($$anchor, p);
				};
				$.if(node_2, ($$render) => {
					if (machine.gate) $$render(consequent);
				});
				var form = $.sibling(node_2, 2);
				var node_3 = $.child(form);
				{
					let $0 = $.derived(() => t("rights.level_label"));
					Labelled(node_3, {
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
								var text_3 = $.only_child(option);
								var option_value = {};
								$.template_effect(($0) => {
									$.set_text(text_3, `${one ?? ""} · ${$0 ?? ""}`);
									if (option_value !== (option_value = one)) option.value = (option.__value = option_value) ?? "";
								}, [() => t(`rights.level_${one}`)]);
								$.append($$anchor, option);
							});
							$.reset(select);
							$.init_select(select);
							$.bind_select_value(select, () => $.get(level), ($$value) => $.set(level, $$value));
							$.append($$anchor, select);
						},
						$$slots: { default: true }
					});
				}
				var node_4 = $.sibling(node_3, 2);
				{
					let $0 = $.derived(() => t("rights.password"));
					Labelled(node_4, {
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
				var node_5 = $.sibling(node_4, 2);
				var consequent_1 = ($$anchor) => {
					var p_1 = root_5();
					var text_4 = $.only_child(p_1, true);
					$.template_effect(() => $.set_text(text_4, $.get(wrong)));
					$.append($$anchor, p_1);
				};
				$.if(node_5, ($$render) => {
					if ($.get(wrong)) $$render(consequent_1);
				});
				$.reset(form);
				$.event("submit", form, logIn);
				$.append($$anchor, fragment_4);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.pop();
}
export { LogIn as default };
