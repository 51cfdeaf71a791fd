// src/locales/en/help.json
var help_default = {
	"title": "Help",
	"search": "Search",
	"codes": "Codes",
	"calculator": "Calculator",
	"placeholder": "Codes, parameters, alarms, variables, signals, addresses",
	"nothing": "Nothing was found",
	"empty": "Look something up",
	"empty_text": "Type a code such as G84, a number of an alarm or parameter, or a word.",
	"kind_code": "Code",
	"kind_parameter": "Parameter",
	"kind_alarm": "Alarm",
	"kind_variable": "Variable",
	"kind_signal": "Signal",
	"kind_address": "Address",
	"choose": "Choose a code on the left.",
	"sum": "Sum",
	"operations": "Operations",
	"parameters": "Parameters",
	"alarms": "Alarms",
	"variables": "Variables",
	"addresses": "Addresses",
	"choose_row": "Choose a row on the left.",
	"not_here": "Pages of the GSK990MC that this machine has no use for"
};
export { help_default as default };
