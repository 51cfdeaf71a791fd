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
/** The keys of axes by their place, with the letters that the machine gives them and the lamps of their reference points. Those
behind the fourth are called by their number, in ladders that have them. */
var axisKeysOf = (letters) => letters.map((letter, index) => {
	const name = axisSignals[index] ?? String(index + 1);
	return {
		letter,
		place: index + 1,
		plus: `KEY_${name}+`,
		minus: `KEY_${name}-`,
		wheel: `KEY_W${name}`,
		zero: `LAMP_ZERO_${name}`,
		isStandard: index < axisSignals.length
	};
});
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
/** Axes that a machine may have. */
var MOST_AXES = 8;
/** What the panel has a place for. */
var placed = [
	...[
		...modes,
		...switches,
		...spindle,
		...auxiliaries,
		...rapids
	].flatMap(({ signal, lamp }) => [signal, lamp]),
	...increments.map(({ signal }) => signal),
	...axisKeysOf(Array.from({ length: MOST_AXES }, () => "")).flatMap(({ plus, minus, wheel, zero }) => [
		plus,
		minus,
		wheel,
		zero
	]),
	...[
		"START",
		"HOLD",
		"RAPID"
	].flatMap((name) => [`KEY_${name}`, `LAMP_${name}`])
];
/** The keys and lamps of a ladder for which the panel has no place, from the bits of X and Y that have a name. */
function ownKeysOf(inputs, outputs) {
	const own = (signals, prefix) => signals.filter(({ name, address }) => name.startsWith(prefix) && address.includes(".") && !placed.includes(name));
	const lamps = own(outputs, "LAMP_");
	const keys = own(inputs, "KEY_").map(({ name, meaning }) => {
		const lamp = name.replace(/^KEY_/, "LAMP_");
		return {
			signal: name,
			lamp: outputs.some((one) => one.name === lamp) ? lamp : "",
			text: meaning || name
		};
	});
	const single = lamps.filter(({ name }) => !keys.some(({ lamp }) => lamp === name));
	return [...keys, ...single.map(({ name, meaning }) => ({
		signal: "",
		lamp: name,
		text: meaning || name
	}))];
}
export { auxiliaries, axisKeysOf, axisSignals, increments, modes, ownKeysOf, rapids, spindle, switches };
