import { at } from "../graphics/path.js";
import PathView from "../graphics/PathView.svelte.js";
import { t } from "../i18n/index.svelte.js";
import { duration, fixed } from "../numbers.js";
import Button from "../parts/Button.svelte.js";
import Segmented from "../parts/Segmented.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/cycles/Simulation.svelte
var root = $.from_html(`<p class="stale s-1rgvey3" role="status"> </p>`);
var root_1 = $.from_html(`<span class="number muted"> </span>`);
var root_2 = $.from_html(`<p class="muted"> </p>`);
var root_3 = $.from_html(`<div class="simulation s-1rgvey3" data-testid="simulation"><div class="row wrap"><!> <!></div> <!> <div class="canvas s-1rgvey3"><!></div> <div class="row wrap"><!> <input class="time s-1rgvey3" type="range" min="0" step="any"/> <output class="number"> </output></div> <div class="row wrap"><!> <!></div> <!></div>`);
function Simulation($$anchor, $$props) {
	$.push($$props, true);
	let busy = $.prop($$props, "busy", 3, false), stale = $.prop($$props, "stale", 3, false);
	let view = $.state(void 0);
	let seconds = $.state(0);
	let running = $.state(false);
	let speed = $.state(10);
	const total = $.derived(() => $$props.path && $$props.path.count > 0 ? $$props.path.times[$$props.path.count - 1] : 0);
	const index = $.derived(() => $$props.path ? at($$props.path, $.get(seconds)) : -1);
	const tool = $.derived(() => $$props.path ? placeAt($$props.path, $.get(seconds)) : null);
	/** Where the tool is: between two points of the path. */
	function placeAt(of, now) {
		const last = at(of, now);
		const point = (n) => [
			0,
			1,
			2
		].map((axis) => of.points[3 * n + axis] ?? 0);
		const [from, to] = [point(last), point(last + 1 < of.count && of.kinds[last + 1] !== 0 ? last + 1 : last)];
		const [begin, end] = [of.times[last] ?? 0, of.times[last + 1] ?? 0];
		const share = end > begin ? Math.min(1, Math.max(0, (now - begin) / (end - begin))) : 0;
		const [x, y, z] = from.map((value, axis) => value + (to[axis] - value) * share);
		return x === void 0 || y === void 0 || z === void 0 ? null : {
			x,
			y,
			z
		};
	}
	$.user_effect(() => {
		$.set(seconds, $.get(total), true);
		$.set(running, false);
	});
	$.user_effect(() => {
		$.get(tool);
		$.get(view)?.overlay();
	});
	$.user_effect(() => {
		if (!$.get(running)) return;
		let last = performance.now();
		let frame = requestAnimationFrame(function step(now) {
			$.set(seconds, Math.min($.get(total), $.get(seconds) + (now - last) / 1e3 * $.get(speed)), true);
			last = now;
			if ($.get(seconds) >= $.get(total)) $.set(running, false);
			else frame = requestAnimationFrame(step);
		});
		return () => cancelAnimationFrame(frame);
	});
	function toggle() {
		if (!$.get(running) && $.get(seconds) >= $.get(total)) $.set(seconds, 0);
		$.set(running, !$.get(running));
	}
	const views = [
		"iso",
		"top",
		"front",
		"side"
	];
	var div = root_3();
	var div_1 = $.child(div);
	var node = $.child(div_1);
	$.each(node, 16, () => views, (one) => one, ($$anchor, one) => {
		Button($$anchor, {
			onclick: () => $.get(view)?.look(one),
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text = $.text();
				$.template_effect(($0) => $.set_text(text, $0), [() => t(`graphics.${one}`)]);
				$.append($$anchor, text);
			},
			$$slots: { default: true }
		});
	});
	var node_1 = $.sibling(node, 2);
	{
		let $0 = $.derived(() => t("graphics.fit"));
		let $1 = $.derived(() => t("graphics.fit"));
		Button(node_1, {
			icon: "expand",
			get "aria-label"() {
				return $.get($0);
			},
			get title() {
				return $.get($1);
			},
			onclick: () => $.get(view)?.fit()
		});
	}
	$.reset(div_1);
	var node_2 = $.sibling(div_1, 2);
	var consequent = ($$anchor) => {
		var p = root();
		var text_1 = $.only_child(p, true);
		$.template_effect(($0) => $.set_text(text_1, $0), [() => t("cycles.stale")]);
		$.append($$anchor, p);
	};
	$.if(node_2, ($$render) => {
		if (stale()) $$render(consequent);
	});
	var div_2 = $.sibling(node_2, 2);
	var node_3 = $.child(div_2);
	{
		let $0 = $.derived(() => t("cycles.simulation"));
		$.bind_this(PathView(node_3, {
			get path() {
				return $$props.path;
			},
			get done() {
				return $.get(index);
			},
			tool: () => $.get(tool),
			get label() {
				return $.get($0);
			}
		}), ($$value) => $.set(view, $$value, true), () => $.get(view));
	}
	$.reset(div_2);
	var div_3 = $.sibling(div_2, 2);
	var node_4 = $.child(div_3);
	{
		let $0 = $.derived(() => $.get(running) ? "pause" : "play");
		let $1 = $.derived(() => $.get(running) ? t("cycles.pause") : t("cycles.play"));
		let $2 = $.derived(() => !$$props.path);
		Button(node_4, {
			get icon() {
				return $.get($0);
			},
			get "aria-label"() {
				return $.get($1);
			},
			get disabled() {
				return $.get($2);
			},
			onclick: toggle
		});
	}
	var input = $.sibling(node_4, 2);
	$.remove_input_defaults(input);
	var output = $.sibling(input, 2);
	var text_2 = $.only_child(output);
	$.reset(div_3);
	var div_4 = $.sibling(div_3, 2);
	var node_5 = $.child(div_4);
	{
		let $0 = $.derived(() => t("cycles.speed"));
		let $1 = $.derived(() => [
			1,
			10,
			100
		].map((value) => ({
			value,
			label: `${value}×`
		})));
		Segmented(node_5, {
			get label() {
				return $.get($0);
			},
			get options() {
				return $.get($1);
			},
			get value() {
				return $.get(speed);
			},
			set value($$value) {
				$.set(speed, $$value, true);
			}
		});
	}
	var node_6 = $.sibling(node_5, 2);
	var consequent_1 = ($$anchor) => {
		var span = root_1();
		var text_3 = $.only_child(span);
		$.template_effect(($0, $1, $2) => $.set_text(text_3, `X ${$0 ?? ""} Y ${$1 ?? ""} Z ${$2 ?? ""}`), [
			() => fixed($.get(tool).x),
			() => fixed($.get(tool).y),
			() => fixed($.get(tool).z)
		]);
		$.append($$anchor, span);
	};
	$.if(node_6, ($$render) => {
		if ($.get(tool)) $$render(consequent_1);
	});
	$.reset(div_4);
	var node_7 = $.sibling(div_4, 2);
	var consequent_2 = ($$anchor) => {
		var p_1 = root_2();
		var text_4 = $.only_child(p_1, true);
		$.template_effect(($0) => $.set_text(text_4, $0), [() => t("cycles.path_short")]);
		$.append($$anchor, p_1);
	};
	$.if(node_7, ($$render) => {
		if ($$props.path?.short) $$render(consequent_2);
	});
	$.reset(div);
	$.template_effect(($0, $1, $2, $3) => {
		$.set_attribute(div, "data-seconds", $0);
		$.set_attribute(div, "data-points", $$props.path?.count ?? 0);
		$.set_attribute(div, "data-time", $.get(seconds));
		$.set_attribute(div, "aria-busy", busy());
		$.set_attribute(div, "data-stale", stale());
		$.set_attribute(input, "max", $.get(total));
		$.set_attribute(input, "aria-label", $1);
		input.disabled = !$$props.path;
		$.set_text(text_2, `${$2 ?? ""} / ${$3 ?? ""}`);
	}, [
		() => $.get(total).toFixed(1),
		() => t("cycles.time"),
		() => duration($.get(seconds)),
		() => duration($.get(total))
	]);
	$.bind_value(input, () => $.get(seconds), ($$value) => $.set(seconds, $$value));
	$.append($$anchor, div);
	$.pop();
}
export { Simulation as default };
