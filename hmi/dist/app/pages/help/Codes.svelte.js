import { http } from "../../lib/api/http.js";
import { language, t } from "../../lib/i18n/index.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { go, route } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Explained from "./Explained.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/help/Codes.svelte
var root = $.from_html(`<button type="button"><strong class="code"> </strong><span> </span></button>`);
var root_1 = $.from_html(`<h3 class="s-sx33g"> </h3><!>`, 1);
var root_2 = $.from_html(`<p class="muted"> </p>`);
var root_3 = $.from_html(`<h2><span class="code"> </span></h2> <!>`, 1);
var root_4 = $.from_html(`<div class="row"><!></div> <div class="codes s-sx33g"><div class="list scroll"></div> <div class="detail scroll"><!></div></div>`, 1);
function Codes($$anchor, $$props) {
	$.push($$props, true);
	let all = $.state([]);
	let about = $.state(null);
	let kind = $.state("G");
	const kinds = [
		{
			value: "G",
			label: "G"
		},
		{
			value: "M",
			label: "M"
		},
		{
			value: "#",
			label: "#"
		}
	];
	const word = $.derived(() => route.item);
	const shown = $.derived(() => $.get(all).filter((one) => $.get(kind) === "#" ? one.kind === "macro" : one.kind !== "macro" && one.word.startsWith($.get(kind))));
	const active = $.derived(() => new Set(machine.status?.program.g_codes ?? []));
	$.user_effect(() => {
		http.words(machine.dialect, language()).then((now) => $.set(all, now), (failed) => machine.refused(failed));
	});
	$.user_effect(() => {
		if ($.get(word).startsWith("M")) $.set(kind, "M");
	});
	$.user_effect(() => {
		const wanted = $.get(word);
		$.set(about, null);
		if (wanted) http.explain(wanted, machine.dialect, language()).then((now) => wanted === $.get(word) ? $.set(about, now) : null, (failed) => machine.refused(failed));
	});
	var fragment = root_4();
	var div = $.first_child(fragment);
	var node = $.child(div);
	{
		let $0 = $.derived(() => t("help.codes"));
		Segmented(node, {
			get options() {
				return kinds;
			},
			get label() {
				return $.get($0);
			},
			get value() {
				return $.get(kind);
			},
			set value($$value) {
				$.set(kind, $$value, true);
			}
		});
	}
	$.reset(div);
	var div_1 = $.sibling(div, 2);
	var div_2 = $.child(div_1);
	$.each(div_2, 21, () => $.get(shown), (one) => one.word, ($$anchor, one) => {
		var button = root();
		let classes;
		var strong = $.child(button);
		var text = $.only_child(strong, true);
		var span = $.sibling(strong);
		var text_1 = $.only_child(span, true);
		$.reset(button);
		$.template_effect(($0) => {
			classes = $.set_class(button, 1, "s-sx33g", null, classes, {
				chosen: $.get(one).word === $.get(word),
				active: $0
			});
			$.set_text(text, $.get(one).word);
			$.set_text(text_1, $.get(one).title);
		}, [() => $.get(active).has($.get(one).word)]);
		$.delegated("click", button, () => go("help", "codes", $.get(one).word));
		$.append($$anchor, button);
	});
	$.reset(div_2);
	var div_3 = $.sibling(div_2, 2);
	var node_1 = $.child(div_3);
	var consequent_1 = ($$anchor) => {
		var fragment_1 = root_3();
		var h2 = $.first_child(fragment_1);
		var span_1 = $.child(h2);
		var text_2 = $.only_child(span_1, true);
		$.reset(h2);
		var node_2 = $.sibling(h2, 2);
		var consequent = ($$anchor) => {
			var fragment_2 = root_1();
			var h3 = $.first_child(fragment_2);
			var text_3 = $.only_child(h3, true);
			var node_3 = $.sibling(h3);
			Explained(node_3, { get about() {
				return $.get(about);
			} });
			$.template_effect(() => $.set_text(text_3, $.get(about).title));
			$.append($$anchor, fragment_2);
		};
		var alternate = ($$anchor) => {
			var p = root_2();
			var text_4 = $.only_child(p, true);
			$.template_effect(($0) => $.set_text(text_4, $0), [() => $.get(about) ? $.get(about).text || t("help.nothing") : t("app.loading")]);
			$.append($$anchor, p);
		};
		$.if(node_2, ($$render) => {
			if ($.get(about)?.found) $$render(consequent);
			else $$render(alternate, -1);
		});
		$.template_effect(() => $.set_text(text_2, $.get(word)));
		$.append($$anchor, fragment_1);
	};
	var alternate_1 = ($$anchor) => {
		var p_1 = root_2();
		var text_5 = $.only_child(p_1, true);
		$.template_effect(($0) => $.set_text(text_5, $0), [() => t("help.choose")]);
		$.append($$anchor, p_1);
	};
	$.if(node_1, ($$render) => {
		if ($.get(word)) $$render(consequent_1);
		else $$render(alternate_1, -1);
	});
	$.reset(div_3);
	$.reset(div_1);
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["click"]);
export { Codes as default };
