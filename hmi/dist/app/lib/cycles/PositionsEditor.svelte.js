import { t } from "../i18n/index.svelte.js";
import Button from "../parts/Button.svelte.js";
import NumberField from "../parts/NumberField.svelte.js";
import FieldInput from "./FieldInput.svelte.js";
import { axisOf, forms, placed } from "./form.svelte.js";
import { key } from "./rows.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/cycles/PositionsEditor.svelte
var root = $.from_html(`<li class="row"><span class="code"></span> <!> <!> <!></li>`);
var root_1 = $.from_html(`<ol class="s-15xizn2"></ol> <!>`, 1);
var root_2 = $.from_html(`<!> <!>`, 1);
var root_3 = $.from_html(`<p class="finding s-15xizn2"> </p>`);
var root_4 = $.from_html(`<div class="figures s-15xizn2" role="radiogroup"><!> <!></div> <!> <!>`, 1);
function PositionsEditor($$anchor, $$props) {
	$.push($$props, true);
	let filled = $.prop($$props, "filled", 7), focus = $.prop($$props, "focus", 15);
	/** Where the machine stands, by the place of the axis; null where nothing is known. */
	const figure = $.derived(() => $$props.form.positions.find((one) => one.kind === filled().positions?.kind));
	function choose(kind) {
		filled().positions = kind ? forms.figure($$props.form, kind) : null;
	}
	function teach(field) {
		const axis = axisOf(field);
		if (axis === null) return null;
		return () => {
			const at = $$props.here(axis);
			if (at !== null && filled().positions) filled().positions.values[field.name] = at;
		};
	}
	function add() {
		const [x, y] = [$$props.here(0), $$props.here(1)];
		filled().positions?.points.push([x ?? 0, y ?? 0]);
	}
	var fragment = root_4();
	var div = $.first_child(fragment);
	var node = $.child(div);
	{
		let $0 = $.derived(() => !filled().positions);
		Button(node, {
			role: "radio",
			get pressed() {
				return $.get($0);
			},
			onclick: () => choose(""),
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text = $.text();
				$.template_effect(($0) => $.set_text(text, $0), [() => t("cycles.one_point")]);
				$.append($$anchor, text);
			},
			$$slots: { default: true }
		});
	}
	var node_1 = $.sibling(node, 2);
	$.each(node_1, 17, () => $$props.form.positions, (one) => one.kind, ($$anchor, one) => {
		{
			let $0 = $.derived(() => filled().positions?.kind === $.get(one).kind);
			Button($$anchor, {
				role: "radio",
				get "data-figure"() {
					return $.get(one).kind;
				},
				get pressed() {
					return $.get($0);
				},
				onclick: () => choose($.get(one).kind),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_1 = $.text();
					$.template_effect(() => $.set_text(text_1, $.get(one).title));
					$.append($$anchor, text_1);
				},
				$$slots: { default: true }
			});
		}
	});
	$.reset(div);
	var node_2 = $.sibling(div, 2);
	var consequent_1 = ($$anchor) => {
		var fragment_4 = root_2();
		var node_3 = $.first_child(fragment_4);
		$.each(node_3, 17, () => $.get(figure).parameters, (field) => field.name, ($$anchor, field) => {
			const name = $.derived(() => key($.get(field).name));
			{
				let $0 = $.derived(() => placed($.get(field)));
				let $1 = $.derived(() => $$props.findings.filter((one) => one.parameter === $.get(name)));
				let $2 = $.derived(() => focus() === $.get(name));
				let $3 = $.derived(() => teach($.get(field)));
				FieldInput($$anchor, {
					get field() {
						return $.get($0);
					},
					get value() {
						return filled().positions.values[$.get(field).name];
					},
					get findings() {
						return $.get($1);
					},
					get focused() {
						return $.get($2);
					},
					get teach() {
						return $.get($3);
					},
					onfocus: () => focus($.get(name)),
					onvalue: (value) => {
						if (!filled().positions) return;
						if (value === void 0) delete filled().positions.values[$.get(field).name];
						else filled().positions.values[$.get(field).name] = value;
					}
				});
			}
		});
		var node_4 = $.sibling(node_3, 2);
		var consequent = ($$anchor) => {
			var fragment_6 = root_1();
			var ol = $.first_child(fragment_6);
			$.each(ol, 21, () => filled().positions.points, $.index, ($$anchor, point, i) => {
				var li = root();
				var span = $.child(li);
				span.textContent = `P${i + 2}`;
				var node_5 = $.sibling(span, 2);
				NumberField(node_5, {
					label: `X ${i + 2}`,
					unit: "X",
					get value() {
						return $.get(point)[0];
					},
					onvalue: (value) => $.get(point)[0] = value ?? 0
				});
				var node_6 = $.sibling(node_5, 2);
				NumberField(node_6, {
					label: `Y ${i + 2}`,
					unit: "Y",
					get value() {
						return $.get(point)[1];
					},
					onvalue: (value) => $.get(point)[1] = value ?? 0
				});
				var node_7 = $.sibling(node_6, 2);
				{
					let $0 = $.derived(() => t("cycles.delete"));
					Button(node_7, {
						kind: "quiet",
						icon: "trash",
						get "aria-label"() {
							return $.get($0);
						},
						onclick: () => filled().positions?.points.splice(i, 1)
					});
				}
				$.reset(li);
				$.delegated("focusin", li, () => focus(key(`P${i + 2}`)));
				$.append($$anchor, li);
			});
			$.reset(ol);
			var node_8 = $.sibling(ol, 2);
			{
				let $0 = $.derived(() => filled().positions.points.length >= $.get(figure).points);
				Button(node_8, {
					icon: "plus",
					get disabled() {
						return $.get($0);
					},
					onclick: add,
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_2 = $.text();
						$.template_effect(($0) => $.set_text(text_2, $0), [() => t("cycles.add_here")]);
						$.append($$anchor, text_2);
					},
					$$slots: { default: true }
				});
			}
			$.append($$anchor, fragment_6);
		};
		$.if(node_4, ($$render) => {
			if ($.get(figure).points > 0) $$render(consequent);
		});
		$.append($$anchor, fragment_4);
	};
	$.if(node_2, ($$render) => {
		if ($.get(figure) && filled().positions) $$render(consequent_1);
	});
	var node_9 = $.sibling(node_2, 2);
	$.each(node_9, 17, () => $$props.findings.filter((one) => one.parameter === "positions"), (finding) => finding.id, ($$anchor, finding) => {
		var p = root_3();
		var text_3 = $.only_child(p, true);
		$.template_effect(() => {
			$.set_attribute(p, "title", $.get(finding).help);
			$.set_text(text_3, $.get(finding).text);
		});
		$.append($$anchor, p);
	});
	$.template_effect(($0) => $.set_attribute(div, "aria-label", $0), [() => t("cycles.positions")]);
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["focusin"]);
export { PositionsEditor as default };
