import { load, t } from "../lib/i18n/index.svelte.js";
import Button from "../lib/parts/Button.svelte.js";
import Icon from "../lib/parts/Icon.svelte.js";
import Segmented from "../lib/parts/Segmented.svelte.js";
import { machine } from "../lib/state/machine.svelte.js";
import { LANGUAGES, prefs } from "../lib/state/prefs.svelte.js";
import { ui } from "../lib/state/ui.svelte.js";
import LogIn from "./LogIn.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/shell/UserMenu.svelte
var root = $.from_html(`<button type="button" class="user s-1veqc3y" popovertarget="user-menu" data-testid="user"><!><span class="number"> </span></button> <div id="user-menu" popover="" class="s-1veqc3y"><h3 class="s-1veqc3y"> </h3> <div class="row"><span class="grow"><strong> </strong><br/><span class="muted"> </span></span> <!> <!></div> <h3 class="s-1veqc3y"> </h3> <div class="languages s-1veqc3y" data-testid="languages"></div> <h3 class="s-1veqc3y"> </h3> <!> <h3 class="s-1veqc3y"> </h3> <!></div> <!>`, 1);
function UserMenu($$anchor, $$props) {
	$.push($$props, true);
	let menu = $.state(void 0);
	const level = $.derived(() => machine.level);
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
	const coordinates = $.derived(() => ["absolute", "relative"].map((value) => ({
		value,
		label: t(`position.${value}`)
	})));
	function choose(language) {
		prefs.language = language;
		load(language);
	}
	var fragment = root();
	var button = $.first_child(fragment);
	var node = $.child(button);
	Icon(node, { name: "user" });
	var span = $.sibling(node);
	var text = $.only_child(span, true);
	$.reset(button);
	var div = $.sibling(button, 2);
	var h3 = $.child(div);
	var text_1 = $.only_child(h3, true);
	var div_1 = $.sibling(h3, 2);
	var span_1 = $.child(div_1);
	var strong = $.child(span_1);
	var text_2 = $.only_child(strong, true);
	var span_2 = $.sibling(strong, 2);
	var text_3 = $.only_child(span_2, true);
	$.reset(span_1);
	var node_1 = $.sibling(span_1, 2);
	var consequent = ($$anchor) => {
		Button($$anchor, {
			onclick: () => void machine.logOut(),
			"data-testid": "log-out",
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_4 = $.text();
				$.template_effect(($0) => $.set_text(text_4, $0), [() => t("rights.log_out")]);
				$.append($$anchor, text_4);
			},
			$$slots: { default: true }
		});
	};
	$.if(node_1, ($$render) => {
		if ($.get(level) < 5) $$render(consequent);
	});
	var node_2 = $.sibling(node_1, 2);
	Button(node_2, {
		kind: "primary",
		"data-testid": "log-in",
		onclick: () => {
			$.get(menu)?.hidePopover();
			ui.logIn = true;
		},
		children: ($$anchor, $$slotProps) => {
			$.next();
			var text_5 = $.text();
			$.template_effect(($0) => $.set_text(text_5, $0), [() => t("rights.log_in")]);
			$.append($$anchor, text_5);
		},
		$$slots: { default: true }
	});
	$.reset(div_1);
	var h3_1 = $.sibling(div_1, 2);
	var text_6 = $.only_child(h3_1, true);
	var div_2 = $.sibling(h3_1, 2);
	$.each(div_2, 20, () => LANGUAGES, (language) => language, ($$anchor, language) => {
		{
			let $0 = $.derived(() => prefs.language === language);
			Button($$anchor, {
				get pressed() {
					return $.get($0);
				},
				onclick: () => choose(language),
				get lang() {
					return language;
				},
				get "data-language"() {
					return language;
				},
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_7 = $.text();
					$.template_effect(() => $.set_text(text_7, names[language]));
					$.append($$anchor, text_7);
				},
				$$slots: { default: true }
			});
		}
	});
	$.reset(div_2);
	var h3_2 = $.sibling(div_2, 2);
	var text_8 = $.only_child(h3_2, true);
	var node_3 = $.sibling(h3_2, 2);
	{
		let $0 = $.derived(() => t("app.theme"));
		Segmented(node_3, {
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
	var h3_3 = $.sibling(node_3, 2);
	var text_9 = $.only_child(h3_3, true);
	var node_4 = $.sibling(h3_3, 2);
	{
		let $0 = $.derived(() => t("app.coordinates"));
		Segmented(node_4, {
			get options() {
				return $.get(coordinates);
			},
			get label() {
				return $.get($0);
			},
			get value() {
				return prefs.coordinates;
			},
			set value($$value) {
				prefs.coordinates = $$value;
			}
		});
	}
	$.reset(div);
	$.bind_this(div, ($$value) => $.set(menu, $$value), () => $.get(menu));
	var node_5 = $.sibling(div, 2);
	LogIn(node_5, {});
	$.template_effect(($0, $1, $2, $3, $4, $5, $6) => {
		$.set_attribute(button, "aria-label", $0);
		$.set_text(text, $.get(level));
		$.set_text(text_1, $1);
		$.set_text(text_2, $2);
		$.set_text(text_3, $3);
		$.set_text(text_6, $4);
		$.set_text(text_8, $5);
		$.set_text(text_9, $6);
	}, [
		() => t("app.user"),
		() => t("rights.title"),
		() => t(`rights.level_${$.get(level)}`),
		() => t("rights.level", { level: $.get(level) }),
		() => t("app.language"),
		() => t("app.theme"),
		() => t("app.coordinates")
	]);
	$.append($$anchor, fragment);
	$.pop();
}
export { UserMenu as default };
