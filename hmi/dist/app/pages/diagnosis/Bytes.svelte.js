import { http } from "../../lib/api/http.js";
import { language, t } from "../../lib/i18n/index.svelte.js";
import Bits from "../../lib/parts/Bits.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Find from "../../lib/parts/Find.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { followSignals } from "../../lib/state/again.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { AREAS, addressOf, bytesOf } from "./addresses.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/diagnosis/Bytes.svelte
var root = $.from_html(`<!> <!> <!> <!>`, 1);
var root_1 = $.from_html(`<tr><th scope="row" class="s-1d49hdy"><button type="button" class="code s-1d49hdy"> </button></th><td class="s-1d49hdy"><!></td><td class="number right s-1d49hdy"> </td><td class="code right muted s-1d49hdy"> </td></tr>`);
var root_2 = $.from_html(`<table class="table" data-testid="bytes"><tbody></tbody></table>`);
var root_3 = $.from_html(`<span class="code"> </span> <span class="muted"> </span>`, 1);
var root_4 = $.from_html(`<span class="muted"> </span>`);
var root_5 = $.from_html(`<!> <p class="about s-1d49hdy" role="status" data-testid="address"><strong class="code"> </strong> <b class="number"> </b> <!></p>`, 1);
function Bytes($$anchor, $$props) {
	$.push($$props, true);
	const PAGE = 16;
	let area = $.state("X");
	let first = $.state(0);
	let chosen = $.state("X0");
	let values = $.state({});
	let named = $.state(/* @__PURE__ */ new Map());
	const options = AREAS.map((value) => ({
		value,
		label: value
	}));
	const bytes = $.derived(() => bytesOf($.get(area)));
	const shown = $.derived(() => $.get(bytes).slice($.get(first), $.get(first) + PAGE));
	const valueOf = (address) => ($.get(values)[address] ?? 0) & 255;
	const $$d = $.derived(() => $.get(chosen).split(".")), $$array = $.derived(() => $.to_array($.get($$d), 2)), byte = $.derived(() => $.get($$array)[0]), bit = $.derived(() => $.get($$array)[1]);
	const signal = $.derived(() => $.get(named).get($.get(chosen)));
	$.user_effect(() => {
		machine.changed("ladder");
		const wanted = language();
		http.signals(wanted).then((all) => {
			if (wanted === language()) $.set(named, new Map(all.map((one) => [one.address, one])));
		}, (failed) => machine.refused(failed));
	});
	$.user_effect(() => followSignals($.get(shown), 200, (now) => $.set(values, now)));
	/** The address that a text means: it is one, or the name of a signal. */
	function meant(text) {
		const name = text.trim().toUpperCase();
		return addressOf(text) ?? [...$.get(named).values()].find((one) => one.name.toUpperCase() === name)?.address ?? null;
	}
	function find(address) {
		$.set(chosen, String(address), true);
		$.set(area, $.get(chosen)[0], true);
		const at = bytesOf($.get(area)).indexOf($.get(chosen).split(".")[0]);
		$.set(first, at - at % PAGE);
	}
	var fragment = root_5();
	var node = $.first_child(fragment);
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var node_1 = $.first_child(fragment_1);
			{
				let $0 = $.derived(() => t("diagnosis.area"));
				Segmented(node_1, {
					get options() {
						return options;
					},
					get label() {
						return $.get($0);
					},
					onchange: () => $.set(first, 0),
					get value() {
						return $.get(area);
					},
					set value($$value) {
						$.set(area, $$value, true);
					}
				});
			}
			var node_2 = $.sibling(node_1, 2);
			{
				let $0 = $.derived(() => t("diagnosis.find"));
				Find(node_2, {
					get label() {
						return $.get($0);
					},
					placeholder: "X20.3",
					meant,
					at: "data-address",
					onfind: find,
					"data-testid": "find-address"
				});
			}
			var node_3 = $.sibling(node_2, 2);
			{
				let $0 = $.derived(() => t("offsets.before"));
				let $1 = $.derived(() => $.get(first) === 0);
				Button(node_3, {
					icon: "left",
					get "aria-label"() {
						return $.get($0);
					},
					get disabled() {
						return $.get($1);
					},
					onclick: () => $.set(first, $.get(first) - PAGE)
				});
			}
			var node_4 = $.sibling(node_3, 2);
			{
				let $0 = $.derived(() => t("offsets.after"));
				let $1 = $.derived(() => $.get(first) + PAGE >= $.get(bytes).length);
				Button(node_4, {
					icon: "right",
					get "aria-label"() {
						return $.get($0);
					},
					get disabled() {
						return $.get($1);
					},
					onclick: () => $.set(first, $.get(first) + PAGE)
				});
			}
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("diagnosis.bytes"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			fill: true,
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var table = root_2();
				var tbody = $.child(table);
				$.each(tbody, 20, () => $.get(shown), (address) => address, ($$anchor, address) => {
					var tr = root_1();
					let classes;
					var th = $.child(tr);
					var button = $.child(th);
					var text_1 = $.only_child(button, true);
					$.reset(th);
					var td = $.sibling(th);
					var node_5 = $.child(td);
					{
						let $0 = $.derived(() => valueOf(address));
						Bits(node_5, {
							get address() {
								return address;
							},
							get value() {
								return $.get($0);
							},
							named: (place) => $.get(named).get(place),
							onbit: (place) => $.set(chosen, place, true)
						});
					}
					$.reset(td);
					var td_1 = $.sibling(td);
					var text_2 = $.only_child(td_1, true);
					var td_2 = $.sibling(td_1);
					var text_3 = $.only_child(td_2, true);
					$.reset(tr);
					$.template_effect(($0, $1) => {
						$.set_attribute(tr, "data-byte", address);
						classes = $.set_class(tr, 1, "s-1d49hdy", null, classes, { current: address === $.get(byte) });
						$.set_attribute(button, "data-address", address);
						$.set_text(text_1, address);
						$.set_text(text_2, $0);
						$.set_text(text_3, $1);
					}, [() => valueOf(address), () => valueOf(address).toString(16).toUpperCase().padStart(2, "0")]);
					$.event("focus", button, () => $.set(chosen, address, true));
					$.delegated("click", button, () => $.set(chosen, address, true));
					$.append($$anchor, tr);
				});
				$.reset(tbody);
				$.reset(table);
				$.append($$anchor, table);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var p = $.sibling(node, 2);
	var strong = $.child(p);
	var text_4 = $.only_child(strong, true);
	var b = $.sibling(strong, 2);
	var text_5 = $.only_child(b, true);
	var node_6 = $.sibling(b, 2);
	var consequent = ($$anchor) => {
		var fragment_2 = root_3();
		var span = $.first_child(fragment_2);
		var text_6 = $.only_child(span, true);
		var span_1 = $.sibling(span, 2);
		var text_7 = $.only_child(span_1, true);
		$.template_effect(() => {
			$.set_text(text_6, $.get(signal).name);
			$.set_text(text_7, $.get(signal).meaning);
		});
		$.append($$anchor, fragment_2);
	};
	var alternate = ($$anchor) => {
		var span_2 = root_4();
		var text_8 = $.only_child(span_2, true);
		$.template_effect(($0) => $.set_text(text_8, $0), [() => t("diagnosis.unnamed")]);
		$.append($$anchor, span_2);
	};
	$.if(node_6, ($$render) => {
		if ($.get(signal)) $$render(consequent);
		else $$render(alternate, -1);
	});
	$.reset(p);
	$.template_effect(($0) => {
		$.set_text(text_4, $.get(chosen));
		$.set_text(text_5, $0);
	}, [() => $.get(bit) === void 0 ? $.get(values)[$.get(chosen)] ?? valueOf($.get(chosen)) : valueOf($.get(byte)) >> Number($.get(bit)) & 1]);
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["click"]);
export { Bytes as default };
