// src/locales/en/diagnosis.json
var diagnosis_default = {
	"title": "Diagnosis",
	"signals": "Signals",
	"waveform": "Waveform",
	"timing": "Timing",
	"area": "Area",
	"more": "{n} more: search for them.",
	"velocity": "Speed",
	"position": "Position",
	"error": "Lag",
	"path": "F and S",
	"duration": "Duration",
	"record": "Record each period",
	"waveform_text": "Live values come 50 times a second. A recording has each servo period. Drag across to zoom, double click to see all.",
	"periods": "Periods since the start",
	"drift": "Ahead of this clock",
	"gap": "Between updates: half, 99 %",
	"gaps": "Time between updates",
	"round": "There and back"
};
export { diagnosis_default as default };
