import { t } from "../i18n/index.svelte.js";
import { go } from "../routing.svelte.js";
import { editing } from "../state/editing.svelte.js";
import { machine } from "../state/machine.svelte.js";
import { notify } from "../state/notices.svelte.js";
// src/lib/cycles/insert.ts
/** Hands a cycle to the editor, which shows where it stands; nothing is stored until it is saved there. */
function insert(text) {
	const { opened } = editing;
	if (opened) {
		editing.put(opened.program, text, opened.lines);
		go("program", "edit", opened.program);
		return;
	}
	const program = editing.program ?? machine.status?.program.selected;
	if (!program) {
		notify({
			kind: "warning",
			title: t("cycles.no_program"),
			text: t("cycles.no_program_text")
		});
		return;
	}
	editing.put(program, text);
	go("program", "edit", program);
}
export { insert };
