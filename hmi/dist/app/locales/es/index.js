import activity_default from "./activity.js";
import alarms_default from "./alarms.js";
import app_default from "./app.js";
import cycles_default from "./cycles.js";
import diagnosis_default from "./diagnosis.js";
import editor_default from "./editor.js";
import error_default from "./error.js";
import graphics_default from "./graphics.js";
import help_default from "./help.js";
import item_default from "./item.js";
import keymap_default from "./keymap.js";
import log_default from "./log.js";
import message_default from "./message.js";
import mode_default from "./mode.js";
import offsets_default from "./offsets.js";
import operations_default from "./operations.js";
import panel_default from "./panel.js";
import plc_default from "./plc.js";
import position_default from "./position.js";
import probe_default from "./probe.js";
import program_default from "./program.js";
import restart_default from "./restart.js";
import rights_default from "./rights.js";
import settings_default from "./settings.js";
import unit_default from "./unit.js";
import welcome_default from "./welcome.js";
import { gather } from "../../lib/i18n/gather.js";
// src/locales/es/index.ts
var es_default = gather(/* #__PURE__ */ Object.assign({
	"./activity.json": activity_default,
	"./alarms.json": alarms_default,
	"./app.json": app_default,
	"./cycles.json": cycles_default,
	"./diagnosis.json": diagnosis_default,
	"./editor.json": editor_default,
	"./error.json": error_default,
	"./graphics.json": graphics_default,
	"./help.json": help_default,
	"./item.json": item_default,
	"./keymap.json": keymap_default,
	"./log.json": log_default,
	"./message.json": message_default,
	"./mode.json": mode_default,
	"./offsets.json": offsets_default,
	"./operations.json": operations_default,
	"./panel.json": panel_default,
	"./plc.json": plc_default,
	"./position.json": position_default,
	"./probe.json": probe_default,
	"./program.json": program_default,
	"./restart.json": restart_default,
	"./rights.json": rights_default,
	"./settings.json": settings_default,
	"./unit.json": unit_default,
	"./welcome.json": welcome_default
}));
export { es_default as default };
