import { load, t } from "../lib/i18n/index.svelte.js";
import Button from "../lib/parts/Button.svelte.js";
import Dialog from "../lib/parts/Dialog.svelte.js";
import Icon from "../lib/parts/Icon.svelte.js";
import Segmented from "../lib/parts/Segmented.svelte.js";
import { machine } from "../lib/state/machine.svelte.js";
import { LANGUAGES, prefs } from "../lib/state/prefs.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/Welcome.svelte
var root = $.from_html(`<!> <!>`, 1);
var root_1 = $.from_html(`<li class="s-jokyvg"><!><span> </span></li>`);
var root_2 = $.from_html(`<p class="muted"> </p> <div class="languages s-jokyvg"></div> <!> <ul class="s-jokyvg"></ul>`, 1);
function Welcome($$anchor, $$props) {
	$.push($$props, true);
	const names = {
		en: "English",
		zh: "中文",
		ru: "Русский",
		es: "Español",
		tr: "Türkçe"
	};
	const themes = $.derived(() => [
		"system",
		"light",
		"dark"
	].map((value) => ({
		value,
		label: t(`app.theme_${value}`)
	})));
	const points = [
		["hand", "command"],
		["stop", "stop"],
		["keyboard", "keys"]
	];
	function start() {
		prefs.welcomed = true;
		if (machine.holder === null && !machine.inCommand) machine.tell({ do: "take_command" });
	}
	var bind_get = () => !prefs.welcomed && machine.gate === false;
	var bind_set = (open) => prefs.welcomed = !open;
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var node = $.first_child(fragment_1);
			Button(node, {
				onclick: () => prefs.welcomed = true,
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text = $.text();
					$.template_effect(($0) => $.set_text(text, $0), [() => t("welcome.watch")]);
					$.append($$anchor, text);
				},
				$$slots: { default: true }
			});
			var node_1 = $.sibling(node, 2);
			Button(node_1, {
				kind: "primary",
				icon: "hand",
				onclick: start,
				"data-testid": "welcome-start",
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_1 = $.text();
					$.template_effect(($0) => $.set_text(text_1, $0), [() => t("welcome.start")]);
					$.append($$anchor, text_1);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("welcome.title"));
		Dialog($$anchor, {
			get open() {
				return bind_get();
			},
			set open($$value) {
				bind_set($$value);
			},
			get title() {
				return $.get($0);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_4 = root_2();
				var p = $.first_child(fragment_4);
				var text_2 = $.only_child(p, true);
				var div = $.sibling(p, 2);
				$.each(div, 20, () => LANGUAGES, (language) => language, ($$anchor, language) => {
					{
						let $0 = $.derived(() => prefs.language === language);
						Button($$anchor, {
							get pressed() {
								return $.get($0);
							},
							get lang() {
								return language;
							},
							get "data-language"() {
								return language;
							},
							onclick: () => {
								prefs.language = language;
								load(language);
							},
							children: ($$anchor, $$slotProps) => {
								$.next();
								var text_3 = $.text();
								$.template_effect(() => $.set_text(text_3, names[language]));
								$.append($$anchor, text_3);
							},
							$$slots: { default: true }
						});
					}
				});
				$.reset(div);
				var node_2 = $.sibling(div, 2);
				{
					let $0 = $.derived(() => t("app.theme"));
					Segmented(node_2, {
						get options() {
							return $.get(themes);
						},
						get label() {
							return $.get($0);
						},
						get value() {
							return prefs.theme;
						},
						set value($$value) {
							prefs.theme = $$value;
						}
					});
				}
				var ul = $.sibling(node_2, 2);
				$.each(ul, 21, () => points, ([icon, name]) => name, ($$anchor, $$item) => {
					var $$array = $.derived(() => $.to_array($.get($$item), 2));
					let icon = () => $.get($$array)[0];
					let name = () => $.get($$array)[1];
					var li = root_1();
					var node_3 = $.child(li);
					Icon(node_3, { get name() {
						return icon();
					} });
					var span = $.sibling(node_3);
					var text_4 = $.only_child(span, true);
					$.reset(li);
					$.template_effect(($0) => $.set_text(text_4, $0), [() => t(`welcome.${name()}`)]);
					$.append($$anchor, li);
				});
				$.reset(ul);
				$.template_effect(($0) => $.set_text(text_2, $0), [() => t("welcome.machine", {
					machine: machine.version?.machine ?? "…",
					dialect: machine.version?.dialect ?? "…"
				})]);
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
export { Welcome as default };
