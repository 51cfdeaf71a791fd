import RunView from "../program/RunView.svelte.js";
import "svelte/internal/disclose-version";
import "svelte/internal/client";
// src/pages/position/Running.svelte
function Running($$anchor) {
	RunView($$anchor, { compact: true });
}
export { Running as default };
