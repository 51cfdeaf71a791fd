// src/locales/en/probe.json
var probe_default = {
	"hint": "Prepared in Automatic, done by cycle start.",
	"ready": "Ready: cycle start measures",
	"work": "Work zero by probe",
	"hole": "Hole",
	"boss": "Boss",
	"slot": "Slot",
	"web": "Web",
	"edge": "Edge",
	"diameter": "Diameter",
	"along": "Width along {axis}",
	"distance": "Way to the edge",
	"height": "Height of touch",
	"tolerance": "Tolerance",
	"way": "Way of touch",
	"prepare": "Prepare",
	"tool": "Tool by setter",
	"tool_length": "Length",
	"tool_diameter": "Diameter",
	"tool_both": "Both",
	"length": "Estimated length",
	"tool_hint": "Fields left empty are taken from the offsets. The setter stands where P387 to P389 say.",
	"last": "Measured last",
	"stored": "Stored to {what}",
	"nothing": "Nothing was measured yet."
};
export { probe_default as default };
