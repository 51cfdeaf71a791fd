import { t } from "../../lib/i18n/index.svelte.js";
import { CELL, layout } from "../../lib/ladder/layout.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/plc/Rung.svelte
var root = $.from_html(`<figcaption class="s-xc2thf"> </figcaption>`);
var root_1 = $.from_svg(`<path></path>`);
var root_2 = $.from_svg(`<path class="bars s-xc2thf"></path>`);
var root_3 = $.from_svg(`<g><title> </title><rect height="52" class="hit s-xc2thf"></rect><path></path><path class="bars s-xc2thf"></path><!><text class="s-xc2thf"> </text><text class="address s-xc2thf"> </text></g>`);
var root_4 = $.from_svg(`<rect width="186" height="52" class="hit s-xc2thf"></rect><circle r="14" class="s-xc2thf"></circle><text class="s-xc2thf"> </text><text class="name s-xc2thf"> </text><text class="address start s-xc2thf"> </text>`, 1);
var root_5 = $.from_svg(`<rect width="180" height="38" rx="5" class="s-xc2thf"></rect><text class="name s-xc2thf"> </text>`, 1);
var root_6 = $.from_svg(`<g><title> </title><path></path><!></g>`);
var root_7 = $.from_html(`<figure class="s-xc2thf"><!> <svg role="group" class="s-xc2thf"><path class="rail s-xc2thf"></path><!><!><!></svg></figure>`);
function Rung($$anchor, $$props) {
	$.push($$props, true);
	const drawn = $.derived(() => layout($$props.rung, (contact) => ($$props.values[contact.name] ?? 0) !== 0 !== contact.not, (index) => $$props.power[index] ?? false));
	const short = (text, most) => text.length > most ? `${text.slice(0, most - 1)}…` : text;
	const { width: W } = CELL;
	/** What makes a part of the drawing one that is chosen, by touch or by key. */
	const choice = (name) => ({
		role: "button",
		tabindex: 0,
		"aria-label": name,
		onclick: () => $$props.onsignal(name),
		onkeydown: (event) => {
			if (event.key !== "Enter" && event.key !== " ") return;
			event.preventDefault();
			$$props.onsignal(name);
		}
	});
	var figure = root_7();
	var node = $.child(figure);
	var consequent = ($$anchor) => {
		var figcaption = root();
		var text_1 = $.only_child(figcaption, true);
		$.template_effect(() => $.set_text(text_1, $$props.rung.comment));
		$.append($$anchor, figcaption);
	};
	$.if(node, ($$render) => {
		if ($$props.rung.comment) $$render(consequent);
	});
	var svg = $.sibling(node, 2);
	var path = $.child(svg);
	var node_1 = $.sibling(path);
	$.each(node_1, 17, () => $.get(drawn).wires, $.index, ($$anchor, wire) => {
		var path_1 = root_1();
		let classes;
		$.template_effect(() => {
			classes = $.set_class(path_1, 0, "wire s-xc2thf", null, classes, { on: $.get(wire).on });
			$.set_attribute(path_1, "d", `M${$.get(wire).x1} ${$.get(wire).y1}L${$.get(wire).x2} ${$.get(wire).y2}`);
		});
		$.append($$anchor, path_1);
	});
	var node_2 = $.sibling(node_1);
	$.each(node_2, 17, () => $.get(drawn).contacts, $.index, ($$anchor, $$item) => {
		let contact = () => $.get($$item).contact;
		let x = () => $.get($$item).x;
		let y = () => $.get($$item).y;
		let on = () => $.get($$item).on;
		let conducts = () => $.get($$item).conducts;
		var g = root_3();
		$.attribute_effect(g, ($0) => ({
			class: "contact",
			...$0,
			[$.CLASS]: {
				on: on(),
				conducts: conducts()
			}
		}), [() => choice(contact().name)], void 0, void 0, "s-xc2thf");
		var title = $.child(g);
		var text_2 = $.only_child(title);
		var rect = $.sibling(title);
		var path_2 = $.sibling(rect);
		let classes_1;
		var path_3 = $.sibling(path_2);
		var node_3 = $.sibling(path_3);
		var consequent_1 = ($$anchor) => {
			var path_4 = root_2();
			$.template_effect(() => $.set_attribute(path_4, "d", `M${x() + 50} ${y() + 10}L${x() + W - 50} ${y() - 10}`));
			$.append($$anchor, path_4);
		};
		$.if(node_3, ($$render) => {
			if (contact().not) $$render(consequent_1);
		});
		var text_3 = $.sibling(node_3);
		var text_4 = $.only_child(text_3, true);
		var text_5 = $.sibling(text_3);
		var text_6 = $.only_child(text_5, true);
		$.reset(g);
		$.template_effect(($0, $1, $2) => {
			$.set_text(text_2, `${$0 ?? ""}${contact().meaning ?? ""}`);
			$.set_attribute(rect, "x", x() + 4);
			$.set_attribute(rect, "y", y() - 26);
			$.set_attribute(rect, "width", W - 8);
			classes_1 = $.set_class(path_2, 0, "wire s-xc2thf", null, classes_1, { on: on() });
			$.set_attribute(path_2, "d", `M${x()} ${y()}H${x() + 46}M${x() + W - 46} ${y()}H${x() + W}`);
			$.set_attribute(path_3, "d", `M${x() + 46} ${y() - 11}V${y() + 11}M${x() + W - 46} ${y() - 11}V${y() + 11}`);
			$.set_attribute(text_3, "x", x() + W / 2);
			$.set_attribute(text_3, "y", y() - 15);
			$.set_text(text_4, $1);
			$.set_attribute(text_5, "x", x() + W / 2);
			$.set_attribute(text_5, "y", y() + 23);
			$.set_text(text_6, $2);
		}, [
			() => $$props.symbols.get(contact().name)?.address ?? contact().name,
			() => short(contact().name, 14),
			() => $$props.symbols.get(contact().name)?.address ?? ""
		]);
		$.append($$anchor, g);
	});
	var node_4 = $.sibling(node_2);
	$.each(node_4, 17, () => $.get(drawn).outputs, $.index, ($$anchor, $$item) => {
		let output = () => $.get($$item).output;
		let x = () => $.get($$item).x;
		let y = () => $.get($$item).y;
		let on = () => $.get($$item).on;
		var g_1 = root_6();
		$.attribute_effect(g_1, ($0) => ({
			class: "output",
			...$0,
			[$.CLASS]: { on: on() }
		}), [() => output().kind === "coil" ? choice(output().name) : {}], void 0, void 0, "s-xc2thf");
		var title_1 = $.child(g_1);
		var text_7 = $.only_child(title_1);
		var path_5 = $.sibling(title_1);
		let classes_2;
		var node_5 = $.sibling(path_5);
		var consequent_2 = ($$anchor) => {
			var fragment = root_4();
			var rect_1 = $.first_child(fragment);
			var circle = $.sibling(rect_1);
			var text_8 = $.sibling(circle);
			var text_9 = $.only_child(text_8, true);
			var text_10 = $.sibling(text_8);
			var text_11 = $.only_child(text_10, true);
			var text_12 = $.sibling(text_10);
			var text_13 = $.only_child(text_12, true);
			$.template_effect(($0, $1) => {
				$.set_attribute(rect_1, "x", x() + 30);
				$.set_attribute(rect_1, "y", y() - 26);
				$.set_attribute(circle, "cx", x() + 50);
				$.set_attribute(circle, "cy", y());
				$.set_attribute(text_8, "x", x() + 50);
				$.set_attribute(text_8, "y", y() + 5);
				$.set_text(text_9, output().not ? "/" : output().text);
				$.set_attribute(text_10, "x", x() + 72);
				$.set_attribute(text_10, "y", y() - 2);
				$.set_text(text_11, $0);
				$.set_attribute(text_12, "x", x() + 72);
				$.set_attribute(text_12, "y", y() + 15);
				$.set_text(text_13, $1);
			}, [() => short(output().name, 18), () => $$props.symbols.get(output().name)?.address ?? ""]);
			$.append($$anchor, fragment);
		};
		var alternate = ($$anchor) => {
			var fragment_1 = root_5();
			var rect_2 = $.first_child(fragment_1);
			var text_14 = $.sibling(rect_2);
			var text_15 = $.only_child(text_14, true);
			$.template_effect(($0) => {
				$.set_attribute(rect_2, "x", x() + 36);
				$.set_attribute(rect_2, "y", y() - 19);
				$.set_attribute(text_14, "x", x() + 46);
				$.set_attribute(text_14, "y", y() + 5);
				$.set_text(text_15, $0);
			}, [() => short(output().text, 22)]);
			$.append($$anchor, fragment_1);
		};
		$.if(node_5, ($$render) => {
			if (output().kind === "coil") $$render(consequent_2);
			else $$render(alternate, -1);
		});
		$.reset(g_1);
		$.template_effect(($0) => {
			$.set_text(text_7, `${$0 ?? ""}${output().meaning ?? ""}`);
			classes_2 = $.set_class(path_5, 0, "wire s-xc2thf", null, classes_2, { on: on() });
			$.set_attribute(path_5, "d", `M${x()} ${y()}H${x() + 36}`);
		}, [() => $$props.symbols.get(output().name)?.address ?? output().text]);
		$.append($$anchor, g_1);
	});
	$.reset(svg);
	$.reset(figure);
	$.template_effect(($0) => {
		$.set_attribute(svg, "width", $.get(drawn).width + 16);
		$.set_attribute(svg, "height", $.get(drawn).height);
		$.set_attribute(svg, "viewBox", `-8 0 ${$.get(drawn).width + 16} ${$.get(drawn).height}`);
		$.set_attribute(svg, "aria-label", $0);
		$.set_attribute(path, "d", `M0 0V${$.get(drawn).height}`);
	}, [() => t("plc.rung", { line: $$props.rung.line })]);
	$.append($$anchor, figure);
	$.pop();
}
export { Rung as default };
