import { http } from "../../lib/api/http.js";
import { language, number, t } from "../../lib/i18n/index.svelte.js";
import { readLadder, signalsOf } from "../../lib/ladder/ladder.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import { again } from "../../lib/state/again.js";
import { machine } from "../../lib/state/machine.svelte.js";
import Rung from "./Rung.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/plc/Monitor.svelte
var root = $.from_html(`<input type="search" data-testid="plc-search"/> <!> <span class="number muted"> </span> <!>`, 1);
var root_1 = $.from_html(`<p class="muted none s-sx3sie"> </p>`);
var root_2 = $.from_html(`<div data-testid="ladder"></div>`);
var root_3 = $.from_html(`<span class="one row s-sx3sie"><span class="code"> </span><span class="number"> </span> <!></span>`);
var root_4 = $.from_html(`<div class="signal row wrap s-sx3sie" data-testid="forced"><strong> </strong> <!></div>`);
var root_5 = $.from_html(`<div class="signal row wrap s-sx3sie" data-testid="signal"><strong class="code"> </strong> <span class="code muted"> </span> <span class="grow"> </span> <span class="number"> </span> <!> <!> <!> <!></div>`);
var root_6 = $.from_html(`<!> <!> <!>`, 1);
function Monitor($$anchor, $$props) {
	$.push($$props, true);
	const PAGE = 20;
	let text = $.state(null);
	/** What signals are, in the language of the user; the ladder's own remarks are in that of who wrote it. */
	let meanings = $.state(/* @__PURE__ */ new Map());
	const ladder = $.derived(() => $.get(text) === null ? null : readLadder($.get(text), $.get(meanings)));
	let sought = $.state("");
	let first = $.state(0);
	let power = $.state([]);
	let values = $.state({});
	let signal = $.state("");
	const found = $.derived(() => {
		const words = $.get(sought).toLowerCase().split(/\s+/).filter(Boolean);
		if (!$.get(ladder)) return [];
		const { symbols } = $.get(ladder);
		return $.get(ladder).rungs.filter((rung) => {
			if (words.length === 0) return true;
			const text = `${rung.comment} ${rung.outputs.map((one) => `${one.text} ${one.meaning}`).join(" ")} ${signalsOf(rung).map((name) => `${name} ${symbols.get(name)?.address ?? ""} ${symbols.get(name)?.meaning ?? ""}`).join(" ")}`.toLowerCase();
			return words.every((word) => text.includes(word));
		});
	});
	const shown = $.derived(() => $.get(found).slice($.get(first), $.get(first) + PAGE));
	const names = $.derived(() => [...new Set($.get(shown).flatMap(signalsOf))].slice(0, 250));
	$.user_effect(() => {
		machine.changed("ladder");
		if (machine.link !== "open") return;
		machine.fetch("text", { do: "ladder" }).then((reply) => {
			if (reply) $.set(text, reply.text);
		});
	});
	$.user_effect(() => {
		const wanted = language();
		http.signals(wanted).then((all) => {
			if (wanted === language()) $.set(meanings, new Map(all.map((one) => [one.name, one.meaning])));
		}, () => void 0);
	});
	$.user_effect(() => {
		const shown = $.get(names);
		return again(150, async (wanted) => {
			if (!shown.length) return;
			const [flow, signals] = await Promise.all([machine.ask({ do: "ladder_flow" }).catch(() => null), machine.ask({
				do: "signals",
				names: shown
			}).catch(() => null)]);
			if (!wanted()) return;
			if (flow?.reply === "ladder_flow") $.set(power, flow.power);
			if (signals?.reply === "signals") $.set(values, signals.signals);
		});
	});
	let forced = $.state([]);
	$.user_effect(() => {
		machine.changed("forced");
		machine.changed("ladder");
		if (machine.link !== "open") return;
		machine.fetch("forced", { do: "forced" }).then((reply) => {
			if (reply) $.set(forced, reply.signals);
		});
	});
	function force(signal, value) {
		machine.tell({
			do: "force",
			signal,
			value
		});
	}
	var fragment = root_6();
	var node = $.first_child(fragment);
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var input = $.first_child(fragment_1);
			$.remove_input_defaults(input);
			var node_1 = $.sibling(input, 2);
			{
				let $0 = $.derived(() => t("offsets.before"));
				let $1 = $.derived(() => $.get(first) === 0);
				Button(node_1, {
					icon: "up",
					get "aria-label"() {
						return $.get($0);
					},
					get disabled() {
						return $.get($1);
					},
					onclick: () => $.set(first, Math.max(0, $.get(first) - PAGE), true)
				});
			}
			var span = $.sibling(node_1, 2);
			var text_1 = $.only_child(span);
			var node_2 = $.sibling(span, 2);
			{
				let $0 = $.derived(() => t("offsets.after"));
				let $1 = $.derived(() => $.get(first) + PAGE >= $.get(found).length);
				Button(node_2, {
					icon: "down",
					get "aria-label"() {
						return $.get($0);
					},
					get disabled() {
						return $.get($1);
					},
					onclick: () => $.set(first, $.get(first) + PAGE)
				});
			}
			$.template_effect(($0, $1, $2, $3, $4) => {
				$.set_attribute(input, "placeholder", $0);
				$.set_attribute(input, "aria-label", $1);
				$.set_text(text_1, `${$2 ?? ""}–${$3 ?? ""} / ${$4 ?? ""}`);
			}, [
				() => t("app.search"),
				() => t("app.search"),
				() => number(Math.min($.get(first) + 1, $.get(found).length)),
				() => number(Math.min($.get(first) + PAGE, $.get(found).length)),
				() => number($.get(found).length)
			]);
			$.delegated("input", input, () => $.set(first, 0));
			$.bind_value(input, () => $.get(sought), ($$value) => $.set(sought, $$value));
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("plc.monitor"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			fill: true,
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var div = root_2();
				$.each(div, 21, () => $.get(shown), (rung) => rung.line, ($$anchor, rung) => {
					Rung($$anchor, {
						get rung() {
							return $.get(rung);
						},
						get symbols() {
							return $.get(ladder).symbols;
						},
						get values() {
							return $.get(values);
						},
						get power() {
							return $.get(power);
						},
						onsignal: (name) => $.set(signal, name, true)
					});
				}, ($$anchor) => {
					var p = root_1();
					var text_2 = $.only_child(p, true);
					$.template_effect(($0) => $.set_text(text_2, $0), [() => $.get(ladder) ? t("plc.nothing") : t("app.loading")]);
					$.append($$anchor, p);
				});
				$.reset(div);
				$.append($$anchor, div);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var node_3 = $.sibling(node, 2);
	var consequent = ($$anchor) => {
		var div_1 = root_4();
		var strong = $.child(div_1);
		var text_3 = $.only_child(strong, true);
		var node_4 = $.sibling(strong, 2);
		$.each(node_4, 17, () => $.get(forced), (one) => one.address, ($$anchor, one) => {
			var span_1 = root_3();
			var span_2 = $.child(span_1);
			var text_4 = $.only_child(span_2, true);
			var span_3 = $.sibling(span_2);
			var text_5 = $.only_child(span_3, true);
			var node_5 = $.sibling(span_3, 2);
			{
				let $0 = $.derived(() => t("plc.release_signal", { signal: $.get(one).name || $.get(one).address }));
				Button(node_5, {
					get "aria-label"() {
						return $.get($0);
					},
					onclick: () => force($.get(one).address, null),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_6 = $.text();
						$.template_effect(($0) => $.set_text(text_6, $0), [() => t("plc.force_release")]);
						$.append($$anchor, text_6);
					},
					$$slots: { default: true }
				});
			}
			$.reset(span_1);
			$.template_effect(() => {
				$.set_attribute(span_1, "data-forced", $.get(one).name || $.get(one).address);
				$.set_text(text_4, $.get(one).name || $.get(one).address);
				$.set_text(text_5, $.get(one).value ? 1 : 0);
			});
			$.append($$anchor, span_1);
		});
		$.reset(div_1);
		$.template_effect(($0) => $.set_text(text_3, $0), [() => t("plc.forced")]);
		$.append($$anchor, div_1);
	};
	$.if(node_3, ($$render) => {
		if ($.get(forced).length) $$render(consequent);
	});
	var node_6 = $.sibling(node_3, 2);
	var consequent_1 = ($$anchor) => {
		var div_2 = root_5();
		var strong_1 = $.child(div_2);
		var text_7 = $.only_child(strong_1, true);
		var span_4 = $.sibling(strong_1, 2);
		var text_8 = $.only_child(span_4, true);
		var span_5 = $.sibling(span_4, 2);
		var text_9 = $.only_child(span_5, true);
		var span_6 = $.sibling(span_5, 2);
		var text_10 = $.only_child(span_6, true);
		var node_7 = $.sibling(span_6, 2);
		Button(node_7, {
			onclick: () => force($.get(signal), true),
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_11 = $.text();
				$.template_effect(($0) => $.set_text(text_11, $0), [() => t("plc.force_on")]);
				$.append($$anchor, text_11);
			},
			$$slots: { default: true }
		});
		var node_8 = $.sibling(node_7, 2);
		Button(node_8, {
			onclick: () => force($.get(signal), false),
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_12 = $.text();
				$.template_effect(($0) => $.set_text(text_12, $0), [() => t("plc.force_off")]);
				$.append($$anchor, text_12);
			},
			$$slots: { default: true }
		});
		var node_9 = $.sibling(node_8, 2);
		Button(node_9, {
			onclick: () => force($.get(signal), null),
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_13 = $.text();
				$.template_effect(($0) => $.set_text(text_13, $0), [() => t("plc.force_release")]);
				$.append($$anchor, text_13);
			},
			$$slots: { default: true }
		});
		var node_10 = $.sibling(node_9, 2);
		{
			let $0 = $.derived(() => t("app.close"));
			Button(node_10, {
				kind: "quiet",
				icon: "close",
				get "aria-label"() {
					return $.get($0);
				},
				onclick: () => $.set(signal, "")
			});
		}
		$.reset(div_2);
		$.template_effect(($0, $1) => {
			$.set_attribute(div_2, "data-value", $.get(values)[$.get(signal)]);
			$.set_text(text_7, $.get(signal));
			$.set_text(text_8, $0);
			$.set_text(text_9, $1);
			$.set_text(text_10, $.get(values)[$.get(signal)] ?? "");
		}, [() => $.get(ladder)?.symbols.get($.get(signal))?.address, () => $.get(ladder)?.symbols.get($.get(signal))?.meaning]);
		$.append($$anchor, div_2);
	};
	$.if(node_6, ($$render) => {
		if ($.get(signal)) $$render(consequent_1);
	});
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["input"]);
export { Monitor as default };
