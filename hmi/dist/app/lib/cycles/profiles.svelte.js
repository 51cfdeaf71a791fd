import { isClosed } from "./geometry.js";
import * as $ from "svelte/internal/client";
// src/lib/cycles/profiles.svelte.ts
var KEY = "ferrocut.profiles";
function read() {
	try {
		const kept = JSON.parse(localStorage.getItem(KEY) ?? "{}");
		return Object.fromEntries(Object.entries(kept).filter(([name, one]) => isName(name) && Array.isArray(one?.contours)));
	} catch {
		return {};
	}
}
/** A name that stands in a block as it is. */
var isName = (name) => /^[A-Za-z][A-Za-z0-9_]{0,31}$/.test(name);
/** Whether contours may be a profile of a use. */
function fits(contours, isDepth, use) {
	if (isDepth !== (use === "depth")) return false;
	if (use === "contours") return contours.every(isClosed);
	const [one] = contours;
	if (contours.length !== 1 || !one) return false;
	if (use === "depth") return !isClosed(one);
	return use === "path" || one.elements.length < 25 && one.elements.every((element) => element.kind === "line");
}
var all = $.proxy(read());
/** Whether it is kept beyond this page; a browser may have no room. */
function write() {
	try {
		localStorage.setItem(KEY, JSON.stringify(all));
		return true;
	} catch {
		return false;
	}
}
var profiles = {
	/** Those that may stand in the place of a profile, by their names. */
	of(use) {
		return Object.entries(all).filter(([, { contours, isDepth }]) => fits(contours, isDepth, use)).sort(([a], [b]) => a.localeCompare(b));
	},
	has(name) {
		return Object.hasOwn(all, name);
	},
	keep(name, contours, isDepth) {
		Object.assign(all, read());
		all[name] = {
			isDepth,
			contours: $.snapshot(contours)
		};
		return write();
	},
	/** A copy of its own; ways in and out are those of a path. */
	get(name, use) {
		const contours = structuredClone($.snapshot(all[name]?.contours ?? []));
		return use === "path" ? contours : contours.map((one) => ({
			...one,
			entry: 0,
			exit: 0
		}));
	},
	remove(name) {
		Object.assign(all, read());
		delete all[name];
		write();
	}
};
export { fits, isName, profiles };
