import { http } from "../../lib/api/http.js";
import { has, language, t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import { go, route } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Details from "./Details.svelte.js";
import { findLocal } from "./local.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/help/Search.svelte
var root = $.from_html(`<strong class="code"> </strong> <span class="text s-4r8now"> </span>`, 1);
var root_1 = $.from_html(`<span class="text long s-4r8now"> </span>`);
var root_2 = $.from_html(`<li><button type="button"><span class="kind s-4r8now"> </span> <!></button></li>`);
var root_3 = $.from_html(`<li class="muted nothing s-4r8now"> </li>`);
var root_4 = $.from_html(`<div class="detail stack scroll" data-testid="help-local"><h2> </h2> <p> </p> <div class="row"><!></div></div>`);
var root_5 = $.from_html(`<input class="search s-4r8now" type="search" data-testid="help-search"/> <div class="results s-4r8now"><ul class="scroll s-4r8now" data-testid="help-results"></ul> <!></div>`, 1);
function Search($$anchor, $$props) {
	$.push($$props, true);
	let sought = $.state($.proxy(route.item));
	let found = $.state([]);
	let asked = $.state("");
	/** What was chosen, of `rows`; the first one unless told. */
	let picked = $.state("");
	const local = $.derived(() => findLocal($.get(sought), t));
	/** What is called so stands before what only speaks of it. */
	const rows = $.derived(() => [
		...$.get(local).filter((one) => one.isNear).map((one) => ({
			id: `${one.kind} ${one.id}`,
			local: one,
			entry: null
		})),
		...$.get(found).map((one) => ({
			id: `${one.kind} ${one.key}`,
			local: null,
			entry: one
		})),
		...$.get(local).filter((one) => !one.isNear).map((one) => ({
			id: `${one.kind} ${one.id}`,
			local: one,
			entry: null
		}))
	]);
	const chosen = $.derived(() => $.get(rows).find((one) => one.id === $.get(picked)) ?? $.get(rows)[0]);
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
				$.set(picked, "");
			}, (failed) => machine.refused(failed));
		}, 150);
		return () => clearTimeout(timer);
	});
	/** A code or alarm is told by its title, a parameter or signal by what it means. */
	const said = (one) => one.kind === "parameter" || one.kind === "signal" ? one.text || one.title : one.title || one.text;
	const kind = (name) => has(`help.kind_${name}`) ? t(`help.kind_${name}`) : name;
	var fragment = root_5();
	var input = $.first_child(fragment);
	$.remove_input_defaults(input);
	$.autofocus(input, true);
	var div = $.sibling(input, 2);
	var ul = $.child(div);
	$.each(ul, 21, () => $.get(rows), (one) => one.id, ($$anchor, one) => {
		var li = root_2();
		var button = $.child(li);
		let classes;
		var span = $.child(button);
		var text_1 = $.only_child(span, true);
		var node = $.sibling(span, 2);
		var consequent = ($$anchor) => {
			var fragment_1 = root();
			var strong = $.first_child(fragment_1);
			var text_2 = $.only_child(strong, true);
			var span_1 = $.sibling(strong, 2);
			var text_3 = $.only_child(span_1, true);
			$.template_effect(($0) => {
				$.set_text(text_2, $.get(one).entry.key);
				$.set_text(text_3, $0);
			}, [() => said($.get(one).entry)]);
			$.append($$anchor, fragment_1);
		};
		var alternate = ($$anchor) => {
			var span_2 = root_1();
			var text_4 = $.only_child(span_2, true);
			$.template_effect(() => $.set_text(text_4, $.get(one).local?.title));
			$.append($$anchor, span_2);
		};
		$.if(node, ($$render) => {
			if ($.get(one).entry) $$render(consequent);
			else $$render(alternate, -1);
		});
		$.reset(button);
		$.reset(li);
		$.template_effect(($0) => {
			$.set_attribute(button, "data-found", $.get(one).id);
			classes = $.set_class(button, 1, "s-4r8now", null, classes, { chosen: $.get(one) === $.get(chosen) });
			$.set_text(text_1, $0);
		}, [() => kind($.get(one).local?.kind ?? $.get(one).entry?.kind ?? "")]);
		$.delegated("click", button, () => $.set(picked, $.get(one).id, true));
		$.append($$anchor, li);
	}, ($$anchor) => {
		var fragment_2 = $.comment();
		var node_1 = $.first_child(fragment_2);
		var consequent_1 = ($$anchor) => {
			var li_1 = root_3();
			var text_5 = $.only_child(li_1, true);
			$.template_effect(($0) => $.set_text(text_5, $0), [() => t("help.nothing")]);
			$.append($$anchor, li_1);
		};
		$.if(node_1, ($$render) => {
			if ($.get(asked)) $$render(consequent_1);
		});
		$.append($$anchor, fragment_2);
	});
	$.reset(ul);
	var node_2 = $.sibling(ul, 2);
	var consequent_2 = ($$anchor) => {
		const computed_const = $.derived(() => {
			return $.get(chosen).local;
		});
		var div_1 = root_4();
		var h2 = $.child(div_1);
		var text_6 = $.only_child(h2, true);
		var p = $.sibling(h2, 2);
		var text_7 = $.only_child(p, true);
		var div_2 = $.sibling(p, 2);
		var node_3 = $.child(div_2);
		Button(node_3, {
			icon: "play",
			onclick: () => go(...$.get(computed_const).page),
			"data-testid": "help-go",
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_8 = $.text();
				$.template_effect(($0) => $.set_text(text_8, $0), [() => t("help.go")]);
				$.append($$anchor, text_8);
			},
			$$slots: { default: true }
		});
		$.reset(div_2);
		$.reset(div_1);
		$.template_effect(() => {
			$.set_text(text_6, $.get(computed_const).title);
			$.set_text(text_7, $.get(computed_const).text);
		});
		$.append($$anchor, div_1);
	};
	var alternate_1 = ($$anchor) => {
		{
			let $0 = $.derived(() => $.get(chosen)?.entry ?? null);
			Details($$anchor, {
				get entry() {
					return $.get($0);
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
		}
	};
	$.if(node_2, ($$render) => {
		if ($.get(chosen)?.local) $$render(consequent_2);
		else $$render(alternate_1, -1);
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
