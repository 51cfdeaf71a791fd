import * as $ from "svelte/internal/client";
// src/lib/routing.svelte.ts
function parse(hash) {
	return hash.replace(/^#\/?/, "").split("/").filter(Boolean).map((part) => {
		try {
			return decodeURIComponent(part);
		} catch {
			return part;
		}
	});
}
var parts = $.state(parse(location.hash));
addEventListener("hashchange", () => {
	$.set(parts, parse(location.hash));
});
var route = {
	/** The page. */
	get page() {
		return $.get(parts)[0] ?? "position";
	},
	/** Its part, such as a tab. */
	get tab() {
		return $.get(parts)[1] ?? "";
	},
	/** What it is about, such as a program. */
	get item() {
		return $.get(parts)[2] ?? "";
	}
};
/** The address of a page, for links. */
function href(...to) {
	return `#/${to.map(encodeURIComponent).join("/")}`;
}
/** Goes to a page. */
function go(...to) {
	location.hash = href(...to);
}
export { go, href, route };
