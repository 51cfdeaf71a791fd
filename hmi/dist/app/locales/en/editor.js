// src/locales/en/editor.json
var editor_default = {
	"find": "Find",
	"replace": "Replace with",
	"next": "Next",
	"previous": "Previous",
	"all": "All",
	"case": "Match case",
	"expression": "Expression",
	"word": "Whole words",
	"replace_this": "Replace",
	"replace_all": "Replace all",
	"close": "Close",
	"match": "Match",
	"on_line": "on line",
	"replaced": "$ replaced",
	"replaced_on_line": "Replaced on line $",
	"line": "Go to line",
	"go": "Go",
	"findings": "Findings",
	"no_findings": "Nothing found",
	"completions": "Codes",
	"deleted": "Deleted"
};
export { editor_default as default };
