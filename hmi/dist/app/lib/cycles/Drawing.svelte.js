import { box, circle } from "./geometry.js";
import { stands } from "./items.js";
import { places } from "./scene.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/cycles/Drawing.svelte
var root = $.from_svg(`<rect class="target s-sg3r9k" role="presentation"></rect>`);
var root_1 = $.from_svg(`<path></path>`);
var root_2 = $.from_svg(`<g><path class="s-sg3r9k"></path><circle class="s-sg3r9k"></circle></g>`);
var root_3 = $.from_svg(`<g><path class="helper s-sg3r9k"></path><path class="line s-sg3r9k"></path><!><text class="s-sg3r9k"> </text></g>`);
var root_4 = $.from_svg(`<svg preserveAspectRatio="xMidYMid meet" role="img" class="s-sg3r9k"><!><!></svg>`);
function Drawing($$anchor, $$props) {
	$.push($$props, true);
	const target = ($$anchor, x = $.noop, middle = $.noop, field = $.noop) => {
		var rect = root();
		$.template_effect(() => {
			$.set_attribute(rect, "x", x());
			$.set_attribute(rect, "y", middle() - $.get(touch) / 2);
			$.set_attribute(rect, "width", $.get(touch));
			$.set_attribute(rect, "height", $.get(touch));
			$.set_attribute(rect, "data-target", field());
		});
		$.delegated("click", rect, () => $$props.onfield(field()));
		$.append($$anchor, rect);
	};
	const frame = $.derived(() => box(places($$props.items), .16));
	let width = $.state(0);
	let height = $.state(0);
	const touch = $.derived(() => $.get(width) > 0 && $.get(height) > 0 ? 44 / Math.min($.get(width) / $.get(frame).w, $.get(height) / $.get(frame).h) : 0);
	const unit = $.derived(() => Math.max(Math.max($.get(frame).w, $.get(frame).h) / 100, $.get(touch) * .085));
	const y = (point) => -point[1];
	const path = (points, close = false) => points.map((p, i) => `${i ? "L" : "M"}${p[0].toFixed(4)} ${y(p).toFixed(4)}`).join("") + (close ? "Z" : "");
	function text(name) {
		const field = $$props.fields.find((one) => one.name === name);
		const value = $$props.values[name];
		const shown = typeof value === "number" ? `${Math.round(value * 1e4) / 1e4}` : "";
		return `${field?.symbol ?? name.split(".").at(-1)} ${shown}`.trim();
	}
	/** Lines of what is named, thinner ones, and where its text stands. */
	function measure(item) {
		const [dx, dy] = [item.to[0] - item.from[0], item.to[1] - item.from[1]];
		const long = Math.hypot(dx, dy);
		const n = long > 1e-9 ? [-dy / long, dx / long] : [0, 1];
		const shift = (p) => [p[0] + n[0] * item.aside, p[1] + n[1] * item.aside];
		const [a, b] = [shift(item.from), shift(item.to)];
		const stands = Math.abs(n[0]) > .7 && long > $.get(unit) * 4;
		const out = stands && item.aside < 0 ? -1 : 1;
		const side = !stands ? "middle" : n[0] * out > 0 ? "start" : "end";
		const drop = stands ? $.get(unit) * 1.1 : n[1] < 0 ? $.get(unit) * 2.6 : 0;
		const at = [(a[0] + b[0]) / 2 + n[0] * out * $.get(unit) * 1.2, (a[1] + b[1]) / 2 + n[1] * out * $.get(unit) * 1.2 - drop];
		const arrow = (p, sign) => {
			const u = long > 1e-9 ? [dx / long * sign, dy / long * sign] : [0, 0];
			const size = Math.min($.get(unit) * 1.8, long / 3);
			return path([
				[p[0] + (u[0] + n[0] * .35) * size, p[1] + (u[1] + n[1] * .35) * size],
				p,
				[p[0] + (u[0] - n[0] * .35) * size, p[1] + (u[1] - n[1] * .35) * size]
			]);
		};
		return {
			lines: long > 1e-9 ? path([a, b]) + arrow(a, 1) + arrow(b, -1) : "",
			helpers: path([item.from, a]) + path([item.to, b]),
			at,
			side
		};
	}
	function angle(item) {
		const points = Array.from({ length: 25 }, (_, i) => {
			const a = (item.from + (item.to - item.from) * i / 24) * Math.PI / 180;
			return [item.at[0] + item.radius * Math.cos(a), item.at[1] + item.radius * Math.sin(a)];
		});
		const [x, top] = points[12];
		return {
			lines: path([
				item.at,
				...points,
				item.at
			]),
			helpers: "",
			at: [x + $.get(unit) * 4, top]
		};
	}
	/** A ring about the place, its text above. */
	function place(item) {
		return {
			lines: path(circle(item.at, $.get(unit) * 1.5, 16), true),
			helpers: "",
			at: [item.at[0], item.at[1] + $.get(unit) * 2.5]
		};
	}
	var svg = root_4();
	var node = $.child(svg);
	$.each(node, 17, () => $$props.items, $.index, ($$anchor, item) => {
		var fragment = $.comment();
		var node_1 = $.first_child(fragment);
		var consequent = ($$anchor) => {
			var path_1 = root_1();
			$.template_effect(($0) => {
				$.set_class(path_1, 0, `area ${$.get(item).look ?? ""}`, "s-sg3r9k");
				$.set_attribute(path_1, "d", $0);
			}, [() => path($.get(item).points, true)]);
			$.append($$anchor, path_1);
		};
		var consequent_1 = ($$anchor) => {
			var path_2 = root_1();
			let classes;
			$.template_effect(($0) => {
				classes = $.set_class(path_2, 0, `line ${$.get(item).look ?? ""}`, "s-sg3r9k", classes, { focus: $.get(item).field === $$props.focus });
				$.set_attribute(path_2, "d", $0);
			}, [() => path($.get(item).points)]);
			$.append($$anchor, path_2);
		};
		$.if(node_1, ($$render) => {
			if ($.get(item).kind === "area") $$render(consequent);
			else if ($.get(item).kind === "line") $$render(consequent_1, 1);
		});
		$.append($$anchor, fragment);
	});
	var node_2 = $.sibling(node);
	$.each(node_2, 17, () => $$props.items, $.index, ($$anchor, item) => {
		var fragment_1 = $.comment();
		var node_3 = $.first_child(fragment_1);
		var consequent_2 = ($$anchor) => {
			var g = root_2();
			let classes_1;
			var path_3 = $.child(g);
			var circle_1 = $.sibling(path_3);
			$.reset(g);
			$.template_effect(($0, $1, $2, $3) => {
				classes_1 = $.set_class(g, 0, "mark s-sg3r9k", null, classes_1, { focus: $.get(item).field === $$props.focus });
				$.set_attribute(path_3, "d", `M${$.get(item).at[0] - $.get(unit) * 2} ${$0 ?? ""}H${$.get(item).at[0] + $.get(unit) * 2}M${$.get(item).at[0] ?? ""} ${$1 ?? ""}V${$2 ?? ""}`);
				$.set_attribute(circle_1, "cx", $.get(item).at[0]);
				$.set_attribute(circle_1, "cy", $3);
				$.set_attribute(circle_1, "r", $.get(unit) * 1.1);
			}, [
				() => y($.get(item).at),
				() => y($.get(item).at) - $.get(unit) * 2,
				() => y($.get(item).at) + $.get(unit) * 2,
				() => y($.get(item).at)
			]);
			$.append($$anchor, g);
		};
		var consequent_3 = ($$anchor) => {
			const made = $.derived(() => $.get(item).kind === "measure" ? measure($.get(item)) : $.get(item).kind === "angle" ? angle($.get(item)) : place($.get(item)));
			var g_1 = root_3();
			let classes_2;
			var path_4 = $.child(g_1);
			var path_5 = $.sibling(path_4);
			var node_4 = $.sibling(path_5);
			{
				let $0 = $.derived(() => y($.get(made).at) - $.get(unit));
				target(node_4, () => $.get(made).at[0] - $.get(touch) * ($.get(made).side === "start" ? 0 : $.get(made).side === "end" ? 1 : .5), () => $.get($0), () => $.get(item).field);
			}
			var text_1 = $.sibling(node_4);
			var text_2 = $.only_child(text_1, true);
			$.reset(g_1);
			$.template_effect(($0, $1) => {
				classes_2 = $.set_class(g_1, 0, "measure s-sg3r9k", null, classes_2, { focus: $.get(item).field === $$props.focus });
				$.set_attribute(g_1, "data-field", $.get(item).field);
				$.set_attribute(path_4, "d", $.get(made).helpers);
				$.set_attribute(path_5, "d", $.get(made).lines);
				$.set_attribute(text_1, "x", $.get(made).at[0]);
				$.set_attribute(text_1, "y", $0);
				$.set_attribute(text_1, "text-anchor", $.get(made).side ?? "middle");
				$.set_text(text_2, $1);
			}, [() => y($.get(made).at), () => text($.get(item).field)]);
			$.delegated("click", text_1, () => $$props.onfield($.get(item).field));
			$.append($$anchor, g_1);
		};
		var d = $.derived(() => $.get(item).kind !== "line" && $.get(item).kind !== "area" && ($.get(item).field === $$props.focus || stands($.get(item), $$props.values)));
		$.if(node_3, ($$render) => {
			if ($.get(item).kind === "mark") $$render(consequent_2);
			else if ($.get(d)) $$render(consequent_3, 1);
		});
		$.append($$anchor, fragment_1);
	});
	$.reset(svg);
	$.template_effect(() => {
		$.set_attribute(svg, "viewBox", `${$.get(frame).x ?? ""} ${-$.get(frame).y - $.get(frame).h} ${$.get(frame).w ?? ""} ${$.get(frame).h ?? ""}`);
		$.set_attribute(svg, "aria-label", $$props.label);
		$.set_attribute(svg, "font-size", $.get(unit) * 3.2);
	});
	$.bind_element_size(svg, "clientWidth", ($$value) => $.set(width, $$value));
	$.bind_element_size(svg, "clientHeight", ($$value) => $.set(height, $$value));
	$.append($$anchor, svg);
	$.pop();
}
$.delegate(["click"]);
export { Drawing as default };
