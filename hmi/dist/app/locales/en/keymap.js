// src/locales/en/keymap.json
var keymap_default = {
	"title": "Keyboard",
	"jog": "Move {axes} while held (mode jog)",
	"wheel": "Handwheel, when it has the focus",
	"save": "Save the program",
	"find": "Find and replace",
	"space": "Space",
	"complete": "Complete a code",
	"held": "Keys that move act only while they are held and stop when the window loses the focus.",
	"feed": "Feed override, a step",
	"spindle": "Spindle override, a step",
	"rapid": "Rapid override, a step"
};
export { keymap_default as default };
