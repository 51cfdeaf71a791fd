import { http } from "../../lib/api/http.js";
import { language, number, t } from "../../lib/i18n/index.svelte.js";
import Bits from "../../lib/parts/Bits.svelte.js";
import Button from "../../lib/parts/Button.svelte.js";
import Card from "../../lib/parts/Card.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import Segmented from "../../lib/parts/Segmented.svelte.js";
import { followSignals } from "../../lib/state/again.js";
import { machine } from "../../lib/state/machine.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/plc/Data.svelte
var root = $.from_html(`<!> <!> <input type="search" data-testid="data-search"/>`, 1);
var root_1 = $.from_html(`<p class="muted note s-xufwe4"> </p>`);
var root_2 = $.from_html(`<label class="cell s-xufwe4"><small class="muted s-xufwe4"> </small> <!></label>`);
var root_3 = $.from_html(`<span class="muted number"> </span>`);
var root_4 = $.from_html(`<div class="row"><!> <!></div>`);
var root_5 = $.from_html(`<div><span class="code"> </span> <span class="muted"> </span></div>`);
var root_6 = $.from_html(`<tr><th scope="row"><span class="code"> </span> <small class="muted s-xufwe4"> </small></th><td><!></td><td class="names s-xufwe4"></td></tr>`);
var root_7 = $.from_html(`<tr><td class="muted"> </td></tr>`);
var root_8 = $.from_html(`<div class="row pager s-xufwe4"><!> <span class="number"> </span> <!></div>`);
var root_9 = $.from_html(`<!> <table class="table" data-testid="plc-data"><tbody></tbody></table> <!>`, 1);
function Data($$anchor, $$props) {
	$.push($$props, true);
	/** A number that the ladder keeps: where it begins, and how many bytes it has. */
	/** A row of the table; relays have bits in the place of cells. */
	/** The level that changes data of the ladder. */
	const CHANGES = 2;
	/** Rows of a page. */
	const PAGE = 25;
	/** Bytes of the areas, and of a row of each; D as wide as somebody wants it. */
	const areas = {
		K: 100,
		T: 500,
		C: 400,
		D: 1e4
	};
	/** ms of a unit of the first eight timers, and of the others. */
	const UNITS = [48, 8];
	let area = $.state("K");
	let width = $.state(1);
	let sought = $.state("");
	let first = $.state(0);
	let names = $.state([]);
	let values = $.state({});
	const may = $.derived(() => machine.level <= CHANGES);
	$.user_effect(() => {
		machine.changed("ladder");
		http.signals(language()).then((all) => $.set(names, all.filter((one) => one.address[0] in areas)), (failed) => machine.refused(failed));
	});
	const step = $.derived(() => ({
		K: 1,
		T: 2,
		C: 4,
		D: $.get(width)
	})[$.get(area)]);
	const rows = $.derived(() => Array.from({ length: Math.floor(areas[$.get(area)] / $.get(step)) }, (_, index) => {
		const at = index * $.get(step);
		const address = `${$.get(area)}${at}`;
		const cell = (from, bytes, label) => ({
			address: `${$.get(area)}${from}`,
			bytes,
			label
		});
		if ($.get(area) === "K") return {
			title: "",
			address,
			cells: []
		};
		if ($.get(area) === "T") return {
			title: `TMR ${index + 1}`,
			address,
			cells: [cell(at, 2, t("plc.time"))]
		};
		if ($.get(area) === "C") return {
			title: `CTR ${index + 1}`,
			address,
			cells: [cell(at, 2, t("plc.preset")), cell(at + 2, 2, t("plc.count"))]
		};
		return {
			title: "",
			address,
			cells: [cell(at, $.get(width), t("plc.value"))]
		};
	}));
	const byteOf = (address) => Number(/\d+/.exec(address)?.[0] ?? -1);
	/** What has a name in a row. */
	function named(row) {
		const at = byteOf(row.address);
		return $.get(names).filter((one) => one.address[0] === $.get(area) && byteOf(one.address) >= at && byteOf(one.address) < at + $.get(step));
	}
	const found = $.derived(() => {
		const words = $.get(sought).toLowerCase().split(/\s+/).filter(Boolean);
		if (!words.length) return $.get(rows);
		const known = new Map($.get(rows).map((row) => [byteOf(row.address), row.address]));
		const texts = new Map($.get(rows).map((row) => [row.address, `${row.address} ${row.title}`]));
		for (const one of $.get(names)) {
			if (one.address[0] !== $.get(area)) continue;
			const row = known.get(byteOf(one.address) - byteOf(one.address) % $.get(step));
			if (row) texts.set(row, `${texts.get(row)} ${one.name} ${one.meaning}`);
		}
		return $.get(rows).filter((row) => words.every((word) => texts.get(row.address).toLowerCase().includes(word)));
	});
	const shown = $.derived(() => $.get(found).slice($.get(first), $.get(first) + PAGE));
	const wanted = $.derived(() => $.get(shown).flatMap((row) => Array.from({ length: $.get(step) }, (_, index) => `${$.get(area)}${byteOf(row.address) + index}`)));
	$.user_effect(() => {
		$.get(area), $.get(sought), $.get(width);
		$.set(first, 0);
	});
	$.user_effect(() => followSignals($.get(wanted), 200, (now) => $.set(values, now)));
	/** The number of a cell, the lowest byte first; null until it was read. */
	function value({ address, bytes }) {
		let sum = 0;
		for (let index = bytes - 1; index >= 0; index--) {
			const byte = $.get(values)[`${$.get(area)}${byteOf(address) + index}`];
			if (byte === void 0) return null;
			sum = sum * 256 + byte;
		}
		return sum;
	}
	function set(signal, to, bytes) {
		machine.tell({
			do: "set_signal",
			signal,
			value: to,
			...bytes === void 0 ? {} : { bytes }
		});
	}
	function milliseconds(row) {
		const [index, units] = [byteOf(row.address) / 2, value(row.cells[0]) ?? 0];
		return units * (index < 8 ? UNITS[0] : UNITS[1]);
	}
	{
		const actions = ($$anchor) => {
			var fragment_1 = root();
			var node = $.first_child(fragment_1);
			{
				let $0 = $.derived(() => Object.keys(areas).map((one) => ({
					value: one,
					label: t(`plc.area_${one}`)
				})));
				let $1 = $.derived(() => t("plc.data"));
				Segmented(node, {
					get options() {
						return $.get($0);
					},
					get label() {
						return $.get($1);
					},
					get value() {
						return $.get(area);
					},
					set value($$value) {
						$.set(area, $$value, true);
					}
				});
			}
			var node_1 = $.sibling(node, 2);
			var consequent = ($$anchor) => {
				{
					let $0 = $.derived(() => [
						1,
						2,
						4
					].map((bytes) => ({
						value: bytes,
						label: t("plc.bytes", {
							count: bytes,
							n: bytes
						})
					})));
					let $1 = $.derived(() => t("plc.value"));
					Segmented($$anchor, {
						get options() {
							return $.get($0);
						},
						get label() {
							return $.get($1);
						},
						get value() {
							return $.get(width);
						},
						set value($$value) {
							$.set(width, $$value, true);
						}
					});
				}
			};
			$.if(node_1, ($$render) => {
				if ($.get(area) === "D") $$render(consequent);
			});
			var input = $.sibling(node_1, 2);
			$.remove_input_defaults(input);
			$.template_effect(($0, $1) => {
				$.set_attribute(input, "placeholder", $0);
				$.set_attribute(input, "aria-label", $1);
			}, [() => t("app.search"), () => t("app.search")]);
			$.bind_value(input, () => $.get(sought), ($$value) => $.set(sought, $$value));
			$.append($$anchor, fragment_1);
		};
		let $0 = $.derived(() => t("plc.data"));
		Card($$anchor, {
			get title() {
				return $.get($0);
			},
			fill: true,
			flush: true,
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_3 = root_9();
				var node_2 = $.first_child(fragment_3);
				var consequent_1 = ($$anchor) => {
					var p = root_1();
					var text = $.only_child(p, true);
					$.template_effect(($0) => $.set_text(text, $0), [() => t("plc.data_level", { level: CHANGES })]);
					$.append($$anchor, p);
				};
				$.if(node_2, ($$render) => {
					if (!$.get(may)) $$render(consequent_1);
				});
				var table = $.sibling(node_2, 2);
				var tbody = $.child(table);
				$.each(tbody, 21, () => $.get(shown), (row) => row.address, ($$anchor, row) => {
					var tr = root_6();
					var th = $.child(tr);
					var span = $.child(th);
					var text_1 = $.only_child(span, true);
					var small = $.sibling(span, 2);
					var text_2 = $.only_child(small, true);
					$.reset(th);
					var td = $.sibling(th);
					var node_3 = $.child(td);
					var consequent_2 = ($$anchor) => {
						{
							let $0 = $.derived(() => $.get(values)[$.get(row).address] ?? 0);
							let $1 = $.derived(() => !$.get(may));
							Bits($$anchor, {
								get address() {
									return $.get(row).address;
								},
								get value() {
									return $.get($0);
								},
								named: (address) => $.get(names).find((one) => one.address === address),
								toggles: true,
								get disabled() {
									return $.get($1);
								},
								onbit: (address, isOn) => set(address, isOn ? 0 : 1)
							});
						}
					};
					var alternate = ($$anchor) => {
						var div = root_4();
						var node_4 = $.child(div);
						$.each(node_4, 17, () => $.get(row).cells, (cell) => cell.address, ($$anchor, cell) => {
							var label_1 = root_2();
							var small_1 = $.child(label_1);
							var text_3 = $.only_child(small_1, true);
							var node_5 = $.sibling(small_1, 2);
							{
								let $0 = $.derived(() => value($.get(cell)));
								let $1 = $.derived(() => `${$.get(cell).address} ${$.get(cell).label}`);
								let $2 = $.derived(() => -(2 ** (8 * $.get(cell).bytes - 1)));
								let $3 = $.derived(() => 2 ** (8 * $.get(cell).bytes) - 1);
								let $4 = $.derived(() => !$.get(may));
								NumberField(node_5, {
									get value() {
										return $.get($0);
									},
									whole: true,
									get label() {
										return $.get($1);
									},
									get minimum() {
										return $.get($2);
									},
									get maximum() {
										return $.get($3);
									},
									get disabled() {
										return $.get($4);
									},
									onvalue: (to) => to !== null && set($.get(cell).address, to, $.get(cell).bytes)
								});
							}
							$.reset(label_1);
							$.template_effect(() => $.set_text(text_3, $.get(cell).label));
							$.append($$anchor, label_1);
						});
						var node_6 = $.sibling(node_4, 2);
						var consequent_3 = ($$anchor) => {
							var span_1 = root_3();
							var text_4 = $.only_child(span_1);
							$.template_effect(($0, $1) => $.set_text(text_4, `${$0 ?? ""} ${$1 ?? ""}`), [() => number(milliseconds($.get(row))), () => t("unit.ms")]);
							$.append($$anchor, span_1);
						};
						$.if(node_6, ($$render) => {
							if ($.get(area) === "T") $$render(consequent_3);
						});
						$.reset(div);
						$.append($$anchor, div);
					};
					$.if(node_3, ($$render) => {
						if ($.get(area) === "K") $$render(consequent_2);
						else $$render(alternate, -1);
					});
					$.reset(td);
					var td_1 = $.sibling(td);
					$.each(td_1, 21, () => named($.get(row)), (one) => one.name, ($$anchor, one) => {
						var div_1 = root_5();
						var span_2 = $.child(div_1);
						var text_5 = $.only_child(span_2, true);
						var span_3 = $.sibling(span_2, 2);
						var text_6 = $.only_child(span_3, true);
						$.reset(div_1);
						$.template_effect(() => {
							$.set_text(text_5, $.get(one).name);
							$.set_text(text_6, $.get(one).meaning);
						});
						$.append($$anchor, div_1);
					});
					$.reset(td_1);
					$.reset(tr);
					$.template_effect(() => {
						$.set_attribute(tr, "data-address", $.get(row).address);
						$.set_text(text_1, $.get(row).address);
						$.set_text(text_2, $.get(row).title);
					});
					$.append($$anchor, tr);
				}, ($$anchor) => {
					var tr_1 = root_7();
					var td_2 = $.child(tr_1);
					var text_7 = $.only_child(td_2, true);
					$.reset(tr_1);
					$.template_effect(($0) => $.set_text(text_7, $0), [() => t("plc.nothing_kept")]);
					$.append($$anchor, tr_1);
				});
				$.reset(tbody);
				$.reset(table);
				var node_7 = $.sibling(table, 2);
				var consequent_4 = ($$anchor) => {
					var div_2 = root_8();
					var node_8 = $.child(div_2);
					{
						let $0 = $.derived(() => t("offsets.before"));
						let $1 = $.derived(() => $.get(first) === 0);
						Button(node_8, {
							icon: "left",
							get "aria-label"() {
								return $.get($0);
							},
							get disabled() {
								return $.get($1);
							},
							onclick: () => $.set(first, Math.max(0, $.get(first) - PAGE), true)
						});
					}
					var span_4 = $.sibling(node_8, 2);
					var text_8 = $.only_child(span_4);
					var node_9 = $.sibling(span_4, 2);
					{
						let $0 = $.derived(() => t("offsets.after"));
						let $1 = $.derived(() => $.get(first) + PAGE >= $.get(found).length);
						Button(node_9, {
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
					$.reset(div_2);
					$.template_effect(($0) => $.set_text(text_8, `${$.get(first) + 1}–${$0 ?? ""} / ${$.get(found).length ?? ""}`), [() => Math.min($.get(found).length, $.get(first) + PAGE)]);
					$.append($$anchor, div_2);
				};
				$.if(node_7, ($$render) => {
					if ($.get(found).length > PAGE) $$render(consequent_4);
				});
				$.append($$anchor, fragment_3);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.pop();
}
export { Data as default };
