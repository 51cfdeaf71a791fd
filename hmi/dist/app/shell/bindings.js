import { axisSignals } from "./keys.js";
// src/shell/bindings.ts
/** Keys that are held like those of the machine panel. */
var heldKeys = [{
	key: "F9",
	signal: "KEY_HOLD"
}, {
	key: "F10",
	signal: "KEY_START"
}];
/** What a key that is held does. Shift+F10 and others open menus, so that a start is F10 alone; a hold stops the machine
whatever else is down. */
function heldKey(event) {
	const isAlone = !(event.ctrlKey || event.altKey || event.shiftKey || event.metaKey);
	return heldKeys.find(({ key, signal }) => key === event.key && (isAlone || signal === "KEY_HOLD"))?.signal;
}
/** Axis keys, by the place of their axis; they move in the mode JOG alone, and only with Ctrl, so that a cursor key never
moves a machine. With Shift they move the axes behind the first two. */
var axisKeys = [
	[
		"ArrowRight",
		false,
		0,
		"+"
	],
	[
		"ArrowLeft",
		false,
		0,
		"-"
	],
	[
		"ArrowUp",
		false,
		1,
		"+"
	],
	[
		"ArrowDown",
		false,
		1,
		"-"
	],
	[
		"ArrowUp",
		true,
		2,
		"+"
	],
	[
		"ArrowDown",
		true,
		2,
		"-"
	],
	[
		"ArrowRight",
		true,
		3,
		"+"
	],
	[
		"ArrowLeft",
		true,
		3,
		"-"
	]
].map(([key, shift, axis, sign]) => ({
	chord: {
		key,
		ctrl: true,
		shift
	},
	axis,
	signal: `KEY_${axisSignals[axis]}${sign}`
}));
/** Switches of the panel that a key turns by a step, with Alt and Shift: with the position that they have unless told, and
the last one. */
var overrideKeys = {
	ArrowUp: [
		"SWITCH_FEED",
		1,
		10,
		20
	],
	ArrowDown: [
		"SWITCH_FEED",
		-1,
		10,
		20
	],
	ArrowRight: [
		"SWITCH_SPINDLE",
		1,
		5,
		7
	],
	ArrowLeft: [
		"SWITCH_SPINDLE",
		-1,
		5,
		7
	]
};
/** Steps of the rapid override, with Alt and Shift. */
var rapidKeys = {
	PageUp: 1,
	PageDown: -1
};
[
	...heldKeys.map(({ key }) => ({ key })),
	...axisKeys.map(({ chord }) => chord),
	...[...Object.keys(overrideKeys), ...Object.keys(rapidKeys)].map((key) => ({
		key,
		alt: true,
		shift: true
	})),
	...[
		"1",
		"2",
		"3",
		"4",
		"5",
		"6",
		"7",
		"8"
	].map((key) => ({
		key,
		alt: true,
		shift: true
	})),
	...[
		"1",
		"2",
		"3",
		"4",
		"5",
		"6",
		"7",
		"8",
		"9",
		"0"
	].map((key) => ({
		key,
		alt: true
	}))
];
/** The axis key that is pressed, of a machine with so many axes. */
function axisKey(event, axes) {
	if (!event.ctrlKey || event.altKey) return void 0;
	return axisKeys.find(({ chord, axis }) => axis < axes && chord.key === event.key && chord.shift === event.shiftKey);
}
/** Whether a key that is held is one no more, since a modifier of it was let go. */
function ended(chord, event) {
	const off = (needed, isDown, key) => needed === true && (!isDown || event.type === "keyup" && event.key === key);
	return off(chord.ctrl, event.ctrlKey, "Control") || off(chord.shift, event.shiftKey, "Shift") || off(chord.alt, event.altKey, "Alt");
}
export { axisKey, axisKeys, ended, heldKey, heldKeys, overrideKeys, rapidKeys };
