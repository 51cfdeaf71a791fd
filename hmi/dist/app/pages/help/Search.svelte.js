import { http } from "../../lib/api/http.js";
import { has, language, t } from "../../lib/i18n/index.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import { route } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Details from "./Details.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/help/Search.svelte
var root = $.from_html(`<li><button type="button"><span class="kind s-17khlv6"> </span> <strong class="code"> </strong> <span class="text s-17khlv6"> </span></button></li>`);
var root_1 = $.from_html(`<li class="muted nothing s-17khlv6"> </li>`);
var root_2 = $.from_html(`<input class="search s-17khlv6" type="search" data-testid="help-search"/> <div class="results s-17khlv6"><ul class="scroll s-17khlv6" data-testid="help-results"></ul> <!></div>`, 1);
function Search($$anchor, $$props) {
	$.push($$props, true);
	let sought = $.state($.proxy(route.item));
	let found = $.state([]);
	let chosen = $.state(null);
	let asked = $.state("");
	$.user_effect(() => {
		if (route.item) $.set(sought, route.item, true);
	});
	$.user_effect(() => {
		const q = $.get(sought).trim();
		const lang = language();
		if (!q) {
			$.set(found, []);
			$.set(asked, "");
			return;
		}
		const timer = setTimeout(() => {
			http.search(q, lang).then((now) => {
				if (q !== $.get(sought).trim()) return;
				$.set(found, now);
				$.set(asked, q, true);
				$.set(chosen, now[0] ?? null);
			}, (failed) => machine.refused(failed));
		}, 150);
		return () => clearTimeout(timer);
	});
	const kind = (name) => has(`help.kind_${name}`) ? t(`help.kind_${name}`) : name;
	var fragment = root_2();
	var input = $.first_child(fragment);
	$.remove_input_defaults(input);
	$.autofocus(input, true);
	var div = $.sibling(input, 2);
	var ul = $.child(div);
	$.each(ul, 21, () => $.get(found), (one) => `${one.kind} ${one.key}`, ($$anchor, one) => {
		var li = root();
		var button = $.child(li);
		let classes;
		var span = $.child(button);
		var text = $.only_child(span, true);
		var strong = $.sibling(span, 2);
		var text_1 = $.only_child(strong, true);
		var span_1 = $.sibling(strong, 2);
		var text_2 = $.only_child(span_1, true);
		$.reset(button);
		$.reset(li);
		$.template_effect(($0) => {
			classes = $.set_class(button, 1, "s-17khlv6", null, classes, { chosen: $.get(one) === $.get(chosen) });
			$.set_text(text, $0);
			$.set_text(text_1, $.get(one).key);
			$.set_text(text_2, $.get(one).title || $.get(one).text);
		}, [() => kind($.get(one).kind)]);
		$.delegated("click", button, () => $.set(chosen, $.get(one)));
		$.append($$anchor, li);
	}, ($$anchor) => {
		var fragment_1 = $.comment();
		var node = $.first_child(fragment_1);
		var consequent = ($$anchor) => {
			var li_1 = root_1();
			var text_3 = $.only_child(li_1, true);
			$.template_effect(($0) => $.set_text(text_3, $0), [() => t("help.nothing")]);
			$.append($$anchor, li_1);
		};
		$.if(node, ($$render) => {
			if ($.get(asked)) $$render(consequent);
		});
		$.append($$anchor, fragment_1);
	});
	$.reset(ul);
	var node_1 = $.sibling(ul, 2);
	Details(node_1, {
		get entry() {
			return $.get(chosen);
		},
		children: ($$anchor, $$slotProps) => {
			{
				let $0 = $.derived(() => t("help.empty"));
				let $1 = $.derived(() => t("help.empty_text"));
				Empty($$anchor, {
					icon: "search",
					get title() {
						return $.get($0);
					},
					get text() {
						return $.get($1);
					}
				});
			}
		},
		$$slots: { default: true }
	});
	$.reset(div);
	$.template_effect(($0, $1) => {
		$.set_attribute(input, "placeholder", $0);
		$.set_attribute(input, "aria-label", $1);
	}, [() => t("help.placeholder"), () => t("app.search")]);
	$.bind_value(input, () => $.get(sought), ($$value) => $.set(sought, $$value));
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["click"]);
export { Search as default };
