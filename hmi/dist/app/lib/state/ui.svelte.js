import * as $ from "svelte/internal/client";
// src/lib/state/ui.svelte.ts
var ui = $.proxy({
	keyMap: false,
	logIn: false
});
export { ui };
