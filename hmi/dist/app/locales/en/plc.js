// src/locales/en/plc.json
var plc_default = {
	"title": "PLC",
	"monitor": "Ladder",
	"edit": "Change",
	"trace": "Trace",
	"none": "This machine has no ladder",
	"none_text": "Start the machine with one: --ladder FILE.",
	"nothing": "No rung fits",
	"rung": "Rung at line {line}",
	"force_on": "Force on",
	"force_off": "Force off",
	"force_release": "Release",
	"facts": "{rungs} rungs, {instructions} instructions",
	"roll_back": "Put the one before back",
	"start": "Start",
	"exchange": "Exchange",
	"exchange_text": "The ladder is exchanged between two scans while the machine runs. Signals, timers and counters stay as they are.",
	"exchanged": "The ladder is exchanged",
	"signals": "Names of signals, up to 32",
	"record": "Record",
	"stop": "Stop",
	"trace_text": "Sampled by the control at each scan of the ladder; what does not change is not kept.",
	"at_signal": "On a signal",
	"changes": "Changes",
	"trigger": "Signal of the trigger",
	"waits": "Waits for the signal …"
};
export { plc_default as default };
