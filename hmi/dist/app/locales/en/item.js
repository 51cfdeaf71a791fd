// src/locales/en/item.json
var item_default = {
	"programs": "Programs",
	"parameters": "Parameters",
	"offsets": "Tool offsets",
	"zeros": "Work zeros",
	"reference-points": "Reference points",
	"variables": "Macro variables",
	"pitch": "Pitch error",
	"plc": "Data of the PLC",
	"counters": "Counters",
	"alarms": "Alarm history",
	"log": "Operation log",
	"position": "Position",
	"ladder": "Ladder",
	"interrupted": "Broken-off run",
	"rights": "Rights",
	"memory": "Memory"
};
export { item_default as default };
