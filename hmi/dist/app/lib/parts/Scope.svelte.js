import { t } from "../i18n/index.svelte.js";
import { prefs } from "../state/prefs.svelte.js";
import { untrack } from "svelte";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
import uPlot from "uplot";
// src/lib/parts/Scope.svelte
var root = $.from_html(`<div class="scope s-5r4jvj" role="img"></div>`);
function Scope($$anchor, $$props) {
	$.push($$props, true);
	let steps = $.prop($$props, "steps", 3, false);
	let host = $.state(void 0);
	let plot;
	const shades = [
		"--accent",
		"--run",
		"--hold",
		"--alarm",
		"--text",
		"--muted"
	];
	const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
	/** 0 or 1 of a signal, from its height in its lane. */
	const bit = (index) => (_, height) => height === null ? "" : String(Math.round((height - ($$props.lines.length - 1 - index)) / .7));
	/** What is drawn: nothing while the lines are still those of other names. */
	const data = () => {
		if ($$props.lines.length !== $$props.names.length) return [[], ...$$props.names.map(() => [])];
		const lanes = $$props.lines.map((line, index) => steps() ? line.map((value) => value * .7 + ($$props.lines.length - 1 - index)) : line);
		return [$$props.times, ...lanes];
	};
	$.user_effect(() => {
		prefs.theme;
		const shown = $$props.names;
		if (!$.get(host)) return;
		const box = $.get(host);
		const axis = {
			stroke: colour("--muted"),
			grid: {
				stroke: colour("--line"),
				width: 1
			},
			ticks: {
				stroke: colour("--line"),
				width: 1
			}
		};
		const laned = {
			...axis,
			size: 110,
			splits: () => shown.map((_, index) => index + .35),
			values: (_, splits) => splits.map((split) => shown[shown.length - 1 - Math.floor(split)] ?? "")
		};
		const made = untrack(() => new uPlot({
			width: box.clientWidth,
			height: Math.max(160, box.clientHeight - 40),
			scales: {
				x: { time: false },
				...steps() ? { y: { range: [-.2, shown.length] } } : {}
			},
			axes: [{
				...axis,
				label: t("unit.s")
			}, steps() ? laned : {
				...axis,
				size: 80
			}],
			cursor: { drag: {
				x: true,
				y: false
			} },
			series: [{ label: t("unit.s") }, ...shown.map((name, index) => ({
				label: name,
				stroke: colour(shades[index % shades.length]),
				width: 2,
				points: { show: false },
				...steps() ? {
					paths: uPlot.paths.stepped({ align: 1 }),
					value: bit(index)
				} : {}
			}))]
		}, data(), box));
		plot = made;
		const sized = new ResizeObserver(() => made.setSize({
			width: box.clientWidth,
			height: Math.max(160, box.clientHeight - 40)
		}));
		sized.observe(box);
		return () => {
			sized.disconnect();
			made.destroy();
			plot = void 0;
		};
	});
	$.user_effect(() => {
		const now = data();
		plot?.setData(now);
	});
	var div = root();
	$.bind_this(div, ($$value) => $.set(host, $$value), () => $.get(host));
	$.template_effect(() => $.set_attribute(div, "aria-label", $$props.label));
	$.append($$anchor, div);
	$.pop();
}
export { Scope as default };
