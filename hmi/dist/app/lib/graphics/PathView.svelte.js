import { prefs } from "../state/prefs.svelte.js";
import { PathScene } from "./scene.js";
import { untrack } from "svelte";
import "svelte/internal/disclose-version";
import * as $ from "svelte/internal/client";
// src/lib/graphics/PathView.svelte
var root = $.from_html(`<div class="view s-1y1wt0i"><canvas class="s-1y1wt0i"></canvas> <canvas class="above s-1y1wt0i" tabindex="0" data-testid="path"></canvas></div>`);
function PathView($$anchor, $$props) {
	$.push($$props, true);
	let done = $.prop($$props, "done", 19, () => -1), rapids = $.prop($$props, "rapids", 3, true), section = $.prop($$props, "section", 3, null), range = $.prop($$props, "range", 3, null), frame = $.prop($$props, "frame", 3, null), marks = $.prop($$props, "marks", 19, () => []);
	/** Points up to this one are done. */
	/** Heights between which the path is shown. */
	/** What is looked at in place of the whole path. */
	/** The scale and the centre, where they are set. */
	/** Points that are measured. */
	/** Where the tool is; asked for each frame of the layer above. */
	let below = $.state(void 0);
	let above = $.state(void 0);
	let scene = $.state(null);
	let failed = $.state(false);
	const fingers = /* @__PURE__ */ new Map();
	let travelled = 0;
	const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
	$.user_effect(() => {
		if (!$.get(below) || !$.get(above)) return;
		let made;
		try {
			made = new PathScene($.get(below));
		} catch {
			$.set(failed, true);
			return;
		}
		const canvas = $.get(below);
		made.onview = () => untrack(overlay);
		$.set(scene, made);
		const sized = new ResizeObserver(() => {
			const ratio = Math.min(devicePixelRatio, 2);
			made.size(canvas.clientWidth, canvas.clientHeight, ratio);
			$.get(above).width = canvas.clientWidth * ratio;
			$.get(above).height = canvas.clientHeight * ratio;
			last = "";
			overlay();
		});
		sized.observe(canvas);
		return () => {
			sized.disconnect();
			made.dispose();
			$.set(scene, null);
		};
	});
	$.user_effect(() => {
		prefs.theme;
		$.get(scene)?.shades({
			done: colour("--run"),
			cut: colour("--accent"),
			arc: colour("--accent"),
			rapid: colour("--hold"),
			grid: colour("--line"),
			trail: colour("--muted")
		});
	});
	$.user_effect(() => {
		const [to, now] = [$.get(scene), $$props.path];
		untrack(() => to?.load(now));
	});
	$.user_effect(() => {
		const [to, box, set] = [
			$.get(scene),
			range(),
			frame()
		];
		untrack(() => to?.range(box, set));
	});
	$.user_effect(() => {
		const [to, now] = [$.get(scene), done()];
		untrack(() => to?.done(now));
	});
	$.user_effect(() => {
		const [to, now] = [$.get(scene), rapids()];
		untrack(() => to?.rapids(now));
	});
	$.user_effect(() => {
		const [to, now] = [$.get(scene), section()];
		untrack(() => to?.section(now?.[0] ?? -1e9, now?.[1] ?? 1e9));
	});
	$.user_effect(() => {
		marks();
		untrack(overlay);
	});
	let last = "";
	/** Draws the layer above: tool, marks, directions of the axes. Nothing is done where nothing has changed. */
	function overlay() {
		const context = $.get(above)?.getContext("2d");
		if (!context || !$.get(above) || !$.get(scene)) return;
		const at = $$props.tool?.() ?? null;
		const key = `${at?.x},${at?.y},${at?.z},${$.get(scene).yaw},${$.get(scene).pitch},${$.get(scene).turned},${$.get(scene).span},${$.get(scene).target.toArray()},${marks().length},${$.get(above).width},${marks().map((mark) => mark.x)}`;
		if (key === last) return;
		last = key;
		const ratio = $.get(above).width / Math.max(1, $.get(above).clientWidth);
		context.setTransform(ratio, 0, 0, ratio, 0, 0);
		context.clearRect(0, 0, $.get(above).clientWidth, $.get(above).clientHeight);
		context.lineWidth = 2;
		context.font = "600 13px system-ui";
		const origin = [44, $.get(above).clientHeight - 44];
		const zero = $.get(scene).project(0, 0, 0);
		for (const [name, vector, shade] of [
			[
				"X",
				[
					1,
					0,
					0
				],
				"--alarm"
			],
			[
				"Y",
				[
					0,
					1,
					0
				],
				"--run"
			],
			[
				"Z",
				[
					0,
					0,
					1
				],
				"--accent"
			]
		]) {
			const far = $.get(scene).project(...vector.map((one) => one * $.get(scene).span));
			const scale = 30 / Math.min($.get(above).clientWidth, $.get(above).clientHeight);
			const end = [origin[0] + (far[0] - zero[0]) * scale, origin[1] + (far[1] - zero[1]) * scale];
			context.strokeStyle = context.fillStyle = colour(shade);
			context.beginPath();
			context.moveTo(...origin);
			context.lineTo(...end);
			context.stroke();
			context.fillText(name, end[0] + 4, end[1] + 4);
		}
		context.strokeStyle = context.fillStyle = colour("--hold");
		marks().forEach((mark, index) => {
			const [x, y] = $.get(scene).project(mark.x, mark.y, mark.z);
			context.beginPath();
			context.arc(x, y, 5, 0, 7);
			context.stroke();
			const before = marks()[index - 1];
			if (before) {
				context.setLineDash([5, 4]);
				context.beginPath();
				context.moveTo(...$.get(scene).project(before.x, before.y, before.z));
				context.lineTo(x, y);
				context.stroke();
				context.setLineDash([]);
			}
		});
		if (at) {
			const [x, y] = $.get(scene).project(at.x, at.y, at.z);
			const [tx, ty] = $.get(scene).project(at.x, at.y, at.z + $.get(scene).span * .09);
			context.strokeStyle = colour("--text");
			context.fillStyle = colour("--hold");
			context.lineWidth = 7;
			context.lineCap = "round";
			context.globalAlpha = .75;
			context.beginPath();
			context.moveTo(x + (tx - x) * .25, y + (ty - y) * .25);
			context.lineTo(tx, ty);
			context.stroke();
			context.globalAlpha = 1;
			context.lineWidth = 2;
			context.beginPath();
			context.moveTo(x, y);
			context.lineTo(x + (tx - x) * .25, y + (ty - y) * .25);
			context.stroke();
			context.beginPath();
			context.arc(x, y, 4.5, 0, 7);
			context.fill();
		}
	}
	/** The trail of the tool has grown, or was erased. */
	function grown(trail) {
		$.get(scene)?.trail(trail);
	}
	function look(view) {
		$.get(scene)?.look(view);
	}
	function fit() {
		$.get(scene)?.fit();
	}
	/** mm of the screen that the shorter side of the drawing has. */
	function across() {
		return $.get(scene)?.across ?? 0;
	}
	function pointerdown(event) {
		$.get(above).setPointerCapture(event.pointerId);
		fingers.set(event.pointerId, {
			x: event.offsetX,
			y: event.offsetY
		});
		travelled = 0;
	}
	function pointermove(event) {
		const was = fingers.get(event.pointerId);
		if (!was || !$.get(scene)) return;
		const now = {
			x: event.offsetX,
			y: event.offsetY
		};
		const by = {
			x: now.x - was.x,
			y: now.y - was.y
		};
		travelled += Math.abs(by.x) + Math.abs(by.y);
		const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
		if (other) {
			const before = Math.hypot(was.x - other.x, was.y - other.y);
			const after = Math.hypot(now.x - other.x, now.y - other.y);
			if (after > 1) $.get(scene).zoom(before / after);
			$.get(scene).shift(by.x / 2, by.y / 2);
		} else if (event.buttons === 2 || event.buttons === 4 || event.shiftKey) $.get(scene).shift(by.x, by.y);
		else $.get(scene).turn(-by.x * .008, by.y * .008);
		fingers.set(event.pointerId, now);
	}
	function pointerup(event) {
		if (fingers.delete(event.pointerId) && travelled < 5 && $$props.onpick && $.get(scene)) {
			const index = $.get(scene).pick(event.offsetX, event.offsetY);
			if (index !== null) $$props.onpick(index);
		}
	}
	function keydown(event) {
		const by = {
			ArrowLeft: [-.1, 0],
			ArrowRight: [.1, 0],
			ArrowUp: [0, .1],
			ArrowDown: [0, -.1]
		}[event.key];
		if (event.ctrlKey || event.altKey) return;
		if (by) $.get(scene)?.turn(...by);
		else if (event.key === "+") $.get(scene)?.zoom(.85);
		else if (event.key === "-") $.get(scene)?.zoom(1.18);
		else if (event.key === "0") $.get(scene)?.fit();
		else return;
		event.preventDefault();
	}
	var $$exports = {
		overlay,
		grown,
		look,
		fit,
		across
	};
	var div = root();
	var canvas_1 = $.child(div);
	$.bind_this(canvas_1, ($$value) => $.set(below, $$value), () => $.get(below));
	var canvas_2 = $.sibling(canvas_1, 2);
	$.bind_this(canvas_2, ($$value) => $.set(above, $$value), () => $.get(above));
	$.reset(div);
	$.template_effect(() => {
		$.set_attribute(div, "data-failed", $.get(failed));
		$.set_attribute(canvas_2, "aria-label", $$props.label);
	});
	$.delegated("pointerdown", canvas_2, pointerdown);
	$.delegated("pointermove", canvas_2, pointermove);
	$.delegated("pointerup", canvas_2, pointerup);
	$.event("pointercancel", canvas_2, (event) => fingers.delete(event.pointerId));
	$.delegated("contextmenu", canvas_2, (event) => event.preventDefault());
	$.event("wheel", canvas_2, (event) => {
		event.preventDefault();
		$.get(scene)?.zoom(Math.exp(event.deltaY * .0012));
	});
	$.delegated("keydown", canvas_2, keydown);
	$.append($$anchor, div);
	return $.pop($$exports);
}
$.delegate([
	"pointerdown",
	"pointermove",
	"pointerup",
	"contextmenu",
	"keydown"
]);
export { PathView as default };
