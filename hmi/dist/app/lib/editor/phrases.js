import { t } from "../i18n/index.svelte.js";
import { EditorState } from "@codemirror/state";
// src/lib/editor/phrases.ts
var phrases = () => EditorState.phrases.of({
	Find: t("editor.find"),
	Replace: t("editor.replace"),
	next: t("editor.next"),
	previous: t("editor.previous"),
	all: t("editor.all"),
	"match case": t("editor.case"),
	regexp: t("editor.expression"),
	"by word": t("editor.word"),
	replace: t("editor.replace_this"),
	"replace all": t("editor.replace_all"),
	close: t("editor.close"),
	"current match": t("editor.match"),
	"on line": t("editor.on_line"),
	"replaced $ matches": t("editor.replaced"),
	"replaced match on line $": t("editor.replaced_on_line"),
	"Go to line": t("editor.line"),
	go: t("editor.go"),
	Diagnostics: t("editor.findings"),
	"No diagnostics": t("editor.no_findings"),
	Completions: t("editor.completions"),
	"Selection deleted": t("editor.deleted")
});
export { phrases };
