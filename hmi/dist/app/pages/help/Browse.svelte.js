import { http } from "../../lib/api/http.js";
import { language, t } from "../../lib/i18n/index.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import VirtualList from "../../lib/parts/VirtualList.svelte.js";
import { go, route } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Explained from "./Explained.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/help/Browse.svelte
var root = $.from_html(`<button type="button"><strong class="code s-1via3p0"> </strong><span class="s-1via3p0"> </span></button>`);
var root_1 = $.from_html(`<p> </p>`);
var root_2 = $.from_html(`<h2><span class="code"> </span> </h2> <!> <div class="row wrap"><!> <!></div>`, 1);
var root_3 = $.from_html(`<p class="muted"> </p>`);
var root_4 = $.from_html(`<div class="row wrap"><!> <input class="grow" type="search" data-testid="browse-filter"/> <span class="muted number" data-testid="browse-count"> </span></div> <div class="browse s-1via3p0"><!> <div class="detail scroll s-1via3p0" data-testid="browse-detail"><!></div></div>`, 1);
function Browse($$anchor, $$props) {
	$.push($$props, true);
	/** What is listed: the first, and those beside it. */
	let wanted = $.state("");
	const kind = $.derived(() => $$props.kinds.includes($.get(wanted)) ? $.get(wanted) : $$props.kinds[0]);
	let all = $.state(null);
	let filter = $.state("");
	let about = $.state(null);
	const shown = $.derived(() => ($.get(all) ?? []).filter((one) => `${one.key} ${one.title} ${one.text}`.toLowerCase().includes($.get(filter).trim().toLowerCase())));
	const chosen = $.derived(() => ($.get(all) ?? []).find((one) => one.key === route.item) ?? null);
	$.user_effect(() => {
		const [of, lang] = [$.get(kind), language()];
		$.set(all, null);
		if (machine.link !== "open") return;
		http.list(of, lang).then((now) => of === $.get(kind) ? $.set(all, now) : null, (failed) => machine.refused(failed));
	});
	$.user_effect(() => {
		const one = $.get(chosen);
		$.set(about, null);
		if (one && one.kind !== "signal") http.explain(one.key, machine.dialect, language()).then((now) => one === $.get(chosen) ? $.set(about, now) : null, () => void 0);
	});
	var fragment = root_4();
	var div = $.first_child(fragment);
	var node = $.child(div);
	var consequent = ($$anchor) => {
		var bind_get = () => $.get(kind);
		var bind_set = (to) => $.set(wanted, to, true);
		{
			let $0 = $.derived(() => $$props.kinds.map((value) => ({
				value,
				label: t(`help.kind_${value}`)
			})));
			let $1 = $.derived(() => t("help.addresses"));
			Segmented($$anchor, {
				get value() {
					return bind_get();
				},
				set value($$value) {
					bind_set($$value);
				},
				get options() {
					return $.get($0);
				},
				get label() {
					return $.get($1);
				}
			});
		}
	};
	$.if(node, ($$render) => {
		if ($$props.kinds.length > 1) $$render(consequent);
	});
	var input = $.sibling(node, 2);
	$.remove_input_defaults(input);
	var span = $.sibling(input, 2);
	var text = $.only_child(span, true);
	$.reset(div);
	var div_1 = $.sibling(div, 2);
	var node_1 = $.child(div_1);
	{
		const row = ($$anchor, one = $.noop) => {
			var button = root();
			let classes;
			var strong = $.child(button);
			var text_1 = $.only_child(strong, true);
			var span_1 = $.sibling(strong);
			var text_2 = $.only_child(span_1, true);
			$.reset(button);
			$.template_effect(() => {
				$.set_attribute(button, "data-key", one().key);
				classes = $.set_class(button, 1, "s-1via3p0", null, classes, { chosen: one().key === $.get(chosen)?.key });
				$.set_text(text_1, one().key);
				$.set_text(text_2, one().kind === "parameter" || one().kind === "signal" ? one().text || one().title : one().title || one().text);
			});
			$.delegated("click", button, () => go("help", route.tab, one().key));
			$.append($$anchor, button);
		};
		let $0 = $.derived(() => t(`help.kind_${$.get(kind)}`));
		VirtualList(node_1, {
			get items() {
				return $.get(shown);
			},
			height: 2.8,
			get label() {
				return $.get($0);
			},
			row,
			$$slots: { row: true }
		});
	}
	var div_2 = $.sibling(node_1, 2);
	var node_2 = $.child(div_2);
	var consequent_4 = ($$anchor) => {
		var fragment_2 = root_2();
		var h2 = $.first_child(fragment_2);
		var span_2 = $.child(h2);
		var text_3 = $.only_child(span_2, true);
		var text_4 = $.sibling(span_2);
		$.reset(h2);
		var node_3 = $.sibling(h2, 2);
		var consequent_1 = ($$anchor) => {
			Explained($$anchor, { get about() {
				return $.get(about);
			} });
		};
		var alternate = ($$anchor) => {
			var p = root_1();
			var text_5 = $.only_child(p, true);
			$.template_effect(() => $.set_text(text_5, $.get(chosen).text));
			$.append($$anchor, p);
		};
		$.if(node_3, ($$render) => {
			if ($.get(about)?.found) $$render(consequent_1);
			else $$render(alternate, -1);
		});
		var div_3 = $.sibling(node_3, 2);
		var node_4 = $.child(div_3);
		var consequent_2 = ($$anchor) => {
			Button($$anchor, {
				icon: "system",
				onclick: () => go("offsets", "parameters", $.get(chosen).key),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_6 = $.text();
					$.template_effect(($0) => $.set_text(text_6, $0), [() => t("offsets.parameters")]);
					$.append($$anchor, text_6);
				},
				$$slots: { default: true }
			});
		};
		$.if(node_4, ($$render) => {
			if ($.get(chosen).kind === "parameter") $$render(consequent_2);
		});
		var node_5 = $.sibling(node_4, 2);
		var consequent_3 = ($$anchor) => {
			Button($$anchor, {
				icon: "diagnosis",
				onclick: () => go("diagnosis", "signals", $.get(chosen).key),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_7 = $.text();
					$.template_effect(($0) => $.set_text(text_7, $0), [() => t("diagnosis.signals")]);
					$.append($$anchor, text_7);
				},
				$$slots: { default: true }
			});
		};
		$.if(node_5, ($$render) => {
			if ($.get(chosen).kind === "signal") $$render(consequent_3);
		});
		$.reset(div_3);
		$.template_effect(() => {
			$.set_text(text_3, $.get(chosen).key);
			$.set_text(text_4, ` ${$.get(chosen).title ?? ""}`);
		});
		$.append($$anchor, fragment_2);
	};
	var alternate_1 = ($$anchor) => {
		var p_1 = root_3();
		var text_8 = $.only_child(p_1, true);
		$.template_effect(($0) => $.set_text(text_8, $0), [() => $.get(all) ? t("help.choose_row") : t("app.loading")]);
		$.append($$anchor, p_1);
	};
	$.if(node_2, ($$render) => {
		if ($.get(chosen)) $$render(consequent_4);
		else $$render(alternate_1, -1);
	});
	$.reset(div_2);
	$.reset(div_1);
	$.template_effect(($0, $1) => {
		$.set_attribute(input, "placeholder", $0);
		$.set_attribute(input, "aria-label", $1);
		$.set_attribute(span, "data-count", $.get(all)?.length ?? "");
		$.set_text(text, $.get(shown).length);
	}, [() => t("app.search"), () => t("app.search")]);
	$.bind_value(input, () => $.get(filter), ($$value) => $.set(filter, $$value));
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["click"]);
export { Browse as default };
