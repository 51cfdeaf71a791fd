import { EditorView } from "@codemirror/view";
// src/lib/editor/theme.ts
/** The editor in the colours of the panel. */
var theme = EditorView.theme({
	"&": {
		height: "100%",
		backgroundColor: "var(--sunken)",
		color: "var(--text)",
		fontSize: "1rem"
	},
	"&.cm-focused": { outline: "none" },
	".cm-scroller": {
		fontFamily: "var(--mono)",
		lineHeight: "1.55",
		contain: "strict"
	},
	".cm-content": { caretColor: "var(--accent)" },
	".cm-gutters": {
		backgroundColor: "var(--surface)",
		color: "var(--faint)",
		border: "none"
	},
	".cm-activeLineGutter": {
		backgroundColor: "var(--raised)",
		color: "var(--text)"
	},
	".cm-activeLine": { backgroundColor: "color-mix(in srgb, var(--raised) 60%, transparent)" },
	".cm-content ::selection, .cm-content::selection": { backgroundColor: "var(--accent-soft)" },
	".cm-panels": {
		backgroundColor: "var(--surface)",
		color: "var(--text)",
		borderColor: "var(--line)"
	},
	".cm-panel.cm-search": {
		padding: "0.5rem",
		display: "flex",
		flexWrap: "wrap",
		gap: "0.3rem",
		alignItems: "center"
	},
	".cm-panel.cm-search br": { display: "none" },
	".cm-panel .cm-textfield": {
		minHeight: "44px",
		fontSize: "1rem",
		background: "var(--sunken)",
		border: "1px solid var(--line)",
		color: "var(--text)"
	},
	".cm-panel .cm-button": {
		minWidth: "44px",
		minHeight: "44px",
		fontSize: "0.9rem",
		background: "var(--raised)",
		border: "1px solid var(--line)",
		borderRadius: "var(--radius)",
		color: "var(--text)"
	},
	".cm-panel label": {
		display: "inline-flex",
		alignItems: "center",
		gap: "0.4rem",
		minHeight: "44px",
		fontSize: "0.9rem"
	},
	".cm-panel.cm-search [name=close], .cm-dialog-close": {
		position: "static",
		minWidth: "44px",
		minHeight: "44px",
		fontSize: "1.2rem"
	},
	".cm-panel.cm-dialog": {
		display: "flex",
		alignItems: "center",
		gap: "0.5rem",
		padding: "0.5rem"
	},
	".cm-tooltip": {
		backgroundColor: "var(--raised)",
		border: "1px solid var(--line-strong)",
		borderRadius: "var(--radius)",
		boxShadow: "var(--shadow)",
		maxWidth: "34rem"
	},
	".cm-tooltip-autocomplete ul li": {
		minHeight: "44px",
		padding: "0.6rem !important"
	},
	".cm-tooltip-autocomplete ul li[aria-selected]": {
		background: "var(--accent-soft) !important",
		color: "var(--text) !important"
	},
	".cm-diagnostic": {
		padding: "0.5rem 0.8rem",
		fontFamily: "var(--sans)"
	},
	".cm-searchMatch": { backgroundColor: "var(--hold-soft)" },
	".nc-active": {
		backgroundColor: "var(--run-soft)",
		boxShadow: "inset 3px 0 var(--run)"
	},
	".nc-cursor": {
		backgroundColor: "var(--accent-soft)",
		boxShadow: "inset 3px 0 var(--accent)"
	},
	".nc-comment": { color: "var(--faint)" },
	".nc-g": {
		color: "var(--accent)",
		fontWeight: "600"
	},
	".nc-m": {
		color: "var(--hold)",
		fontWeight: "600"
	},
	".nc-n": { color: "var(--faint)" },
	".nc-word": { color: "var(--run)" },
	".nc-macro": { color: "#c58af9" },
	".nc-hover": {
		padding: "0.6rem 0.9rem",
		fontFamily: "var(--sans)",
		maxWidth: "30rem"
	}
});
export { theme };
