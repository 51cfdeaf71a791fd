// src/shell/keys.ts
var key = (name, icon) => ({
	signal: `KEY_${name}`,
	lamp: `LAMP_${name}`,
	text: `panel.${name.toLowerCase()}`,
	...icon ? { icon } : {}
});
/** What the standard ladder calls the first four axes of a machine, whatever their letters are. */
var axisSignals = [
	"X",
	"Y",
	"Z",
	"A"
];
/** The keys of the first four axes by their place, with the letters that the machine gives them. */
var axisKeysOf = (letters) => axisSignals.slice(0, letters.length).map((name, index) => ({
	letter: letters[index],
	plus: `KEY_${name}+`,
	minus: `KEY_${name}-`,
	wheel: `KEY_W${name}`
}));
var modes = [
	["auto", "AUTO"],
	["edit", "EDIT"],
	["mdi", "MDI"],
	["dnc", "DNC"],
	["home", "HOME"],
	["jog", "JOG"],
	["step", "STEP"],
	["handle", "MPG"]
].map(([mode, name]) => ({
	mode,
	signal: `KEY_${name}`,
	lamp: `LAMP_${name}`
}));
/** Switches of automatic operation: a press turns them on or off. */
var switches = [
	"SINGLE",
	"SKIP",
	"OPTSTOP",
	"DRY",
	"MLOCK",
	"AUXLOCK",
	"RESTART",
	"HDRV"
].map((name) => key(name));
var spindle = [
	key("SP_CCW", "ccw"),
	key("SP_STOP", "stop"),
	key("SP_CW", "cw"),
	key("SP_JOG"),
	key("SP_ORIENT", "target")
];
var auxiliaries = [
	key("COOLANT", "drop"),
	key("CHIP", "more"),
	key("LUBE"),
	key("LIGHT", "lamp"),
	key("OT")
];
/** Steps of the rapid override: F0 is the speed of a parameter (P93). */
var rapids = [
	{
		signal: "KEY_R_F0",
		lamp: "LAMP_R_F0",
		label: "F0"
	},
	{
		signal: "KEY_R_25",
		lamp: "LAMP_R_25",
		label: "25"
	},
	{
		signal: "KEY_R_50",
		lamp: "LAMP_R_50",
		label: "50"
	},
	{
		signal: "KEY_R_100",
		lamp: "LAMP_R_100",
		label: "100"
	}
];
/** Steps of the increment, mm. */
var increments = [
	"0.001",
	"0.01",
	"0.1",
	"1"
].map((label, step) => ({
	signal: `KEY_S${step}`,
	label
}));
export { auxiliaries, axisKeysOf, axisSignals, increments, modes, rapids, spindle, switches };
