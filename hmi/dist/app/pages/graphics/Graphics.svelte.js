import { http } from "../../lib/api/http.js";
import { number, t } from "../../lib/i18n/index.svelte.js";
import { at, busiest, follow, middle, readPath, spanOf } from "../../lib/graphics/path.js";
import PathView from "../../lib/graphics/PathView.svelte.js";
import { duration, fixed } from "../../lib/numbers.js";
import Button from "../../lib/parts/Button.svelte.js";
import Dialog from "../../lib/parts/Dialog.svelte.js";
import Empty from "../../lib/parts/Empty.svelte.js";
import NumberField from "../../lib/parts/NumberField.svelte.js";
import Page from "../../lib/parts/Page.svelte.js";
import { go } from "../../lib/routing.svelte.js";
import { machine } from "../../lib/state/machine.svelte.js";
import { prefs } from "../../lib/state/prefs.svelte.js";
import { trail } from "../../lib/state/trail.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/pages/graphics/Graphics.svelte
var root = $.from_html(`<p class="over muted s-9glm32"> </p>`);
var root_1 = $.from_html(`<p class="over bad s-9glm32"> <br/><small> </small></p>`);
var root_2 = $.from_html(`<p class="note bad s-9glm32"> </p>`);
var root_3 = $.from_html(`<p class="note s-9glm32"> </p>`);
var root_4 = $.from_html(`<div> <span class="muted"> </span></div>`);
var root_5 = $.from_html(`<div></div> <strong> </strong>`, 1);
var root_6 = $.from_html(`<span class="muted"> </span>`);
var root_7 = $.from_html(`<div class="picked number s-9glm32" data-testid="picked"><small class="muted"> </small> <!> <!> <!></div>`);
var root_8 = $.from_html(`<div class="row"><span class="label"> </span> <input type="range" class="grow s-9glm32" step="any"/> <output class="number"> </output> <small class="muted"> </small></div>`);
var root_9 = $.from_html(`<div class="row"><!> <input type="range" class="grow s-9glm32" min="0" step="any" data-testid="time"/> <output class="number times s-9glm32"> </output> <span class="muted"> </span></div>`);
var root_10 = $.from_html(`<p class="muted facts s-9glm32"> </p>`);
var root_11 = $.from_html(`<div class="graphics s-9glm32"><div class="row wrap"><strong class="code"> </strong> <span class="grow"></span> <!> <!> <!> <!> <!> <!> <!> <!> <!></div> <div class="canvas s-9glm32"><!> <!> <!> <!> <!> <!></div> <!> <!> <!></div>`);
var root_12 = $.from_html(`<!> <!>`, 1);
var root_13 = $.from_html(`<td><!></td>`);
var root_14 = $.from_html(`<tr><th scope="row"> </th><!><td><!></td></tr>`);
var root_15 = $.from_html(`<!> <p class="muted"> </p> <table class="table"><thead><tr><th> </th><th> </th><th> </th><th> </th></tr></thead><tbody></tbody></table> <div class="row"><span> </span> <span class="scale s-9glm32"><!></span> <span class="muted"> </span></div>`, 1);
function Graphics($$anchor, $$props) {
	$.push($$props, true);
	const AXES = [
		"X",
		"Y",
		"Z"
	];
	const program = $.derived(() => machine.status?.program.selected ?? null);
	let path = $.state(null);
	let failed = $.state("");
	let loading = $.state(false);
	let took = $.state(0);
	let view = $.state(void 0);
	let live = $.state(true);
	let place = $.state(0);
	/** Up to here the path is drawn as done. */
	let drawn = $.state(0);
	let draws = false;
	let setting = $.state(false);
	/** Machine position of the zero of the work, by which the range that is set is turned into one of the machine. */
	let zero = $.state([
		0,
		0,
		0
	]);
	let time = $.state(0);
	let rapids = $.state(true);
	let cut = $.state(false);
	let height = $.state(0);
	let thick = $.state(1);
	/** Whether somebody has set the height for this path. */
	let isSet = false;
	let measuring = $.state(false);
	let picked = $.state([]);
	$.user_effect(() => {
		const wanted = $.get(program);
		machine.changed("programs");
		machine.changed("zeros");
		machine.changed("offsets");
		const abort = new AbortController();
		$.set(failed, "");
		$.set(path, null);
		$.set(picked, []);
		$.set(loading, false);
		if (!wanted || machine.link !== "open") return;
		$.set(loading, true);
		const start = performance.now();
		http.path(wanted, abort.signal).then((buffer) => {
			$.set(path, readPath(buffer));
			$.set(took, performance.now() - start);
			$.set(place, 0);
			$.set(drawn, 0);
			$.set(time, 0);
			$.set(thick, Math.max(.1, ($.get(path).box.high[2] - $.get(path).box.low[2]) / 20), true);
			isSet = false;
			if ($.get(cut)) placeSection();
			$.set(loading, false);
		}, (reason) => {
			if (abort.signal.aborted) return;
			$.set(loading, false);
			machine.reason(reason).then(({ title, text = "" }) => {
				if (!abort.signal.aborted) $.set(failed, `${title} ${text}`.trim(), true);
			});
		});
		return () => abort.abort();
	});
	const tool = () => {
		if (!$.get(live) && $.get(path)) {
			const index = at($.get(path), $.get(time));
			return {
				x: $.get(path).points[3 * index],
				y: $.get(path).points[3 * index + 1],
				z: $.get(path).points[3 * index + 2]
			};
		}
		const here = machine.status?.position.machine;
		return here ? {
			x: here.X ?? 0,
			y: here.Y ?? 0,
			z: here.Z ?? 0
		} : null;
	};
	$.user_effect(() => machine.watch((status) => {
		if (!$.get(live)) return;
		const { line, running } = status.program;
		const { machine: at, work } = status.position;
		const now = AXES.map((axis) => (at[axis] ?? 0) - (work[axis] ?? 0));
		if (now.some((value, axis) => Math.abs(value - $.get(zero)[axis]) > 1e-4)) $.set(zero, now);
		if ($.get(path) && line > 0 && running && status.program_mode === "auto") {
			const here = status.position.machine;
			if (!draws) {
				$.set(place, 0);
				if (prefs.drawing.erases) $.set(drawn, 0);
			}
			draws = true;
			$.set(place, follow($.get(path), running === $.get(program) ? line : 0, [
				here.X ?? 0,
				here.Y ?? 0,
				here.Z ?? 0
			], $.get(place)), true);
			$.set(drawn, Math.max($.get(drawn), $.get(place)), true);
		} else if (status.activity === "idle") {
			$.set(place, 0);
			draws = false;
		}
		$.get(view)?.overlay();
	}));
	let trailed = -1;
	$.user_effect(() => $.get(view)?.grown(trail.drawn));
	$.user_effect(() => machine.watch(() => {
		if (trailed !== trail.drawn.changes) $.get(view)?.grown(trail.drawn);
		trailed = trail.drawn.changes;
	}));
	const total = $.derived(() => $.get(path) && $.get(path).count > 0 ? $.get(path).times[$.get(path).count - 1] : 0);
	const shownTime = $.derived(() => $.get(live) ? $.get(path)?.times[$.get(place)] ?? 0 : $.get(time));
	const shownPlace = $.derived(() => $.get(path) ? $.get(live) ? $.get(place) : at($.get(path), $.get(time)) : -1);
	const range = $.derived(() => {
		const set = prefs.drawing.range;
		const moved = (to) => to.map((value, axis) => value + $.get(zero)[axis]);
		return set && {
			low: moved(set.low),
			high: moved(set.high)
		};
	});
	/** What the fields of the range have: what is set, or that of the program. */
	const extremes = $.derived(() => {
		if (prefs.drawing.range) return prefs.drawing.range;
		const back = (to) => to.map((value, axis) => value - $.get(zero)[axis]);
		return $.get(path) ? {
			low: back($.get(path).box.low),
			high: back($.get(path).box.high)
		} : {
			low: [
				0,
				0,
				0
			],
			high: [
				100,
				100,
				100
			]
		};
	});
	function setExtreme(which, axis, value) {
		if (value === null) return;
		const next = {
			low: [...$.get(extremes).low],
			high: [...$.get(extremes).high]
		};
		next[which][axis] = value;
		prefs.drawing.range = next;
		prefs.drawing.frame = null;
	}
	const frame = $.derived(() => {
		const set = prefs.drawing.frame;
		return set && {
			scale: set.scale,
			centre: set.centre.map((value, axis) => value + $.get(zero)[axis])
		};
	});
	/** What the fields of scale and centre have: what is set, or what follows from the extremes while they are shown. */
	const framing = $.derived(() => prefs.drawing.frame ?? {
		centre: middle($.get(extremes)),
		scale: $.get(setting) ? ($.get(view)?.across() ?? 0) / spanOf($.get(extremes)) : 0
	});
	/** Scales that a drawing may have. */
	const [LEAST_SCALE, GREATEST_SCALE] = [.001, 1e3];
	function setCentre(axis, value) {
		if (value !== null) prefs.drawing.frame = {
			scale: $.get(framing).scale,
			centre: $.get(framing).centre.with(axis, value)
		};
	}
	function setScale(scale) {
		if (scale !== null) prefs.drawing.frame = {
			scale,
			centre: [...$.get(framing).centre]
		};
	}
	const override = $.derived(() => Math.max(.01, machine.status?.feed.feed_override ?? 1));
	const rest = $.derived(() => ($.get(total) - $.get(shownTime)) / $.get(override));
	const marks = $.derived(() => $.get(path) ? $.get(picked).map((index) => ({
		x: $.get(path).points[3 * index],
		y: $.get(path).points[3 * index + 1],
		z: $.get(path).points[3 * index + 2]
	})) : []);
	/** The way from the first point to the second. */
	const between = $.derived(() => $.get(marks).length === 2 ? [
		"x",
		"y",
		"z"
	].map((axis) => [axis.toUpperCase(), $.get(marks)[1][axis] - $.get(marks)[0][axis]]) : null);
	function pick(index) {
		if ($.get(measuring)) $.set(picked, $.get(picked).length === 1 ? [$.get(picked)[0], index] : [index]);
		else $.set(picked, [index]);
	}
	/** A section begins where there is something to see in it. */
	function section() {
		$.set(cut, !$.get(cut));
		if ($.get(cut)) placeSection();
	}
	function placeSection() {
		if (isSet || !$.get(path)) return;
		const { low, high } = $.get(path).box;
		$.set(height, Math.min(high[2], Math.max(low[2], (busiest($.get(path)) ?? (low[2] + high[2]) / 2) + $.get(thick) / 2)), true);
		isSet = true;
	}
	function erase() {
		$.set(drawn, 0);
		trail.clear();
		$.get(view)?.grown(trail.drawn);
	}
	const views = [
		"top",
		"side",
		"turned",
		"front",
		"iso",
		"around"
	];
	let seen = $.state("iso");
	function look(to) {
		$.set(seen, to, true);
		$.get(view)?.look(to);
	}
	var fragment = root_12();
	var node = $.first_child(fragment);
	Page(node, {
		page: "graphics",
		children: ($$anchor, $$slotProps) => {
			var fragment_1 = $.comment();
			var node_1 = $.first_child(fragment_1);
			var consequent = ($$anchor) => {
				{
					let $0 = $.derived(() => t("graphics.none"));
					let $1 = $.derived(() => t("graphics.none_text"));
					Empty($$anchor, {
						icon: "graphics",
						get title() {
							return $.get($0);
						},
						get text() {
							return $.get($1);
						},
						children: ($$anchor, $$slotProps) => {
							Button($$anchor, {
								kind: "primary",
								icon: "list",
								onclick: () => go("program", "directory"),
								children: ($$anchor, $$slotProps) => {
									$.next();
									var text_1 = $.text();
									$.template_effect(($0) => $.set_text(text_1, $0), [() => t("program.directory")]);
									$.append($$anchor, text_1);
								},
								$$slots: { default: true }
							});
						},
						$$slots: { default: true }
					});
				}
			};
			var alternate = ($$anchor) => {
				var div = root_11();
				var div_1 = $.child(div);
				var strong = $.child(div_1);
				var text_2 = $.only_child(strong, true);
				var node_2 = $.sibling(strong, 4);
				$.each(node_2, 16, () => views, (one) => one, ($$anchor, one) => {
					Button($$anchor, {
						onclick: () => look(one),
						get "data-view"() {
							return one;
						},
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_3 = $.text();
							$.template_effect(($0) => $.set_text(text_3, $0), [() => t(`graphics.${one}`)]);
							$.append($$anchor, text_3);
						},
						$$slots: { default: true }
					});
				});
				var node_3 = $.sibling(node_2, 2);
				{
					let $0 = $.derived(() => t("graphics.next"));
					let $1 = $.derived(() => t("graphics.next"));
					Button(node_3, {
						icon: "cw",
						get "aria-label"() {
							return $.get($0);
						},
						get title() {
							return $.get($1);
						},
						get "data-seen"() {
							return $.get(seen);
						},
						"data-testid": "next-view",
						onclick: () => look(views[(views.indexOf($.get(seen)) + 1) % views.length])
					});
				}
				var node_4 = $.sibling(node_3, 2);
				{
					let $0 = $.derived(() => t("graphics.fit"));
					let $1 = $.derived(() => t("graphics.fit"));
					Button(node_4, {
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
				var node_5 = $.sibling(node_4, 2);
				{
					let $0 = $.derived(() => t("graphics.erase"));
					let $1 = $.derived(() => t("graphics.erase"));
					Button(node_5, {
						icon: "trash",
						get "aria-label"() {
							return $.get($0);
						},
						get title() {
							return $.get($1);
						},
						onclick: erase,
						"data-testid": "erase"
					});
				}
				var node_6 = $.sibling(node_5, 2);
				{
					let $0 = $.derived(() => t("graphics.trail_text"));
					Button(node_6, {
						get pressed() {
							return prefs.drawing.trail;
						},
						get title() {
							return $.get($0);
						},
						onclick: () => prefs.drawing.trail = !prefs.drawing.trail,
						"data-testid": "trail",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_4 = $.text();
							$.template_effect(($0) => $.set_text(text_4, $0), [() => t("graphics.trail")]);
							$.append($$anchor, text_4);
						},
						$$slots: { default: true }
					});
				}
				var node_7 = $.sibling(node_6, 2);
				{
					let $0 = $.derived(() => t("graphics.settings"));
					let $1 = $.derived(() => t("graphics.settings"));
					Button(node_7, {
						icon: "settings",
						get "aria-label"() {
							return $.get($0);
						},
						get title() {
							return $.get($1);
						},
						onclick: () => $.set(setting, true),
						"data-testid": "drawing"
					});
				}
				var node_8 = $.sibling(node_7, 2);
				Button(node_8, {
					get pressed() {
						return $.get(rapids);
					},
					onclick: () => $.set(rapids, !$.get(rapids)),
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_5 = $.text();
						$.template_effect(($0) => $.set_text(text_5, $0), [() => t("graphics.rapids")]);
						$.append($$anchor, text_5);
					},
					$$slots: { default: true }
				});
				var node_9 = $.sibling(node_8, 2);
				Button(node_9, {
					get pressed() {
						return $.get(cut);
					},
					onclick: section,
					"data-testid": "section",
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_6 = $.text();
						$.template_effect(($0) => $.set_text(text_6, $0), [() => t("graphics.section")]);
						$.append($$anchor, text_6);
					},
					$$slots: { default: true }
				});
				var node_10 = $.sibling(node_9, 2);
				{
					let $0 = $.derived(() => t("graphics.measure"));
					let $1 = $.derived(() => t("graphics.measure"));
					Button(node_10, {
						icon: "ruler",
						get "aria-label"() {
							return $.get($0);
						},
						get title() {
							return $.get($1);
						},
						get pressed() {
							return $.get(measuring);
						},
						onclick: () => {
							$.set(measuring, !$.get(measuring));
							$.set(picked, []);
						},
						"data-testid": "measure"
					});
				}
				$.reset(div_1);
				var div_2 = $.sibling(div_1, 2);
				var node_11 = $.child(div_2);
				{
					let $0 = $.derived(() => $.get(live) ? $.get(drawn) : $.get(shownPlace));
					let $1 = $.derived(() => $.get(cut) ? [$.get(height) - $.get(thick), $.get(height)] : null);
					let $2 = $.derived(() => t("graphics.title"));
					$.bind_this(PathView(node_11, {
						get path() {
							return $.get(path);
						},
						get done() {
							return $.get($0);
						},
						get range() {
							return $.get(range);
						},
						get frame() {
							return $.get(frame);
						},
						get rapids() {
							return $.get(rapids);
						},
						get section() {
							return $.get($1);
						},
						get marks() {
							return $.get(marks);
						},
						tool,
						get label() {
							return $.get($2);
						},
						onpick: pick
					}), ($$value) => $.set(view, $$value, true), () => $.get(view));
				}
				var node_12 = $.sibling(node_11, 2);
				var consequent_1 = ($$anchor) => {
					var p = root();
					var text_7 = $.only_child(p, true);
					$.template_effect(($0) => $.set_text(text_7, $0), [() => t("app.loading")]);
					$.append($$anchor, p);
				};
				$.if(node_12, ($$render) => {
					if ($.get(loading)) $$render(consequent_1);
				});
				var node_13 = $.sibling(node_12, 2);
				var consequent_2 = ($$anchor) => {
					var p_1 = root_1();
					var text_8 = $.child(p_1, true);
					var small = $.sibling(text_8, 2);
					var text_9 = $.only_child(small, true);
					$.reset(p_1);
					$.template_effect(($0) => {
						$.set_text(text_8, $0);
						$.set_text(text_9, $.get(failed));
					}, [() => t("graphics.failed")]);
					$.append($$anchor, p_1);
				};
				$.if(node_13, ($$render) => {
					if ($.get(failed)) $$render(consequent_2);
				});
				var node_14 = $.sibling(node_13, 2);
				var consequent_3 = ($$anchor) => {
					var p_2 = root_2();
					var text_10 = $.only_child(p_2, true);
					$.template_effect(($0) => $.set_text(text_10, $0), [() => t("graphics.cut_by_alarm")]);
					$.append($$anchor, p_2);
				};
				$.if(node_14, ($$render) => {
					if ($.get(path)?.alarm) $$render(consequent_3);
				});
				var node_15 = $.sibling(node_14, 2);
				var consequent_4 = ($$anchor) => {
					var p_3 = root_3();
					var text_11 = $.only_child(p_3, true);
					$.template_effect(($0) => $.set_text(text_11, $0), [() => t("graphics.cut_by_size")]);
					$.append($$anchor, p_3);
				};
				$.if(node_15, ($$render) => {
					if ($.get(path)?.short) $$render(consequent_4);
				});
				var node_16 = $.sibling(node_15, 2);
				var consequent_7 = ($$anchor) => {
					var div_3 = root_7();
					var small_1 = $.child(div_3);
					var text_12 = $.only_child(small_1, true);
					var node_17 = $.sibling(small_1, 2);
					$.each(node_17, 17, () => $.get(marks), $.index, ($$anchor, mark, index) => {
						var div_4 = root_4();
						var text_13 = $.child(div_4);
						var span = $.sibling(text_13);
						var text_14 = $.only_child(span, true);
						$.reset(div_4);
						$.template_effect(($0, $1, $2, $3) => {
							$.set_text(text_13, `X ${$0 ?? ""} Y ${$1 ?? ""} Z ${$2 ?? ""} `);
							$.set_text(text_14, $3);
						}, [
							() => fixed($.get(mark).x),
							() => fixed($.get(mark).y),
							() => fixed($.get(mark).z),
							() => t("graphics.line", { line: $.get(path)?.lines[$.get(picked)[index]] ?? 0 })
						]);
						$.append($$anchor, div_4);
					});
					var node_18 = $.sibling(node_17, 2);
					var consequent_5 = ($$anchor) => {
						var fragment_10 = root_5();
						var div_5 = $.first_child(fragment_10);
						$.each(div_5, 21, () => $.get(between), ([axis, way]) => axis, ($$anchor, $$item) => {
							var $$array = $.derived(() => $.to_array($.get($$item), 2));
							let axis = () => $.get($$array)[0];
							let way = () => $.get($$array)[1];
							$.next();
							var text_15 = $.text();
							$.template_effect(($0) => $.set_text(text_15, `${`Δ${axis()}`} ${$0 ?? ""} `), [() => fixed(way())]);
							$.append($$anchor, text_15);
						});
						$.reset(div_5);
						var strong_1 = $.sibling(div_5, 2);
						var text_16 = $.only_child(strong_1, true);
						$.template_effect(($0) => $.set_text(text_16, $0), [() => t("graphics.distance", { distance: fixed(Math.hypot(...$.get(between).map(([, way]) => way))) })]);
						$.append($$anchor, fragment_10);
					};
					$.if(node_18, ($$render) => {
						if ($.get(between)) $$render(consequent_5);
					});
					var node_19 = $.sibling(node_18, 2);
					var consequent_6 = ($$anchor) => {
						var span_1 = root_6();
						var text_17 = $.only_child(span_1, true);
						$.template_effect(($0) => $.set_text(text_17, $0), [() => t("graphics.second")]);
						$.append($$anchor, span_1);
					};
					$.if(node_19, ($$render) => {
						if ($.get(measuring) && $.get(marks).length === 1) $$render(consequent_6);
					});
					$.reset(div_3);
					$.template_effect(($0) => $.set_text(text_12, $0), [() => t("position.machine")]);
					$.append($$anchor, div_3);
				};
				$.if(node_16, ($$render) => {
					if ($.get(marks).length) $$render(consequent_7);
				});
				$.reset(div_2);
				var node_20 = $.sibling(div_2, 2);
				var consequent_8 = ($$anchor) => {
					var div_6 = root_8();
					var span_2 = $.child(div_6);
					var text_18 = $.only_child(span_2, true);
					var input = $.sibling(span_2, 2);
					$.remove_input_defaults(input);
					var output = $.sibling(input, 2);
					var text_19 = $.only_child(output);
					var small_2 = $.sibling(output, 2);
					var text_20 = $.only_child(small_2, true);
					$.reset(div_6);
					$.template_effect(($0, $1, $2, $3) => {
						$.set_text(text_18, $0);
						$.set_attribute(input, "min", $.get(path).box.low[2]);
						$.set_attribute(input, "max", $.get(path).box.high[2]);
						$.set_attribute(input, "aria-label", $1);
						$.set_text(text_19, `Z ${$2 ?? ""}`);
						$.set_text(text_20, $3);
					}, [
						() => t("graphics.height"),
						() => t("graphics.height"),
						() => fixed($.get(height)),
						() => t("position.machine")
					]);
					$.bind_value(input, () => $.get(height), ($$value) => $.set(height, $$value));
					$.append($$anchor, div_6);
				};
				$.if(node_20, ($$render) => {
					if ($.get(cut) && $.get(path)) $$render(consequent_8);
				});
				var node_21 = $.sibling(node_20, 2);
				var consequent_9 = ($$anchor) => {
					var div_7 = root_9();
					var node_22 = $.child(div_7);
					Button(node_22, {
						get pressed() {
							return $.get(live);
						},
						onclick: () => {
							$.set(time, $.get(shownTime), true);
							$.set(live, !$.get(live));
						},
						"data-testid": "live",
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_21 = $.text();
							$.template_effect(($0) => $.set_text(text_21, $0), [() => t("graphics.live")]);
							$.append($$anchor, text_21);
						},
						$$slots: { default: true }
					});
					var input_1 = $.sibling(node_22, 2);
					$.remove_input_defaults(input_1);
					var output_1 = $.sibling(input_1, 2);
					var text_22 = $.only_child(output_1);
					var span_3 = $.sibling(output_1, 2);
					var text_23 = $.only_child(span_3, true);
					$.reset(div_7);
					$.template_effect(($0, $1, $2, $3) => {
						$.set_attribute(input_1, "max", $.get(total));
						$.set_value(input_1, $.get(shownTime));
						$.set_attribute(input_1, "aria-label", $0);
						$.set_text(text_22, `${$1 ?? ""} / ${$2 ?? ""}`);
						$.set_text(text_23, $3);
					}, [
						() => t("graphics.time"),
						() => duration($.get(shownTime)),
						() => duration($.get(total)),
						() => t("graphics.rest", { time: duration($.get(rest)) })
					]);
					$.delegated("input", input_1, (event) => {
						$.set(live, false);
						$.set(time, Number(event.currentTarget.value), true);
						$.get(view)?.overlay();
					});
					$.append($$anchor, div_7);
				};
				$.if(node_21, ($$render) => {
					if ($.get(program)) $$render(consequent_9);
				});
				var node_23 = $.sibling(node_21, 2);
				var consequent_10 = ($$anchor) => {
					var p_4 = root_10();
					var text_24 = $.only_child(p_4, true);
					$.template_effect(($0) => $.set_text(text_24, $0), [() => t("graphics.facts", {
						n: number($.get(path).count),
						x: fixed($.get(path).box.high[0] - $.get(path).box.low[0], 1),
						y: fixed($.get(path).box.high[1] - $.get(path).box.low[1], 1),
						z: fixed($.get(path).box.high[2] - $.get(path).box.low[2], 1)
					})]);
					$.append($$anchor, p_4);
				};
				$.if(node_23, ($$render) => {
					if ($.get(path)) $$render(consequent_10);
				});
				$.reset(div);
				$.template_effect(() => {
					$.set_attribute(div, "data-loaded", $.get(path) !== null);
					$.set_attribute(div, "data-points", $.get(path)?.count ?? 0);
					$.set_attribute(div, "data-took", $.get(took));
					$.set_attribute(div, "data-place", $.get(shownPlace));
					$.set_attribute(div, "data-drawn", $.get(drawn));
					$.set_attribute(div, "data-trail", trail.any);
					$.set_text(text_2, $.get(program));
				});
				$.append($$anchor, div);
			};
			$.if(node_1, ($$render) => {
				if (!$.get(program) && !trail.any) $$render(consequent);
				else $$render(alternate, -1);
			});
			$.append($$anchor, fragment_1);
		},
		$$slots: { default: true }
	});
	var node_24 = $.sibling(node, 2);
	{
		const actions = ($$anchor) => {
			var fragment_13 = root_12();
			var node_25 = $.first_child(fragment_13);
			{
				let $0 = $.derived(() => !prefs.drawing.range && !prefs.drawing.frame);
				Button(node_25, {
					get disabled() {
						return $.get($0);
					},
					onclick: () => {
						prefs.drawing.range = null;
						prefs.drawing.frame = null;
					},
					"data-testid": "whole-path",
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_25 = $.text();
						$.template_effect(($0) => $.set_text(text_25, $0), [() => t("graphics.whole")]);
						$.append($$anchor, text_25);
					},
					$$slots: { default: true }
				});
			}
			var node_26 = $.sibling(node_25, 2);
			Button(node_26, {
				kind: "primary",
				onclick: () => $.set(setting, false),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_26 = $.text();
					$.template_effect(($0) => $.set_text(text_26, $0), [() => t("app.close")]);
					$.append($$anchor, text_26);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_13);
		};
		let $0 = $.derived(() => t("graphics.settings"));
		Dialog(node_24, {
			get title() {
				return $.get($0);
			},
			get open() {
				return $.get(setting);
			},
			set open($$value) {
				$.set(setting, $$value, true);
			},
			actions,
			children: ($$anchor, $$slotProps) => {
				var fragment_16 = root_15();
				var node_27 = $.first_child(fragment_16);
				Button(node_27, {
					get pressed() {
						return prefs.drawing.erases;
					},
					onclick: () => prefs.drawing.erases = !prefs.drawing.erases,
					"data-testid": "erases",
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_27 = $.text();
						$.template_effect(($0) => $.set_text(text_27, $0), [() => t("graphics.erases")]);
						$.append($$anchor, text_27);
					},
					$$slots: { default: true }
				});
				var p_5 = $.sibling(node_27, 2);
				var text_28 = $.only_child(p_5, true);
				var table = $.sibling(p_5, 2);
				var thead = $.child(table);
				var tr = $.child(thead);
				var th = $.child(tr);
				var text_29 = $.only_child(th, true);
				var th_1 = $.sibling(th);
				var text_30 = $.only_child(th_1, true);
				var th_2 = $.sibling(th_1);
				var text_31 = $.only_child(th_2, true);
				var th_3 = $.sibling(th_2);
				var text_32 = $.only_child(th_3, true);
				$.reset(tr);
				$.reset(thead);
				var tbody = $.sibling(thead);
				$.each(tbody, 22, () => AXES, (axis) => axis, ($$anchor, axis, index) => {
					var tr_1 = root_14();
					var th_4 = $.child(tr_1);
					var text_33 = $.only_child(th_4, true);
					var node_28 = $.sibling(th_4);
					$.each(node_28, 16, () => ["low", "high"], (which) => which, ($$anchor, which) => {
						var td = root_13();
						var node_29 = $.child(td);
						{
							let $0 = $.derived(() => `${axis} ${t(which === "low" ? "graphics.least" : "graphics.greatest")}`);
							let $1 = $.derived(() => which === "high" ? $.get(extremes).low[$.get(index)] : -99999);
							let $2 = $.derived(() => which === "low" ? $.get(extremes).high[$.get(index)] : 99999);
							NumberField(node_29, {
								get label() {
									return $.get($0);
								},
								get value() {
									return $.get(extremes)[which][$.get(index)];
								},
								get minimum() {
									return $.get($1);
								},
								get maximum() {
									return $.get($2);
								},
								onvalue: (value) => setExtreme(which, $.get(index), value)
							});
						}
						$.reset(td);
						$.append($$anchor, td);
					});
					var td_1 = $.sibling(node_28);
					var node_30 = $.child(td_1);
					{
						let $0 = $.derived(() => `${axis} ${t("graphics.centre")}`);
						NumberField(node_30, {
							get label() {
								return $.get($0);
							},
							get value() {
								return $.get(framing).centre[$.get(index)];
							},
							minimum: -99999,
							maximum: 99999,
							onvalue: (value) => setCentre($.get(index), value)
						});
					}
					$.reset(td_1);
					$.reset(tr_1);
					$.template_effect(() => $.set_text(text_33, axis));
					$.append($$anchor, tr_1);
				});
				$.reset(tbody);
				$.reset(table);
				var div_8 = $.sibling(table, 2);
				var span_4 = $.child(div_8);
				var text_34 = $.only_child(span_4, true);
				var span_5 = $.sibling(span_4, 2);
				var node_31 = $.child(span_5);
				{
					let $0 = $.derived(() => t("graphics.scale"));
					NumberField(node_31, {
						get label() {
							return $.get($0);
						},
						get value() {
							return $.get(framing).scale;
						},
						get minimum() {
							return LEAST_SCALE;
						},
						get maximum() {
							return GREATEST_SCALE;
						},
						onvalue: setScale
					});
				}
				$.reset(span_5);
				var span_6 = $.sibling(span_5, 2);
				var text_35 = $.only_child(span_6, true);
				$.reset(div_8);
				$.template_effect(($0, $1, $2, $3, $4, $5, $6) => {
					$.set_text(text_28, $0);
					$.set_text(text_29, $1);
					$.set_text(text_30, $2);
					$.set_text(text_31, $3);
					$.set_text(text_32, $4);
					$.set_text(text_34, $5);
					$.set_text(text_35, $6);
				}, [
					() => t("graphics.erases_text"),
					() => t("graphics.range"),
					() => t("graphics.least"),
					() => t("graphics.greatest"),
					() => t("graphics.centre"),
					() => t("graphics.scale"),
					() => t("graphics.scale_text")
				]);
				$.append($$anchor, fragment_16);
			},
			$$slots: {
				actions: true,
				default: true
			}
		});
	}
	$.append($$anchor, fragment);
	$.pop();
}
$.delegate(["input"]);
export { Graphics as default };
