import { machine } from "../state/machine.svelte.js";
import { held } from "./held.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/parts/Key.svelte
var root = $.from_html(`<i class="lamp s-7zbxlt" aria-hidden="true"></i>`);
var root_1 = $.from_html(`<i aria-hidden="true"></i>`);
var root_2 = $.from_html(`<button type="button"><!> <!> <!></button>`);
function Key($$anchor, $$props) {
	$.push($$props, true);
	let lamp = $.prop($$props, "lamp", 3, ""), beside = $.prop($$props, "beside", 3, ""), kind = $.prop($$props, "kind", 3, "plain"), disabled = $.prop($$props, "disabled", 3, false), everybody = $.prop($$props, "everybody", 3, false), chosen = $.prop($$props, "chosen", 3, false);
	/** The ladder's name of its input: `KEY_START`. */
	/** The ladder's name of its lamp. */
	/** A lamp on the key that says nothing of the key, such as that its axis is at its reference point. */
	/** Whether those who watch may press it too. */
	/** Whether what it chooses is in force; for keys without a lamp. */
	const lit = $.derived(() => lamp() !== "" && machine.lamps.has(lamp()));
	const off = $.derived(() => disabled() || !(machine.inCommand || everybody() && machine.link === "open"));
	var button = root_2();
	let classes;
	var node = $.child(button);
	var consequent = ($$anchor) => {
		var fragment = $.comment();
		var node_1 = $.first_child(fragment);
		$.snippet(node_1, () => $$props.children);
		$.append($$anchor, fragment);
	};
	var alternate = ($$anchor) => {
		var text = $.text();
		$.template_effect(() => $.set_text(text, $$props.label));
		$.append($$anchor, text);
	};
	$.if(node, ($$render) => {
		if ($$props.children) $$render(consequent);
		else $$render(alternate, -1);
	});
	var node_2 = $.sibling(node, 2);
	var consequent_1 = ($$anchor) => {
		var i = root();
		$.append($$anchor, i);
	};
	$.if(node_2, ($$render) => {
		if (lamp()) $$render(consequent_1);
	});
	var node_3 = $.sibling(node_2, 2);
	var consequent_2 = ($$anchor) => {
		var i_1 = root_1();
		let classes_1;
		$.template_effect(($0) => {
			classes_1 = $.set_class(i_1, 1, "lamp s-7zbxlt", null, classes_1, { on: $0 });
			$.set_attribute(i_1, "data-lamp", beside());
		}, [() => machine.lamps.has(beside())]);
		$.append($$anchor, i_1);
	};
	$.if(node_3, ($$render) => {
		if (beside()) $$render(consequent_2);
	});
	$.reset(button);
	$.attach(button, () => held(() => {
		const name = $$props.signal;
		return {
			down: () => machine.hold(name),
			up: () => machine.release(name)
		};
	}));
	$.template_effect(() => {
		classes = $.set_class(button, 1, `key ${kind() ?? ""}`, "s-7zbxlt", classes, {
			lit: $.get(lit),
			chosen: chosen()
		});
		$.set_attribute(button, "data-signal", $$props.signal);
		$.set_attribute(button, "title", $$props.label);
		$.set_attribute(button, "aria-label", $$props.label);
		$.set_attribute(button, "aria-pressed", lamp() ? $.get(lit) : void 0);
		button.disabled = $.get(off);
	});
	$.append($$anchor, button);
	$.pop();
}
export { Key as default };
