import * as $ from "svelte/internal/client";
// src/lib/state/notices.svelte.ts
var list = $.state([]);
var next = 1;
function notify(notice) {
	const id = next++;
	$.set(list, [...$.get(list).filter((one) => one.title !== notice.title), {
		...notice,
		id
	}].slice(-4));
	setTimeout(() => dismiss(id), notice.kind === "warning" ? 9e3 : 4e3);
}
function dismiss(id) {
	$.set(list, $.get(list).filter((notice) => notice.id !== id));
}
var notices = { get list() {
	return $.get(list);
} };
export { dismiss, notices, notify };
