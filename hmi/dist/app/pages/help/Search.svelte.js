import { http } from "../../lib/api/http.js";
import { has, language, t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import { go, route } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Explained from "./Explained.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/help/Search.svelte
var root = $.from_html(`<li><button type="button"><span class="kind s-1fh9388"> </span> <strong class="code"> </strong> <span class="text s-1fh9388"> </span></button></li>`);
var root_1 = $.from_html(`<li class="muted nothing s-1fh9388"> </li>`);
var root_2 = $.from_html(`<p> </p>`);
var root_3 = $.from_html(`<h2><span class="code"> </span> </h2> <!> <div class="row wrap"><!> <!></div>`, 1);
var root_4 = $.from_html(`<input class="search s-1fh9388" type="search" data-testid="help-search"/> <div class="results s-1fh9388"><ul class="scroll s-1fh9388" data-testid="help-results"></ul> <div class="detail scroll s-1fh9388"><!></div></div>`, 1);
function Search($$anchor, $$props) {
	$.push($$props, true);
	let sought = $.state($.proxy(route.item));
	let found = $.state([]);
	let chosen = $.state(null);
	let about = $.state(null);
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
	$.user_effect(() => {
		const one = $.get(chosen);
		$.set(about, null);
		if (one && one.kind !== "signal") http.explain(one.key, machine.dialect, language()).then((now) => one === $.get(chosen) ? $.set(about, now) : null, () => void 0);
	});
	const kind = (name) => has(`help.kind_${name}`) ? t(`help.kind_${name}`) : name;
	var fragment = root_4();
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
			classes = $.set_class(button, 1, "s-1fh9388", null, classes, { chosen: $.get(one) === $.get(chosen) });
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
	var div_1 = $.sibling(ul, 2);
	var node_1 = $.child(div_1);
	var consequent_4 = ($$anchor) => {
		var fragment_2 = root_3();
		var h2 = $.first_child(fragment_2);
		var span_2 = $.child(h2);
		var text_4 = $.only_child(span_2, true);
		var text_5 = $.sibling(span_2);
		$.reset(h2);
		var node_2 = $.sibling(h2, 2);
		var consequent_1 = ($$anchor) => {
			Explained($$anchor, { get about() {
				return $.get(about);
			} });
		};
		var alternate = ($$anchor) => {
			var p = root_2();
			var text_6 = $.only_child(p, true);
			$.template_effect(() => $.set_text(text_6, $.get(chosen).text));
			$.append($$anchor, p);
		};
		$.if(node_2, ($$render) => {
			if ($.get(about)?.found) $$render(consequent_1);
			else $$render(alternate, -1);
		});
		var div_2 = $.sibling(node_2, 2);
		var node_3 = $.child(div_2);
		var consequent_2 = ($$anchor) => {
			Button($$anchor, {
				icon: "system",
				onclick: () => go("offsets", "parameters", $.get(chosen).key),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_7 = $.text();
					$.template_effect(($0) => $.set_text(text_7, $0), [() => t("offsets.parameters")]);
					$.append($$anchor, text_7);
				},
				$$slots: { default: true }
			});
		};
		$.if(node_3, ($$render) => {
			if ($.get(chosen).kind === "parameter") $$render(consequent_2);
		});
		var node_4 = $.sibling(node_3, 2);
		var consequent_3 = ($$anchor) => {
			Button($$anchor, {
				icon: "diagnosis",
				onclick: () => go("diagnosis", "signals", $.get(chosen).key),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_8 = $.text();
					$.template_effect(($0) => $.set_text(text_8, $0), [() => t("diagnosis.signals")]);
					$.append($$anchor, text_8);
				},
				$$slots: { default: true }
			});
		};
		$.if(node_4, ($$render) => {
			if ($.get(chosen).kind === "signal" || $.get(chosen).kind === "address") $$render(consequent_3);
		});
		$.reset(div_2);
		$.template_effect(() => {
			$.set_text(text_4, $.get(chosen).key);
			$.set_text(text_5, ` ${$.get(chosen).title ?? ""}`);
		});
		$.append($$anchor, fragment_2);
	};
	var alternate_1 = ($$anchor) => {
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
	};
	$.if(node_1, ($$render) => {
		if ($.get(chosen)) $$render(consequent_4);
		else $$render(alternate_1, -1);
	});
	$.reset(div_1);
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
