// src/locales/en/message.json
var message_default = {
	"MSG_AIR": "Compressed air is too low",
	"MSG_LUBE": "Lubricant is too low, or has no pressure",
	"MSG_COOLANT": "Coolant is too low",
	"MSG_CONVEYOR": "Chip conveyor is overloaded",
	"MSG_DOOR": "Door was opened while the program ran",
	"MSG_DRIVE": "Spindle drive is not ready",
	"MSG_TOOL": "Tool change takes too long",
	"MSG_POCKET": "There is no such pocket",
	"MSG_MAGAZINE": "The magazine is at the spindle: send it away first (M22)"
};
export { message_default as default };
