import { t } from "../../lib/i18n/index.svelte.js";
import { behindLetter, firstOfPage, fixed, numberNamed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import Find from "../../lib/parts/Find.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import { followParameters } from "../../lib/state/again.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/offsets/Tools.svelte
var root = $.from_html(`<!> <!> <!> <span class="number range s-1cs1yh2"> </span> <!>`, 1);
var root_1 = $.from_html(`<th class="right"> <small> </small></th>`);
var root_2 = $.from_html(`<td><!></td>`);
var root_3 = $.from_html(`<tr><th scope="row" class="number"> </th><!><td class="right number muted"> </td><td class="right"><!></td></tr>`);
var root_4 = $.from_html(`<table class="table" data-testid="offsets"><thead><tr><th> </th><!><th class="right"> <small> </small></th><th></th></tr></thead><tbody></tbody></table>`);
var root_5 = $.from_html(`<!> <p class="muted s-1cs1yh2"> </p>`, 1);
function Tools($$anchor, $$props) {
	$.push($$props, true);
	const offsetKinds = [
		"length",
		"length_wear",
		"radius",
		"radius_wear"
	];
	const cycleKinds = [
		"cutting_length",
		"entry_angle",
		"tip_radius"
	];
	const kinds = $.derived(() => machine.version?.dialect === "fagor8065" ? [...offsetKinds, ...cycleKinds] : offsetKinds);
	const has = (some, kind) => some.includes(kind);
	/** mm; what is more is refused. */
	const MOST = 9999.999;
	const PAGE = 32;
	const LAST = 256;
	let from = $.state(1);
	let offsets = $.state({});
	let add = $.state(false);
	const numbers = $.derived(() => Array.from({ length: Math.min(PAGE, LAST - $.get(from) + 1) }, (_, index) => $.get(from) + index));
	const h = $.derived(() => machine.status?.program.h ?? 0);
	let hasDiameters = $.state(false);
	$.user_effect(() => followParameters(["NO40.7"], (values) => $.set(hasDiameters, values["NO40.7"] === 1)));
	const named = (kind) => t(kind === "radius" && $.get(hasDiameters) ? "offsets.diameter" : `offsets.${kind}`);
	$.user_effect(() => {
		machine.changed("offsets");
		if (machine.link !== "open") return;
		const first = $.get(from);
		machine.fetch("offsets", {
			do: "offsets",
			from: first,
			to: Math.min(first + PAGE - 1, LAST)
		}).then((reply) => {
			if (reply && first === $.get(from)) $.set(offsets, reply.offsets);
		});
	});
	function set(number, kind, value) {
		if (value !== null) machine.tell({
			do: "set_offset",
			number,
			[kind]: value,
			add: $.get(add)
		});
	}
	/** The length of a tool that stands on the zero of the work: its relative Z (3.3.1.2). A tool just measured has no wear, as in
	the wizard of the set-up. */
	function measure(number) {
		const z = machine.status?.position.relative.Z;
		if (z !== void 0) machine.tell({
			do: "set_offset",
			number,
			length: z,
			length_wear: 0,
			add: false
		});
	}
	/** `Z10` as a length is the relative Z plus 10 (note 3). */
	function behindZ(text, number) {
		const more = behindLetter(text, "Z");
		const z = machine.status?.position.relative.Z;
		return more === null || z === void 0 ? null : () => void machine.tell({
			do: "set_offset",
			number,
			length: z + more,
			add: false
		});
	}
	var fragment = root_5();
	var node = $.first_child(fragment);
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var node_1 = $.first_child(fragment_1);
			{
				let $0 = $.derived(() => t("offsets.find"));
				Find(node_1, {
					get label() {
						return $.get($0);
					},
					placeholder: "H12",
					meant: (text) => numberNamed(text, "HD", 1, LAST),
					at: "data-offset",
					onfind: (number) => $.set(from, firstOfPage(Number(number), 1, PAGE), true),
					"data-testid": "find-offset"
				});
			}
			var node_2 = $.sibling(node_1, 2);
			Button(node_2, {
				get pressed() {
					return $.get(add);
				},
				onclick: () => $.set(add, !$.get(add)),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_1 = $.text();
					$.template_effect(($0) => $.set_text(text_1, $0), [() => t("offsets.add")]);
					$.append($$anchor, text_1);
				},
				$$slots: { default: true }
			});
			var node_3 = $.sibling(node_2, 2);
			{
				let $0 = $.derived(() => t("offsets.before"));
				let $1 = $.derived(() => $.get(from) <= 1);
				Button(node_3, {
					icon: "left",
					get "aria-label"() {
						return $.get($0);
					},
					get disabled() {
						return $.get($1);
					},
					onclick: () => $.set(from, Math.max(1, $.get(from) - PAGE), true)
				});
			}
			var span = $.sibling(node_3, 2);
			var text_2 = $.only_child(span);
			var node_4 = $.sibling(span, 2);
			{
				let $0 = $.derived(() => t("offsets.after"));
				let $1 = $.derived(() => $.get(from) + PAGE > LAST);
				Button(node_4, {
					icon: "right",
					get "aria-label"() {
						return $.get($0);
					},
					get disabled() {
						return $.get($1);
					},
					onclick: () => $.set(from, $.get(from) + PAGE)
				});
			}
			$.template_effect(($0) => $.set_text(text_2, `${$.get(from) ?? ""}–${$0 ?? ""}`), [() => $.get(numbers).at(-1)]);
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("offsets.tools"));
		Card(node, {
			get title() {
				return $.get($0);
			},
			fill: true,
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var table = root_4();
				var thead = $.child(table);
				var tr = $.child(thead);
				var th = $.child(tr);
				var text_3 = $.only_child(th, true);
				var node_5 = $.sibling(th);
				$.each(node_5, 16, () => $.get(kinds), (kind) => kind, ($$anchor, kind) => {
					var th_1 = root_1();
					var text_4 = $.child(th_1);
					var small = $.sibling(text_4);
					var text_5 = $.only_child(small, true);
					$.reset(th_1);
					$.template_effect(($0, $1) => {
						$.set_text(text_4, `${$0 ?? ""} `);
						$.set_text(text_5, $1);
					}, [() => named(kind), () => t(kind === "entry_angle" ? "unit.deg" : "unit.mm")]);
					$.append($$anchor, th_1);
				});
				var th_2 = $.sibling(node_5);
				var text_6 = $.child(th_2);
				var small_1 = $.sibling(text_6);
				var text_7 = $.only_child(small_1, true);
				$.reset(th_2);
				$.next();
				$.reset(tr);
				$.reset(thead);
				var tbody = $.sibling(thead);
				$.each(tbody, 20, () => $.get(numbers), (number) => number, ($$anchor, number) => {
					const values = $.derived(() => $.get(offsets)[number] ?? {});
					var tr_1 = root_3();
					let classes;
					var th_3 = $.child(tr_1);
					var text_8 = $.only_child(th_3, true);
					var node_6 = $.sibling(th_3);
					$.each(node_6, 16, () => $.get(kinds), (kind) => kind, ($$anchor, kind) => {
						var td = root_2();
						var node_7 = $.child(td);
						{
							let $0 = $.derived(() => $.get(values)[kind] ?? 0);
							let $1 = $.derived(() => $.get(add) || !has(cycleKinds, kind) ? -9999.999 : 0);
							let $2 = $.derived(() => !$.get(add) && kind === "entry_angle" ? 90 : MOST);
							let $3 = $.derived(() => `${number} ${named(kind)}`);
							let $4 = $.derived(() => kind === "length" ? (text) => behindZ(text, number) : void 0);
							NumberField(node_7, {
								get value() {
									return $.get($0);
								},
								get again() {
									return $.get(add);
								},
								get minimum() {
									return $.get($1);
								},
								get maximum() {
									return $.get($2);
								},
								get label() {
									return $.get($3);
								},
								get meant() {
									return $.get($4);
								},
								onvalue: (value) => set(number, kind, value)
							});
						}
						$.reset(td);
						$.append($$anchor, td);
					});
					var td_1 = $.sibling(node_6);
					var text_9 = $.only_child(td_1, true);
					var td_2 = $.sibling(td_1);
					var node_8 = $.child(td_2);
					{
						let $0 = $.derived(() => t("offsets.measure", { number }));
						let $1 = $.derived(() => t("offsets.measure", { number }));
						Button(node_8, {
							icon: "ruler",
							get "aria-label"() {
								return $.get($0);
							},
							get title() {
								return $.get($1);
							},
							onclick: () => measure(number)
						});
					}
					$.reset(td_2);
					$.reset(tr_1);
					$.template_effect(($0, $1) => {
						$.set_attribute(tr_1, "data-offset", number);
						classes = $.set_class(tr_1, 1, "s-1cs1yh2", null, classes, { current: number === $.get(h) });
						$.set_text(text_8, $0);
						$.set_text(text_9, $1);
					}, [() => number.toString().padStart(3, "0"), () => fixed(($.get(values).length ?? 0) + ($.get(values).length_wear ?? 0))]);
					$.append($$anchor, tr_1);
				});
				$.reset(tbody);
				$.reset(table);
				$.template_effect(($0, $1, $2) => {
					$.set_text(text_3, $0);
					$.set_text(text_6, `${$1 ?? ""} `);
					$.set_text(text_7, $2);
				}, [
					() => t("offsets.number"),
					() => t("offsets.whole"),
					() => t("unit.mm")
				]);
				$.append($$anchor, table);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	var p = $.sibling(node, 2);
	var text_10 = $.only_child(p, true);
	$.template_effect(($0) => $.set_text(text_10, $0), [() => t("offsets.hint", { z: fixed(machine.status?.position.relative.Z) })]);
	$.append($$anchor, fragment);
	$.pop();
}
export { Tools as default };
