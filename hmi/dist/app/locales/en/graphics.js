// src/locales/en/graphics.json
var graphics_default = {
	"title": "Graphics",
	"none": "No program is selected",
	"none_text": "The path of the program that is selected is drawn here.",
	"iso": "XYZ",
	"top": "XY",
	"front": "XZ",
	"side": "YZ",
	"fit": "Show all",
	"rapids": "Rapids",
	"section": "Section",
	"measure": "Measure",
	"height": "Height of the section",
	"live": "Live",
	"time": "Time",
	"rest": "{time} to go",
	"line": "line {line}",
	"distance": "{distance} mm apart",
	"second": "Choose the second point.",
	"facts": "{n} points, {x} × {y} × {z} mm",
	"failed": "The path could not be computed",
	"cut_by_alarm": "The path ends at an alarm of the program",
	"cut_by_size": "The program is longer than what is shown",
	"turned": "ZY",
	"around": "ZXY",
	"next": "Next view"
};
export { graphics_default as default };
