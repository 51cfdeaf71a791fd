import { http } from "../api/http.js";
import { language } from "../i18n/index.svelte.js";
import { completions } from "./completions.js";
import { linter, setDiagnostics } from "@codemirror/lint";
import { hoverTooltip } from "@codemirror/view";
import { autocompletion } from "@codemirror/autocomplete";
// src/lib/editor/language.ts
/** Characters: programs longer than this are checked when they are saved, not as they are typed. */
var LARGEST_CHECKED = 4e5;
/** Offsets of a finding; places outside the text are brought to its end. */
function place(doc, finding) {
	const offset = (line, column) => {
		const at = doc.line(Math.max(1, Math.min(line, doc.lines)));
		return Math.min(at.from + Math.max(0, column - 1), at.to);
	};
	const from = offset(finding.line, finding.column);
	const to = offset(finding.end_line || finding.line, finding.end_column);
	if (to > from) return {
		from,
		to
	};
	const line = doc.lineAt(from);
	return {
		from: line.from,
		to: Math.max(line.to, line.from)
	};
}
/** Findings as the editor marks them. */
function marks(doc, findings) {
	return findings.slice(0, 500).map((finding) => ({
		...place(doc, finding),
		severity: finding.severity,
		source: finding.id,
		message: finding.help ? `${finding.text}\n${finding.help}` : finding.text
	}));
}
/** Checks what stands there now, however long it is, and marks what is wrong. Findings of a text that was changed
meanwhile are marked nowhere. */
async function checkNow(view, dialect) {
	const { doc } = view.state;
	const { findings } = await http.check(doc.toString(), dialect, language());
	if (view.state.doc.eq(doc)) view.dispatch(setDiagnostics(view.state, marks(doc, findings)));
	return findings;
}
function checked(dialect, found) {
	let running;
	return linter(async (view) => {
		running?.abort();
		running = new AbortController();
		if (view.state.doc.length > 4e5) return [];
		const { findings } = await http.check(view.state.doc.toString(), dialect(), language(), running.signal);
		found(findings);
		return marks(view.state.doc, findings);
	}, { delay: 300 });
}
function complete(dialect) {
	return async (context) => {
		const typed = context.matchBefore(/[A-Za-z]+\d*\.?\d*/);
		if (!context.explicit && (!typed || typed.text.length < 2 && !/[GM]/i.test(typed.text))) return null;
		const words = await http.words(dialect(), language()).catch(() => []);
		const options = completions(words, typed?.text ?? "").map(({ word: label, title }) => ({
			label,
			detail: title,
			type: "keyword"
		}));
		return {
			from: typed?.from ?? context.pos,
			options,
			filter: false
		};
	};
}
function explained(dialect) {
	return hoverTooltip(async (view, at) => {
		const line = view.state.doc.lineAt(at);
		if (line.length > 2e3) return null;
		for (const match of line.text.matchAll(/#?[A-Za-z]\s?\d+(\.\d+)?|#\d+/g)) {
			const from = line.from + match.index;
			const to = from + match[0].length;
			if (at < from || at > to) continue;
			const word = match[0].replace(/\s/g, "").toUpperCase();
			const about = await http.explain(word, dialect(), language()).catch(() => null);
			if (!about?.found) return null;
			return {
				pos: from,
				end: to,
				create: () => {
					const dom = document.createElement("div");
					dom.className = "nc-hover";
					const title = document.createElement("strong");
					title.textContent = `${word} · ${about.title}`;
					const text = document.createElement("div");
					text.textContent = about.text;
					const source = document.createElement("small");
					source.textContent = about.source;
					source.className = "muted";
					dom.append(title, text, source);
					return { dom };
				}
			};
		}
		return null;
	});
}
/** Completion, explanations and checks of a control language. */
function controlLanguage(dialect, found) {
	return [
		autocompletion({
			override: [complete(dialect)],
			icons: false,
			selectOnOpen: false
		}),
		explained(dialect),
		checked(dialect, found)
	];
}
export { LARGEST_CHECKED, checkNow, controlLanguage, place };
