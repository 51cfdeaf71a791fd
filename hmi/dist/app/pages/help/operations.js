// src/pages/help/operations.ts
var operations = [
	["home", "position"],
	["jog", "position"],
	["step", "position"],
	["relative", "position/relative"],
	["speed", "position"],
	["run", "program/run"],
	["check", "program/edit"],
	["edit", "program/edit"],
	["replace", "program/edit"],
	["mdi", "program/mdi"],
	["files", "program/directory"],
	["dnc", "program/dnc"],
	["restart", "program/run"],
	["offset", "offsets/tools"],
	["parameter", "offsets/parameters"],
	["macro", "offsets/variables"],
	["pitch", "offsets/pitch"],
	["zero", "settings/zeros"],
	["centre", "settings/centring"],
	["tool", "settings/tool"],
	["machine_zero", "settings/machine_zero"],
	["switches", "settings/general"],
	["data", "settings/data"],
	["rights", "settings/rights"],
	["draw", "graphics"],
	["cycle", "cycles"],
	["signal", "diagnosis/signals"],
	["ladder", "plc/monitor"],
	["alarm", "alarms"],
	["limit", "alarms"]
];
/** What the GSK990MC has and this machine has not, or has no use for, with its sections; `operations.not_ID_why` says why. */
var notHere = [
	["bus", "3.1.4, 3.3.5, 3.6.1"],
	["servo", "3.3.5.1, 3.3.5.2"],
	["tune", "3.3.5.3"],
	["dual", "3.3.5.4"],
	["channel", "3.4.1, 11.1, 11.2"],
	["power", "2.2"],
	["system", "3.6.1.2, 3.9"]
];
export { notHere, operations };
