import { machine } from "../state/machine.svelte.js";
import { untrack } from "svelte";
// src/lib/digits/sheets.ts
var thread = null;
/** The thread has failed: of what is shown from then on nothing is drawn either. */
var isBroken = false;
/** Whether numbers can be drawn: this browser has what sheets need, and the thread has not failed. */
var canDraw = () => !isBroken && "transferControlToOffscreen" in HTMLCanvasElement.prototype;
var next = 1;
var sheets = /* @__PURE__ */ new Map();
var latest = null;
var tell = (told, moved = []) => thread?.postMessage(told, moved);
var isSame = (one, other) => one.length === other.length && one.every((shown, index) => shown.text === other[index].text && shown.tone === other[index].tone);
/** Says what has changed, of all sheets in one message. */
function show(status) {
	latest = status;
	const changed = [];
	for (const [number, sheet] of sheets) {
		const shown = sheet.numbers(status);
		if (isSame(shown, sheet.last)) continue;
		sheet.last = shown;
		changed.push([number, shown]);
	}
	if (changed.length) tell({
		do: "show",
		numbers: changed
	});
}
function open() {
	if (thread) return;
	thread = new Worker(new URL(
		/* @vite-ignore */
		"/app/lib/digits/worker.js",
		"" + import.meta.url
	), { type: "module" });
	thread.onerror = () => {
		isBroken = true;
		for (const { failed } of [...sheets.values()]) failed();
	};
	machine.watch(show);
}
/** An attachment: a canvas becomes a sheet of numbers. `failed` is called where they cannot be drawn any more. */
function sheet(contents, failed) {
	return (canvas) => {
		if (isBroken) {
			failed();
			return () => {};
		}
		open();
		const number = next++;
		const mine = {
			...contents,
			last: [],
			failed
		};
		const drawn = canvas.transferControlToOffscreen();
		tell({
			do: "new",
			sheet: number,
			canvas: drawn
		}, [drawn]);
		sheets.set(number, mine);
		const look = () => {
			const { left, top, right, bottom } = canvas.getBoundingClientRect();
			const scale = devicePixelRatio;
			const width = Math.round(right * scale) - Math.round(left * scale);
			const height = Math.round(bottom * scale) - Math.round(top * scale);
			if (!width || !height) return;
			tell({
				do: "look",
				sheet: number,
				width,
				height,
				places: contents.places(getComputedStyle(canvas), width, height, scale)
			});
		};
		const sizes = new ResizeObserver(look);
		sizes.observe(canvas);
		const themes = new MutationObserver(look);
		themes.observe(document.documentElement, { attributeFilter: ["data-theme"] });
		untrack(() => latest && show(latest));
		return () => {
			sizes.disconnect();
			themes.disconnect();
			sheets.delete(number);
			tell({
				do: "drop",
				sheet: number
			});
		};
	};
}
export { canDraw, sheet };
