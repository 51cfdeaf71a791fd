import { language, t } from "../i18n/index.svelte.js";
import Button from "../parts/Button.svelte.js";
import NumberField from "../parts/NumberField.svelte.js";
import Segmented from "../parts/Segmented.svelte.js";
import { notify } from "../state/notices.svelte.js";
import { machine } from "../state/machine.svelte.js";
import { client } from "./client.js";
import { box, centerOfRadius, distance, isClosed, movedEnd, outline, radiusOf, snap, startOf, svgPath, sweep } from "./geometry.js";
import Profiles from "./Profiles2.svelte.js";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/cycles/ProfileEditor.svelte
var root = $.from_svg(`<circle class="centre s-senpwf"></circle>`);
var root_1 = $.from_svg(`<path class="chosen s-senpwf"></path><!>`, 1);
var root_2 = $.from_svg(`<circle class="touched s-senpwf" tabindex="0" role="button"></circle><circle></circle>`, 1);
var root_3 = $.from_svg(`<path></path><!><!>`, 1);
var root_4 = $.from_svg(`<circle></circle>`);
var root_5 = $.from_html(`<p class="muted number"> </p>`);
var root_6 = $.from_html(`<option> </option>`);
var root_7 = $.from_html(`<div class="row wrap" role="radiogroup"><!> <!></div>`);
var root_8 = $.from_html(`<li><button type="button" class="s-senpwf"><span class="code"></span> <span> </span> <span class="number"> </span></button></li>`);
var root_9 = $.from_html(`<!> <!>`, 1);
var root_10 = $.from_html(`<!> <!> <!>`, 1);
var root_11 = $.from_html(`<!> <!> <!> <!>`, 1);
var root_12 = $.from_html(`<!> <!> <!> <!> <!> <!>`, 1);
var root_13 = $.from_html(`<ol class="elements s-senpwf"><li><button type="button" class="s-senpwf"><span class="code">0</span><span> </span><span class="number"> </span></button></li> <!></ol> <div class="element s-senpwf"><!> <!> <!> <!></div>`, 1);
var root_14 = $.from_html(`<p class="finding s-senpwf"> <small class="code"> </small></p>`);
var root_15 = $.from_html(`<div><div class="row wrap"><!> <!> <!> <!> <!> <input type="file" accept=".dxf" hidden=""/></div> <svg role="group"><path class="axes s-senpwf"></path><!><!></svg> <!> <div class="row wrap snaps s-senpwf"><span class="muted"> </span> <label class="row s-senpwf"><span> </span><select></select></label> <!> <!> <!> <!></div> <!> <!> <!></div>`);
function ProfileEditor($$anchor, $$props) {
	$.push($$props, true);
	let axes = $.prop($$props, "axes", 19, () => ["X", "Y"]), name = $.prop($$props, "name", 3, "");
	/** The letters of abscissa and ordinate. */
	/** What the profile is called in its cycle; empty where it has no name there. */
	/** Other contours are to stand in the place of these, and their name. */
	let current = $.state(0);
	let index = $.state(-1);
	let tool = $.state("choose");
	let hovered = $.state(null);
	/** What is dragged, and by how much the finger is beside it. */
	let dragged = null;
	let dropping = $.state(false);
	let busy = $.state(false);
	let svg = $.state(void 0);
	let files = $.state(void 0);
	const snapping = $.proxy({
		grid: 1,
		ends: true,
		centres: true,
		middles: true,
		aligned: true
	});
	const many = $.derived(() => $$props.use === "contours");
	const contour = $.derived(() => $$props.contours[$.get(current)]);
	const element = $.derived(() => $.get(index) >= 0 ? $.get(contour)?.elements[$.get(index)] : void 0);
	const points = $.derived(() => $$props.contours.flatMap((one) => outline(one)));
	let held = $.state(null);
	const frame = $.derived(() => $.get(held) ?? box($.get(points), .2));
	const unit = $.derived(() => Math.max($.get(frame).w, $.get(frame).h) / 100);
	let width = $.state(0);
	let height = $.state(0);
	/** What a finger meets: 22 px about a point, in units of the drawing. */
	const touch = $.derived(() => $.get(width) > 0 && $.get(height) > 0 ? 22 / Math.min($.get(width) / $.get(frame).w, $.get(height) / $.get(frame).h) : 0);
	function place(event) {
		const matrix = $.get(svg)?.getScreenCTM();
		if (!matrix) return null;
		const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
		const [x, y] = dragged?.aside ?? [0, 0];
		return [at.x - x, -at.y - y];
	}
	/** Where a pointer means: within 14 px of what it may snap to. */
	function meant(event, without) {
		const at = place(event);
		const matrix = $.get(svg)?.getScreenCTM();
		if (!at || !matrix) return null;
		const others = without ? $$props.contours.map((one) => ({
			start: one.start === without ? [NaN, NaN] : one.start,
			elements: one.elements.filter((each) => each.to !== without)
		})) : $$props.contours;
		const last = $.get(contour) ? $.get(contour).elements.at(-1)?.to ?? $.get(contour).start : void 0;
		return snap(at, others, 14 / matrix.a, snapping, $.get(tool) === "choose" ? void 0 : last);
	}
	function press(event) {
		if ($.get(tool) === "choose" || !$.get(contour)) return;
		const to = meant(event)?.at;
		const from = $.get(contour).elements.at(-1)?.to ?? $.get(contour).start;
		if (!to || distance(from, to) < 1e-6) return;
		add($.get(tool), to);
	}
	function add(kind, to) {
		if (!$.get(contour)) return;
		const from = $.get(contour).elements.at(-1)?.to ?? $.get(contour).start;
		const end = to ?? [from[0] + 20, from[1]];
		const middle = [(from[0] + end[0]) / 2, (from[1] + end[1]) / 2];
		$.get(contour).elements.push(kind === "line" ? {
			kind,
			to: end,
			corner: null
		} : {
			kind,
			to: end,
			center: middle,
			clockwise: false,
			corner: null
		});
		$.set(index, $.get(contour).elements.length - 1);
	}
	function moveEnd(at, of, to) {
		const one = $$props.contours[of];
		if (!one) return;
		const closed = isClosed(one);
		const last = one.elements.length - 1;
		if (at < 0) {
			one.start = to;
			if (closed && last >= 0) one.elements[last] = movedEnd(one.elements[last], startOf(one, last), to);
		} else {
			one.elements[at] = movedEnd(one.elements[at], startOf(one, at), to);
			if (closed && at === last) one.start = to;
		}
		const next = at + 1 <= last ? at + 1 : closed && at === last ? 0 : -1;
		if (next >= 0 && next !== at) {
			const following = one.elements[next];
			one.elements[next] = movedEnd(following, startOf(one, next), following.to);
		}
	}
	function move(event) {
		if (dragged) {
			const one = $$props.contours[dragged.contour];
			const to = meant(event, one ? dragged.index < 0 ? one.start : one.elements[dragged.index]?.to : void 0);
			if (to) {
				$.set(hovered, to);
				moveEnd(dragged.index, dragged.contour, to.at);
			}
		} else $.set(hovered, $.get(tool) === "choose" ? null : meant(event));
	}
	/** The points of a contour that can be chosen: its start, and the ends of its elements; the last of a closed one is its
	start. */
	const endsOf = (one) => [one.start, ...one.elements.slice(0, isClosed(one) ? -1 : void 0).map((each) => each.to)];
	/** Takes the point that is nearest to the finger: where points are close, what is met of each lies over others. */
	function grab(event) {
		dragged = null;
		const from = $.get(tool) === "choose" ? place(event) : null;
		if (!from) return;
		let least = Infinity;
		let nearest = null;
		for (const [of, one] of $$props.contours.entries()) for (const [i, point] of endsOf(one).entries()) {
			const far = distance(from, point);
			if (nearest && far >= least - (of === $.get(current) ? -1e-9 : 1e-9)) continue;
			[least, nearest] = [far, point];
			dragged = {
				contour: of,
				index: i - 1,
				aside: [from[0] - point[0], from[1] - point[1]]
			};
		}
		if (!dragged) return;
		event.stopPropagation();
		$.get(svg)?.querySelector(`[data-point="${dragged.contour}.${dragged.index}"]`)?.focus();
		(($$value) => {
			var $$array_1 = $.to_array($$value, 2);
			$.set(current, $$array_1[0], true);
			$.set(index, $$array_1[1], true);
		})([dragged.contour, dragged.index]);
		$.set(held, $.get(frame));
		$.get(svg)?.setPointerCapture(event.pointerId);
	}
	function letGo() {
		dragged = null;
		$.set(held, null);
		$.set(hovered, null);
	}
	function nudge(event, of, at) {
		const step = snapping.grid || 1;
		const by = {
			ArrowLeft: [-step, 0],
			ArrowRight: [step, 0],
			ArrowUp: [0, step],
			ArrowDown: [0, -step]
		};
		const one = $$props.contours[of];
		const place = one && (at < 0 ? one.start : one.elements[at]?.to);
		if (!place) return;
		if (event.key === "Delete") remove(at);
		else if (by[event.key]) moveEnd(at, of, [place[0] + by[event.key][0], place[1] + by[event.key][1]]);
		else return;
		event.preventDefault();
	}
	function remove(at) {
		if (!$.get(contour) || at < 0) return;
		$.get(contour).elements.splice(at, 1);
		const next = $.get(contour).elements[at];
		if (next) $.get(contour).elements[at] = movedEnd(next, startOf($.get(contour), at), next.to);
		$.set(index, Math.min(at, $.get(contour).elements.length - 1), true);
	}
	function close() {
		if ($.get(contour) && !isClosed($.get(contour))) add("line", [...$.get(contour).start]);
	}
	function newContour() {
		const at = $.get(points).length ? [$.get(frame).x + $.get(frame).w / 2, $.get(frame).y + $.get(frame).h / 2] : [0, 0];
		const size = Math.max(1, Math.round(Math.min($.get(frame).w, $.get(frame).h) / 8));
		const start = [Math.round(at[0]) + size, Math.round(at[1])];
		$$props.contours.push({
			start,
			elements: [{
				kind: "arc",
				to: [...start],
				center: [start[0] - size, start[1]],
				clockwise: false,
				corner: null
			}],
			entry: 0,
			exit: 0
		});
		$.set(current, $$props.contours.length - 1);
		$.set(index, 0);
	}
	function setCorner(kind) {
		if (!$.get(element)) return;
		$.get(element).corner = kind === "sharp" ? null : {
			kind,
			size: $.get(element).corner?.size ?? 5
		};
	}
	function take(others, called) {
		(($$value) => {
			var $$array_2 = $.to_array($$value, 2);
			$.set(current, $$array_2[0], true);
			$.set(index, $$array_2[1], true);
		})([0, -1]);
		$$props.onload(others, called);
	}
	async function load(file) {
		if (!file) return;
		$.set(busy, true);
		try {
			const from = await client.drawing(file, language());
			for (const finding of from.findings) notify({
				kind: "warning",
				title: finding.text,
				text: finding.help,
				code: finding.id
			});
			const taken = $.get(many) ? from.contours.filter((one) => one.closed) : from.contours.slice(0, 1);
			if (taken.length > 0) {
				take(taken.map(({ start, elements }) => ({
					start,
					elements,
					entry: 0,
					exit: 0
				})), "");
				notify({
					kind: "done",
					title: t("cycles.drawing_read", { count: taken.length })
				});
			} else if (!from.findings.some((one) => one.severity === "error")) notify({
				kind: "warning",
				title: t("cycles.drawing_without")
			});
		} catch (refused) {
			machine.refused(refused);
		} finally {
			$.set(busy, false);
		}
	}
	function teach() {
		const [x, y] = axes().map((letter) => $$props.here("XYZ".indexOf(letter)));
		if (x !== null && y !== null) moveEnd($.get(index), $.get(current), [x, y]);
	}
	var div = root_15();
	let classes;
	var div_1 = $.child(div);
	var node = $.child(div_1);
	{
		let $0 = $.derived(() => t("cycles.draw"));
		let $1 = $.derived(() => [
			{
				value: "choose",
				label: t("cycles.draw_choose")
			},
			{
				value: "line",
				label: t("cycles.line")
			},
			...$$props.use === "points" ? [] : [{
				value: "arc",
				label: t("cycles.arc")
			}]
		]);
		Segmented(node, {
			get label() {
				return $.get($0);
			},
			get options() {
				return $.get($1);
			},
			get value() {
				return $.get(tool);
			},
			set value($$value) {
				$.set(tool, $$value, true);
			}
		});
	}
	var node_1 = $.sibling(node, 2);
	var consequent = ($$anchor) => {
		{
			let $0 = $.derived(() => !$.get(contour) || $.get(contour).elements.length < 2 || isClosed($.get(contour)));
			Button($$anchor, {
				onclick: close,
				get disabled() {
					return $.get($0);
				},
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text = $.text();
					$.template_effect(($0) => $.set_text(text, $0), [() => t("cycles.close_contour")]);
					$.append($$anchor, text);
				},
				$$slots: { default: true }
			});
		}
	};
	$.if(node_1, ($$render) => {
		if ($$props.use !== "depth") $$render(consequent);
	});
	var node_2 = $.sibling(node_1, 2);
	var consequent_1 = ($$anchor) => {
		Button($$anchor, {
			icon: "plus",
			onclick: newContour,
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_1 = $.text();
				$.template_effect(($0) => $.set_text(text_1, $0), [() => t("cycles.island")]);
				$.append($$anchor, text_1);
			},
			$$slots: { default: true }
		});
	};
	$.if(node_2, ($$render) => {
		if ($.get(many)) $$render(consequent_1);
	});
	var node_3 = $.sibling(node_2, 2);
	Profiles(node_3, {
		get contours() {
			return $$props.contours;
		},
		get use() {
			return $$props.use;
		},
		get name() {
			return name();
		},
		ontake: take
	});
	var node_4 = $.sibling(node_3, 2);
	Button(node_4, {
		icon: "upload",
		get busy() {
			return $.get(busy);
		},
		onclick: () => $.get(files)?.click(),
		children: ($$anchor, $$slotProps) => {
			$.next();
			var text_2 = $.text();
			$.template_effect(($0) => $.set_text(text_2, $0), [() => t("cycles.dxf")]);
			$.append($$anchor, text_2);
		},
		$$slots: { default: true }
	});
	var input = $.sibling(node_4, 2);
	$.bind_this(input, ($$value) => $.set(files, $$value), () => $.get(files));
	$.reset(div_1);
	var svg_1 = $.sibling(div_1, 2);
	let classes_1;
	var path = $.child(svg_1);
	var node_5 = $.sibling(path);
	$.each(node_5, 17, () => $$props.contours, $.index, ($$anchor, one, of) => {
		var fragment_5 = root_3();
		var path_1 = $.first_child(fragment_5);
		let classes_2;
		var node_6 = $.sibling(path_1);
		var consequent_3 = ($$anchor) => {
			const from = $.derived(() => startOf($.get(one), $.get(index)));
			const chosen = $.derived(() => $.get(one).elements[$.get(index)]);
			var fragment_6 = root_1();
			var path_2 = $.first_child(fragment_6);
			var node_7 = $.sibling(path_2);
			var consequent_2 = ($$anchor) => {
				var circle = root();
				$.template_effect(() => {
					$.set_attribute(circle, "cx", $.get(chosen).center[0]);
					$.set_attribute(circle, "cy", -$.get(chosen).center[1]);
					$.set_attribute(circle, "r", $.get(unit) * .9);
				});
				$.append($$anchor, circle);
			};
			$.if(node_7, ($$render) => {
				if ($.get(chosen).kind === "arc") $$render(consequent_2);
			});
			$.template_effect(($0) => $.set_attribute(path_2, "d", $0), [() => svgPath(outline({
				start: $.get(from),
				elements: [{
					...$.get(chosen),
					corner: null
				}]
			}))]);
			$.append($$anchor, fragment_6);
		};
		$.if(node_6, ($$render) => {
			if (of === $.get(current) && $.get(one).elements[$.get(index)]) $$render(consequent_3);
		});
		var node_8 = $.sibling(node_6);
		$.each(node_8, 17, () => endsOf($.get(one)), $.index, ($$anchor, point, i) => {
			var fragment_7 = root_2();
			var circle_1 = $.first_child(fragment_7);
			$.set_attribute(circle_1, "data-point", `${of}.${i - 1}`);
			var circle_2 = $.sibling(circle_1);
			let classes_3;
			$.template_effect(($0, $1) => {
				$.set_attribute(circle_1, "cx", $.get(point)[0]);
				$.set_attribute(circle_1, "cy", -$.get(point)[1]);
				$.set_attribute(circle_1, "r", $0);
				$.set_attribute(circle_1, "aria-label", $1);
				classes_3 = $.set_class(circle_2, 0, "end s-senpwf", null, classes_3, { on: of === $.get(current) && i - 1 === $.get(index) });
				$.set_attribute(circle_2, "cx", $.get(point)[0]);
				$.set_attribute(circle_2, "cy", -$.get(point)[1]);
				$.set_attribute(circle_2, "r", $.get(unit) * 1.6);
			}, [() => Math.max($.get(touch), $.get(unit) * 1.6), () => t("cycles.point", { number: i + 1 })]);
			$.delegated("keydown", circle_1, (event) => nudge(event, of, i - 1));
			$.event("focus", circle_1, () => {
				$.set(current, of, true);
				$.set(index, i - 1);
			});
			$.delegated("mousedown", circle_1, (event) => event.preventDefault());
			$.delegated("pointerdown", circle_1, grab);
			$.append($$anchor, fragment_7);
		});
		$.template_effect(($0) => {
			classes_2 = $.set_class(path_1, 0, "contour s-senpwf", null, classes_2, {
				current: of === $.get(current),
				island: of > 0
			});
			$.set_attribute(path_1, "d", $0);
		}, [() => svgPath(outline($.get(one)))]);
		$.append($$anchor, fragment_5);
	});
	var node_9 = $.sibling(node_5);
	var consequent_4 = ($$anchor) => {
		var circle_3 = root_4();
		$.template_effect(() => {
			$.set_class(circle_3, 0, `snap ${$.get(hovered).kind ?? ""}`, "s-senpwf");
			$.set_attribute(circle_3, "cx", $.get(hovered).at[0]);
			$.set_attribute(circle_3, "cy", -$.get(hovered).at[1]);
			$.set_attribute(circle_3, "r", $.get(unit) * 2.2);
		});
		$.append($$anchor, circle_3);
	};
	$.if(node_9, ($$render) => {
		if ($.get(hovered)) $$render(consequent_4);
	});
	$.reset(svg_1);
	$.bind_this(svg_1, ($$value) => $.set(svg, $$value), () => $.get(svg));
	var node_10 = $.sibling(svg_1, 2);
	var consequent_5 = ($$anchor) => {
		var p = root_5();
		var text_3 = $.only_child(p);
		$.template_effect(($0) => $.set_text(text_3, `${$0 ?? ""}  ${axes()[0] ?? ""} ${$.get(hovered).at[0] ?? ""}  ${axes()[1] ?? ""} ${$.get(hovered).at[1] ?? ""}`), [() => t(`cycles.snap_${$.get(hovered).kind}`)]);
		$.append($$anchor, p);
	};
	$.if(node_10, ($$render) => {
		if ($.get(hovered)) $$render(consequent_5);
	});
	var div_2 = $.sibling(node_10, 2);
	var span = $.child(div_2);
	var text_4 = $.only_child(span, true);
	var label_1 = $.sibling(span, 2);
	var span_1 = $.child(label_1);
	var text_5 = $.only_child(span_1, true);
	var select = $.sibling(span_1);
	$.each(select, 20, () => [
		0,
		.1,
		.5,
		1,
		5,
		10
	], (grid) => grid, ($$anchor, grid) => {
		var option = root_6();
		var text_6 = $.only_child(option, true);
		var option_value = {};
		$.template_effect(() => {
			$.set_text(text_6, grid || "–");
			if (option_value !== (option_value = grid)) option.value = (option.__value = option_value) ?? "";
		});
		$.append($$anchor, option);
	});
	$.reset(select);
	$.init_select(select);
	$.reset(label_1);
	var node_11 = $.sibling(label_1, 2);
	Button(node_11, {
		get pressed() {
			return snapping.ends;
		},
		onclick: () => snapping.ends = !snapping.ends,
		children: ($$anchor, $$slotProps) => {
			$.next();
			var text_7 = $.text();
			$.template_effect(($0) => $.set_text(text_7, $0), [() => t("cycles.snap_end")]);
			$.append($$anchor, text_7);
		},
		$$slots: { default: true }
	});
	var node_12 = $.sibling(node_11, 2);
	Button(node_12, {
		get pressed() {
			return snapping.centres;
		},
		onclick: () => snapping.centres = !snapping.centres,
		children: ($$anchor, $$slotProps) => {
			$.next();
			var text_8 = $.text();
			$.template_effect(($0) => $.set_text(text_8, $0), [() => t("cycles.snap_centre")]);
			$.append($$anchor, text_8);
		},
		$$slots: { default: true }
	});
	var node_13 = $.sibling(node_12, 2);
	Button(node_13, {
		get pressed() {
			return snapping.middles;
		},
		onclick: () => snapping.middles = !snapping.middles,
		children: ($$anchor, $$slotProps) => {
			$.next();
			var text_9 = $.text();
			$.template_effect(($0) => $.set_text(text_9, $0), [() => t("cycles.snap_middle")]);
			$.append($$anchor, text_9);
		},
		$$slots: { default: true }
	});
	var node_14 = $.sibling(node_13, 2);
	Button(node_14, {
		get pressed() {
			return snapping.aligned;
		},
		onclick: () => snapping.aligned = !snapping.aligned,
		children: ($$anchor, $$slotProps) => {
			$.next();
			var text_10 = $.text();
			$.template_effect(($0) => $.set_text(text_10, $0), [() => t("cycles.snap_aligned")]);
			$.append($$anchor, text_10);
		},
		$$slots: { default: true }
	});
	$.reset(div_2);
	var node_15 = $.sibling(div_2, 2);
	var consequent_7 = ($$anchor) => {
		var div_3 = root_7();
		var node_16 = $.child(div_3);
		$.each(node_16, 17, () => $$props.contours, $.index, ($$anchor, one, of) => {
			{
				let $0 = $.derived(() => $.get(current) === of);
				Button($$anchor, {
					role: "radio",
					get pressed() {
						return $.get($0);
					},
					onclick: () => {
						$.set(current, of, true);
						$.set(index, -1);
					},
					children: ($$anchor, $$slotProps) => {
						$.next();
						var text_11 = $.text();
						$.template_effect(($0, $1) => $.set_text(text_11, `${$0 ?? ""}${$1 ?? ""}`), [() => of === 0 ? t("cycles.outer") : t("cycles.island_number", { number: of }), () => isClosed($.get(one)) ? "" : " …"]);
						$.append($$anchor, text_11);
					},
					$$slots: { default: true }
				});
			}
		});
		var node_17 = $.sibling(node_16, 2);
		var consequent_6 = ($$anchor) => {
			{
				let $0 = $.derived(() => t("cycles.delete"));
				Button($$anchor, {
					kind: "quiet",
					icon: "trash",
					get "aria-label"() {
						return $.get($0);
					},
					onclick: () => {
						$$props.contours.splice($.get(current), 1);
						$.set(current, 0);
						$.set(index, -1);
					}
				});
			}
		};
		$.if(node_17, ($$render) => {
			if ($.get(current) > 0) $$render(consequent_6);
		});
		$.reset(div_3);
		$.template_effect(($0) => $.set_attribute(div_3, "aria-label", $0), [() => t("cycles.contours")]);
		$.append($$anchor, div_3);
	};
	$.if(node_15, ($$render) => {
		if ($$props.contours.length > 1) $$render(consequent_7);
	});
	var node_18 = $.sibling(node_15, 2);
	var consequent_14 = ($$anchor) => {
		var fragment_15 = root_13();
		var ol = $.first_child(fragment_15);
		var li = $.child(ol);
		let classes_4;
		var button = $.child(li);
		var span_2 = $.sibling($.child(button));
		var text_12 = $.only_child(span_2, true);
		var span_3 = $.sibling(span_2);
		var text_13 = $.only_child(span_3);
		$.reset(button);
		$.reset(li);
		var node_19 = $.sibling(li, 2);
		$.each(node_19, 17, () => $.get(contour).elements, $.index, ($$anchor, one, i) => {
			var li_1 = root_8();
			let classes_5;
			var button_1 = $.child(li_1);
			var span_4 = $.child(button_1);
			span_4.textContent = i + 1;
			var span_5 = $.sibling(span_4, 2);
			var text_14 = $.only_child(span_5, true);
			var span_6 = $.sibling(span_5, 2);
			var text_15 = $.only_child(span_6);
			$.reset(button_1);
			$.reset(li_1);
			$.template_effect(($0, $1, $2, $3) => {
				classes_5 = $.set_class(li_1, 1, "s-senpwf", null, classes_5, { on: $.get(index) === i });
				$.set_text(text_14, $0);
				$.set_text(text_15, `${axes()[0] ?? ""} ${$1 ?? ""} ${axes()[1] ?? ""} ${$2 ?? ""}${$3 ?? ""}${$.get(one).corner ? ` · ${$.get(one).corner.kind === "round" ? "R" : "C"} ${$.get(one).corner.size}` : ""}`);
			}, [
				() => $.get(one).kind === "line" ? t("cycles.line") : $.get(one).clockwise ? t("cycles.arc_cw") : t("cycles.arc_ccw"),
				() => $.get(one).to[0].toFixed(3),
				() => $.get(one).to[1].toFixed(3),
				() => $.get(one).kind === "arc" ? ` R ${radiusOf($.get(one), startOf($.get(contour), i)).toFixed(3)}` : ""
			]);
			$.delegated("click", button_1, () => $.set(index, i, true));
			$.append($$anchor, li_1);
		});
		$.reset(ol);
		var div_4 = $.sibling(ol, 2);
		var node_20 = $.child(div_4);
		var consequent_9 = ($$anchor) => {
			var fragment_16 = root_10();
			var node_21 = $.first_child(fragment_16);
			{
				let $0 = $.derived(() => t("cycles.start_of", { axis: axes()[0] }));
				NumberField(node_21, {
					get label() {
						return $.get($0);
					},
					get unit() {
						return axes()[0];
					},
					get value() {
						return $.get(contour).start[0];
					},
					onvalue: (value) => moveEnd(-1, $.get(current), [value ?? 0, $.get(contour).start[1]])
				});
			}
			var node_22 = $.sibling(node_21, 2);
			{
				let $0 = $.derived(() => t("cycles.start_of", { axis: axes()[1] }));
				NumberField(node_22, {
					get label() {
						return $.get($0);
					},
					get unit() {
						return axes()[1];
					},
					get value() {
						return $.get(contour).start[1];
					},
					onvalue: (value) => moveEnd(-1, $.get(current), [$.get(contour).start[0], value ?? 0])
				});
			}
			var node_23 = $.sibling(node_22, 2);
			var consequent_8 = ($$anchor) => {
				var fragment_17 = root_9();
				var node_24 = $.first_child(fragment_17);
				{
					let $0 = $.derived(() => t("cycles.entry"));
					let $1 = $.derived(() => t("cycles.entry_short"));
					let $2 = $.derived(() => $.get(contour).entry ?? 0);
					NumberField(node_24, {
						get label() {
							return $.get($0);
						},
						get unit() {
							return $.get($1);
						},
						get value() {
							return $.get($2);
						},
						minimum: 0,
						onvalue: (value) => $.get(contour).entry = value ?? 0
					});
				}
				var node_25 = $.sibling(node_24, 2);
				{
					let $0 = $.derived(() => t("cycles.exit"));
					let $1 = $.derived(() => t("cycles.exit_short"));
					let $2 = $.derived(() => $.get(contour).exit ?? 0);
					NumberField(node_25, {
						get label() {
							return $.get($0);
						},
						get unit() {
							return $.get($1);
						},
						get value() {
							return $.get($2);
						},
						minimum: 0,
						onvalue: (value) => $.get(contour).exit = value ?? 0
					});
				}
				$.append($$anchor, fragment_17);
			};
			$.if(node_23, ($$render) => {
				if ($$props.use === "path") $$render(consequent_8);
			});
			$.append($$anchor, fragment_16);
		};
		var consequent_12 = ($$anchor) => {
			var fragment_18 = root_12();
			var node_26 = $.first_child(fragment_18);
			{
				let $0 = $.derived(() => t("cycles.end_of", { axis: axes()[0] }));
				NumberField(node_26, {
					get label() {
						return $.get($0);
					},
					get unit() {
						return axes()[0];
					},
					get value() {
						return $.get(element).to[0];
					},
					onvalue: (value) => moveEnd($.get(index), $.get(current), [value ?? 0, $.get(element).to[1]])
				});
			}
			var node_27 = $.sibling(node_26, 2);
			{
				let $0 = $.derived(() => t("cycles.end_of", { axis: axes()[1] }));
				NumberField(node_27, {
					get label() {
						return $.get($0);
					},
					get unit() {
						return axes()[1];
					},
					get value() {
						return $.get(element).to[1];
					},
					onvalue: (value) => moveEnd($.get(index), $.get(current), [$.get(element).to[0], value ?? 0])
				});
			}
			var node_28 = $.sibling(node_27, 2);
			var consequent_10 = ($$anchor) => {
				const from = $.derived(() => startOf($.get(contour), $.get(index)));
				var fragment_19 = root_11();
				var node_29 = $.first_child(fragment_19);
				{
					let $0 = $.derived(() => t("cycles.centre_of", { axis: axes()[0] }));
					NumberField(node_29, {
						get label() {
							return $.get($0);
						},
						get unit() {
							return `${axes()[0] ?? ""}c`;
						},
						get value() {
							return $.get(element).center[0];
						},
						onvalue: (value) => $.get(element).center = [value ?? 0, $.get(element).center[1]]
					});
				}
				var node_30 = $.sibling(node_29, 2);
				{
					let $0 = $.derived(() => t("cycles.centre_of", { axis: axes()[1] }));
					NumberField(node_30, {
						get label() {
							return $.get($0);
						},
						get unit() {
							return `${axes()[1] ?? ""}c`;
						},
						get value() {
							return $.get(element).center[1];
						},
						onvalue: (value) => $.get(element).center = [$.get(element).center[0], value ?? 0]
					});
				}
				var node_31 = $.sibling(node_30, 2);
				{
					let $0 = $.derived(() => t("cycles.radius"));
					let $1 = $.derived(() => radiusOf($.get(element), $.get(from)));
					let $2 = $.derived(() => distance($.get(from), $.get(element).to) / 2);
					NumberField(node_31, {
						get label() {
							return $.get($0);
						},
						unit: "R",
						get value() {
							return $.get($1);
						},
						get minimum() {
							return $.get($2);
						},
						onvalue: (value) => $.get(element).center = centerOfRadius($.get(from), $.get(element).to, value ?? 0, $.get(element).center)
					});
				}
				var node_32 = $.sibling(node_31, 2);
				{
					let $0 = $.derived(() => $.get(element).clockwise ? "cw" : "ccw");
					Button(node_32, {
						get icon() {
							return $.get($0);
						},
						onclick: () => $.get(element).clockwise = !$.get(element).clockwise,
						children: ($$anchor, $$slotProps) => {
							$.next();
							var text_16 = $.text();
							$.template_effect(($0) => $.set_text(text_16, `${$0 ?? ""}°`), [() => Math.round(Math.abs(sweep($.get(from), $.get(element).to, $.get(element).center, $.get(element).clockwise)) * 180 / Math.PI)]);
							$.append($$anchor, text_16);
						},
						$$slots: { default: true }
					});
				}
				$.append($$anchor, fragment_19);
			};
			$.if(node_28, ($$render) => {
				if ($.get(element).kind === "arc") $$render(consequent_10);
			});
			var node_33 = $.sibling(node_28, 2);
			{
				let $0 = $.derived(() => $.get(element).corner?.kind ?? "sharp");
				let $1 = $.derived(() => t("cycles.corner"));
				let $2 = $.derived(() => [
					{
						value: "sharp",
						label: t("cycles.sharp")
					},
					{
						value: "round",
						label: t("cycles.round")
					},
					{
						value: "chamfer",
						label: t("cycles.chamfer")
					}
				]);
				Segmented(node_33, {
					get value() {
						return $.get($0);
					},
					get label() {
						return $.get($1);
					},
					onchange: setCorner,
					get options() {
						return $.get($2);
					}
				});
			}
			var node_34 = $.sibling(node_33, 2);
			var consequent_11 = ($$anchor) => {
				{
					let $0 = $.derived(() => t("cycles.corner_size"));
					NumberField($$anchor, {
						get label() {
							return $.get($0);
						},
						get value() {
							return $.get(element).corner.size;
						},
						minimum: 0,
						onvalue: (value) => $.get(element).corner && ($.get(element).corner.size = value ?? 0)
					});
				}
			};
			$.if(node_34, ($$render) => {
				if ($.get(element).corner) $$render(consequent_11);
			});
			var node_35 = $.sibling(node_34, 2);
			Button(node_35, {
				kind: "danger",
				icon: "trash",
				onclick: () => remove($.get(index)),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_17 = $.text();
					$.template_effect(($0) => $.set_text(text_17, $0), [() => t("cycles.delete")]);
					$.append($$anchor, text_17);
				},
				$$slots: { default: true }
			});
			$.append($$anchor, fragment_18);
		};
		$.if(node_20, ($$render) => {
			if ($.get(index) < 0) $$render(consequent_9);
			else if ($.get(element)) $$render(consequent_12, 1);
		});
		var node_36 = $.sibling(node_20, 2);
		{
			let $0 = $.derived(() => machine.link !== "open");
			Button(node_36, {
				icon: "target",
				onclick: teach,
				get disabled() {
					return $.get($0);
				},
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_18 = $.text();
					$.template_effect(($0) => $.set_text(text_18, $0), [() => t("cycles.teach")]);
					$.append($$anchor, text_18);
				},
				$$slots: { default: true }
			});
		}
		var node_37 = $.sibling(node_36, 2);
		Button(node_37, {
			icon: "plus",
			onclick: () => add("line"),
			children: ($$anchor, $$slotProps) => {
				$.next();
				var text_19 = $.text();
				$.template_effect(($0) => $.set_text(text_19, $0), [() => t("cycles.line")]);
				$.append($$anchor, text_19);
			},
			$$slots: { default: true }
		});
		var node_38 = $.sibling(node_37, 2);
		var consequent_13 = ($$anchor) => {
			Button($$anchor, {
				icon: "plus",
				onclick: () => add("arc"),
				children: ($$anchor, $$slotProps) => {
					$.next();
					var text_20 = $.text();
					$.template_effect(($0) => $.set_text(text_20, $0), [() => t("cycles.arc")]);
					$.append($$anchor, text_20);
				},
				$$slots: { default: true }
			});
		};
		$.if(node_38, ($$render) => {
			if ($$props.use !== "points") $$render(consequent_13);
		});
		$.reset(div_4);
		$.template_effect(($0, $1, $2) => {
			classes_4 = $.set_class(li, 1, "s-senpwf", null, classes_4, { on: $.get(index) === -1 });
			$.set_text(text_12, $0);
			$.set_text(text_13, `${axes()[0] ?? ""} ${$1 ?? ""} ${axes()[1] ?? ""} ${$2 ?? ""}`);
		}, [
			() => t("cycles.start_point"),
			() => $.get(contour).start[0].toFixed(3),
			() => $.get(contour).start[1].toFixed(3)
		]);
		$.delegated("click", button, () => $.set(index, -1));
		$.append($$anchor, fragment_15);
	};
	$.if(node_18, ($$render) => {
		if ($.get(contour)) $$render(consequent_14);
	});
	var node_39 = $.sibling(node_18, 2);
	$.each(node_39, 17, () => $$props.findings.filter((one) => one.parameter === "profile"), (finding) => finding.id + finding.text, ($$anchor, finding) => {
		var p_1 = root_14();
		var text_21 = $.child(p_1);
		var small = $.sibling(text_21);
		var text_22 = $.only_child(small, true);
		$.reset(p_1);
		$.template_effect(() => {
			$.set_attribute(p_1, "title", $.get(finding).help);
			$.set_text(text_21, `${$.get(finding).text ?? ""} `);
			$.set_text(text_22, $.get(finding).id);
		});
		$.append($$anchor, p_1);
	});
	$.reset(div);
	$.template_effect(($0, $1) => {
		classes = $.set_class(div, 1, "editor s-senpwf", null, classes, { dropping: $.get(dropping) });
		$.set_attribute(svg_1, "viewBox", `${$.get(frame).x ?? ""} ${-$.get(frame).y - $.get(frame).h} ${$.get(frame).w ?? ""} ${$.get(frame).h ?? ""}`);
		$.set_attribute(svg_1, "aria-label", $$props.label);
		classes_1 = $.set_class(svg_1, 0, "s-senpwf", null, classes_1, { drawing: $.get(tool) !== "choose" });
		$.set_attribute(path, "d", `M${$.get(frame).x ?? ""} 0H${$.get(frame).x + $.get(frame).w}M0 ${-$.get(frame).y - $.get(frame).h}V${-$.get(frame).y}`);
		$.set_text(text_4, $0);
		$.set_text(text_5, $1);
	}, [() => t("cycles.snapping"), () => t("cycles.grid")]);
	$.event("dragover", div, (event) => {
		event.preventDefault();
		$.set(dropping, true);
	});
	$.event("dragleave", div, () => $.set(dropping, false));
	$.event("drop", div, (event) => {
		event.preventDefault();
		$.set(dropping, false);
		load(event.dataTransfer?.files[0]);
	});
	$.delegated("change", input, (event) => {
		load(event.currentTarget.files?.[0]);
		event.currentTarget.value = "";
	});
	$.delegated("pointerdown", svg_1, press);
	$.delegated("pointermove", svg_1, move);
	$.delegated("pointerup", svg_1, letGo);
	$.event("pointercancel", svg_1, letGo);
	$.event("pointerleave", svg_1, () => !dragged && $.set(hovered, null));
	$.bind_element_size(svg_1, "clientWidth", ($$value) => $.set(width, $$value));
	$.bind_element_size(svg_1, "clientHeight", ($$value) => $.set(height, $$value));
	$.bind_select_value(select, () => snapping.grid, ($$value) => snapping.grid = $$value);
	$.append($$anchor, div);
	$.pop();
}
$.delegate([
	"change",
	"pointerdown",
	"pointermove",
	"pointerup",
	"keydown",
	"mousedown",
	"click"
]);
export { ProfileEditor as default };
