// src/locales/en/alarms.json
var alarms_default = {
	"title": "Alarms",
	"active": "Active",
	"history": "History",
	"log": "Operation log",
	"none": "No alarm stands",
	"none_text": "The machine is well. Past alarms are in the history.",
	"remedy": "What to do:",
	"to_program": "To the program",
	"time": "Time",
	"number": "Number",
	"text": "Alarm",
	"program": "Program",
	"who": "Who",
	"what": "What",
	"change": "From what to what",
	"clear": "Empty",
	"clear_right": "Needs level 3",
	"none_past": "No alarm yet",
	"none_past_text": "What raises an alarm stands here with its time, program and remedy.",
	"entries_one": "{n} entry",
	"entries_other": "{n} entries",
	"older": "Older ones"
};
export { alarms_default as default };
