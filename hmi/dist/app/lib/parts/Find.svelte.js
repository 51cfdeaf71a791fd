import { tick } from "svelte";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Find.svelte
var rest_excludes = /* @__PURE__ */ new Set([
	"$$slots",
	"$$events",
	"$$legacy",
	"label",
	"placeholder",
	"meant",
	"at",
	"onfind"
]);
var root = $.from_html(`<input/>`);
function Find($$anchor, $$props) {
	$.push($$props, true);
	let others = $.rest_props($$props, rest_excludes);
	/** What may be typed. */
	/** The row that a text means; `null` where it is none. */
	/** The attribute by which rows are called. */
	/** Shows the part of the table that has the row. */
	let text = $.state("");
	let input = $.state(void 0);
	const row = $.derived(() => $$props.meant($.get(text)));
	async function find() {
		if ($.get(row) === null) return;
		const selector = `[${$$props.at}="${$.get(row)}"]`;
		$$props.onfind($.get(row));
		$.set(text, "");
		await tick();
		const found = $.get(input)?.closest(".card")?.querySelector(selector);
		found?.scrollIntoView({ block: "center" });
		(found?.querySelector("input") ?? found)?.focus();
	}
	var input_1 = root();
	var event_handler = (event) => {
		if (event.key === "Enter") find();
	};
	$.attribute_effect(input_1, ($0) => ({
		class: "number",
		placeholder: $$props.placeholder,
		"aria-label": $$props.label,
		autocapitalize: "characters",
		autocomplete: "off",
		spellcheck: "false",
		onkeydown: event_handler,
		...others,
		[$.CLASS]: { wrong: $0 }
	}), [() => $.get(text).trim() !== "" && $.get(row) === null], void 0, void 0, "s-hqx1rb", true);
	$.bind_this(input_1, ($$value) => $.set(input, $$value), () => $.get(input));
	$.bind_value(input_1, () => $.get(text), ($$value) => $.set(text, $$value));
	$.append($$anchor, input_1);
	$.pop();
}
export { Find as default };
