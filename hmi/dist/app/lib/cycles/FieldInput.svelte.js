import { t, unit } from "../i18n/index.svelte.js";
import { typed } from "../numbers.js";
import Button from "../parts/Button.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/cycles/FieldInput.svelte
var root = $.from_html(`<b class="code s-b5qaxz"> </b>`);
var root_1 = $.from_html(`<option> </option>`);
var root_2 = $.from_html(`<select class="s-b5qaxz"></select>`);
var root_3 = $.from_html(`<span class="unit s-b5qaxz"> </span>`);
var root_4 = $.from_html(`<input autocomplete="off" spellcheck="false"/> <!>`, 1);
var root_5 = $.from_html(`<p> <small class="code"> </small></p>`);
var root_6 = $.from_html(`<div><label class="s-b5qaxz"><!> <span> </span></label> <div><!> <!></div> <!></div>`);
function FieldInput($$anchor, $$props) {
	$.push($$props, true);
	let teach = $.prop($$props, "teach", 3, null);
	/** Takes the machine's position, where the field is one. */
	let draft = $.state(null);
	const isNumber = $.derived(() => $$props.field.choices.length === 0 && $$props.field.kind !== "name");
	const short = (number) => `${Math.round(number * 1e5) / 1e5}`;
	const shown = $.derived(() => $.get(draft) ?? ($$props.value === void 0 ? "" : typeof $$props.value === "number" ? short($$props.value) : $$props.value));
	const unread = $.derived(() => $.get(isNumber) && $.get(shown).trim() !== "" && typed($.get(shown)) === null);
	const first = $.derived(() => $$props.findings[0]);
	const id = $.derived(() => `field-${$$props.field.name}`);
	function take(text) {
		$.set(draft, text, true);
		if (!$.get(isNumber)) $$props.onvalue(text.trim() === "" ? void 0 : text.trim());
		else if (text.trim() === "") $$props.onvalue(void 0);
		else {
			const number = typed(text);
			if (number !== null) $$props.onvalue(number);
		}
	}
	var div = root_6();
	let classes;
	var label = $.child(div);
	var node = $.child(label);
	var consequent = ($$anchor) => {
		var b = root();
		var text_1 = $.only_child(b, true);
		$.template_effect(() => $.set_text(text_1, $$props.field.symbol));
		$.append($$anchor, b);
	};
	$.if(node, ($$render) => {
		if ($$props.field.symbol) $$render(consequent);
	});
	var span = $.sibling(node, 2);
	var text_2 = $.only_child(span, true);
	$.reset(label);
	var div_1 = $.sibling(label, 2);
	let classes_1;
	var node_1 = $.child(div_1);
	var consequent_1 = ($$anchor) => {
		var select = root_2();
		$.each(select, 21, () => $$props.field.choices, (choice) => choice.value, ($$anchor, choice) => {
			var option = root_1();
			var text_3 = $.only_child(option, true);
			var option_value = {};
			$.template_effect(() => {
				$.set_text(text_3, $.get(choice).title);
				if (option_value !== (option_value = $.get(choice).value)) option.value = (option.__value = option_value) ?? "";
			});
			$.append($$anchor, option);
		});
		$.reset(select);
		var select_value;
		$.init_select(select);
		$.template_effect(() => {
			$.set_attribute(select, "id", $.get(id));
			if (select_value !== (select_value = $$props.value ?? "")) select.value = (select.__value = select_value) ?? "", $.select_option(select, select_value);
		});
		$.event("focus", select, function(...$$args) {
			$$props.onfocus?.apply(this, $$args);
		});
		$.delegated("change", select, (event) => $$props.onvalue(event.currentTarget.value || void 0));
		$.append($$anchor, select);
	};
	var alternate = ($$anchor) => {
		var fragment = root_4();
		var input = $.first_child(fragment);
		$.remove_input_defaults(input);
		let classes_2;
		var node_2 = $.sibling(input, 2);
		var consequent_2 = ($$anchor) => {
			var span_1 = root_3();
			var text_4 = $.only_child(span_1, true);
			$.template_effect(($0) => $.set_text(text_4, $0), [() => unit($$props.field.unit)]);
			$.append($$anchor, span_1);
		};
		$.if(node_2, ($$render) => {
			if ($$props.field.unit) $$render(consequent_2);
		});
		$.template_effect(($0) => {
			$.set_attribute(input, "id", $.get(id));
			$.set_attribute(input, "inputmode", $0);
			$.set_attribute(input, "aria-invalid", $.get(unread) || $.get(first)?.severity === "error");
			$.set_attribute(input, "aria-describedby", $.get(first) ? `${$.get(id)}-finding` : void 0);
			$.set_value(input, $.get(shown));
			classes_2 = $.set_class(input, 1, "s-b5qaxz", null, classes_2, { number: $.get(isNumber) });
		}, [() => !$.get(isNumber) ? "text" : ["count", "tool"].includes($$props.field.kind) ? "numeric" : "decimal"]);
		$.event("focus", input, (event) => {
			event.currentTarget.select();
			$$props.onfocus();
		});
		$.delegated("input", input, (event) => take(event.currentTarget.value));
		$.event("blur", input, () => $.set(draft, null));
		$.append($$anchor, fragment);
	};
	$.if(node_1, ($$render) => {
		if ($$props.field.choices.length) $$render(consequent_1);
		else $$render(alternate, -1);
	});
	var node_3 = $.sibling(node_1, 2);
	var consequent_3 = ($$anchor) => {
		{
			let $0 = $.derived(() => t("cycles.teach"));
			let $1 = $.derived(() => t("cycles.teach"));
			Button($$anchor, {
				icon: "target",
				get "aria-label"() {
					return $.get($0);
				},
				get title() {
					return $.get($1);
				},
				onmousedown: (event) => event.preventDefault(),
				onclick: () => {
					$.set(draft, null);
					teach()();
				}
			});
		}
	};
	$.if(node_3, ($$render) => {
		if (teach() && $$props.focused) $$render(consequent_3);
	});
	$.reset(div_1);
	var node_4 = $.sibling(div_1, 2);
	var consequent_4 = ($$anchor) => {
		var p = root_5();
		var text_5 = $.child(p);
		var small = $.sibling(text_5);
		var text_6 = $.only_child(small, true);
		$.reset(p);
		$.template_effect(() => {
			$.set_attribute(p, "id", `${$.get(id) ?? ""}-finding`);
			$.set_class(p, 1, `finding ${$.get(first).severity ?? ""}`, "s-b5qaxz");
			$.set_attribute(p, "title", $.get(first).help);
			$.set_text(text_5, `${$.get(first).text ?? ""} `);
			$.set_text(text_6, $.get(first).id);
		});
		$.append($$anchor, p);
	};
	$.if(node_4, ($$render) => {
		if ($.get(first)) $$render(consequent_4);
	});
	$.reset(div);
	$.template_effect(() => {
		classes = $.set_class(div, 1, "field s-b5qaxz", null, classes, {
			focused: $$props.focused,
			wrong: $.get(unread) || $.get(first)?.severity === "error"
		});
		$.set_attribute(div, "data-name", $$props.field.name);
		$.set_attribute(label, "for", $.get(id));
		$.set_text(text_2, $$props.field.meaning);
		classes_1 = $.set_class(div_1, 1, "input s-b5qaxz", null, classes_1, { taught: teach() && $$props.focused });
	});
	$.append($$anchor, div);
	$.pop();
}
$.delegate(["change", "input"]);
export { FieldInput as default };
