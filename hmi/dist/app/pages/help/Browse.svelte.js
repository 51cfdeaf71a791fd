import { http } from "../../lib/api/http.js";
import { language, t } from "../../lib/i18n/index.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import VirtualList from "../../lib/parts/VirtualList.svelte.js";
import { go, route } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Details from "./Details.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/help/Browse.svelte
var root = $.from_html(`<button type="button"><strong class="code s-bf32di"> </strong><span class="s-bf32di"> </span></button>`);
var root_1 = $.from_html(`<p class="muted"> </p>`);
var root_2 = $.from_html(`<div class="row wrap"><!> <input class="grow" type="search" data-testid="browse-filter"/> <span class="muted number" data-testid="browse-count"> </span></div> <div class="browse s-bf32di"><!> <!></div>`, 1);
function Browse($$anchor, $$props) {
	$.push($$props, true);
	/** What is listed: the first, and those beside it. */
	let wanted = $.state("");
	const kind = $.derived(() => $$props.kinds.includes($.get(wanted)) ? $.get(wanted) : $$props.kinds[0]);
	let all = $.state(null);
	let filter = $.state("");
	const shown = $.derived(() => ($.get(all) ?? []).filter((one) => `${one.key} ${one.title} ${one.text}`.toLowerCase().includes($.get(filter).trim().toLowerCase())));
	const chosen = $.derived(() => ($.get(all) ?? []).find((one) => one.key === route.item) ?? null);
	$.user_effect(() => {
		const [of, lang] = [$.get(kind), language()];
		$.set(all, null);
		if (machine.link !== "open") return;
		http.list(of, lang).then((now) => of === $.get(kind) ? $.set(all, now) : null, (failed) => machine.refused(failed));
	});
	var fragment = root_2();
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
				classes = $.set_class(button, 1, "s-bf32di", null, classes, { chosen: one().key === $.get(chosen)?.key });
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
	var node_2 = $.sibling(node_1, 2);
	Details(node_2, {
		get entry() {
			return $.get(chosen);
		},
		children: ($$anchor, $$slotProps) => {
			var p = root_1();
			var text_3 = $.only_child(p, true);
			$.template_effect(($0) => $.set_text(text_3, $0), [() => $.get(all) ? t("help.choose_row") : t("app.loading")]);
			$.append($$anchor, p);
		},
		$$slots: { default: true }
	});
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
