// src/locales/en/activity.json
var activity_default = {
	"idle": "Ready",
	"running": "Running",
	"held": "Feed hold",
	"block_end": "Block end",
	"stopped": "Program stop",
	"returning": "Returning",
	"by_hand": "By hand",
	"resetting": "Resetting",
	"alarm": "Alarm",
	"emergency": "Emergency stop"
};
export { activity_default as default };
