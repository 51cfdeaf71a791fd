// src/locales/en/mode.json
var mode_default = {
	"auto": "Automatic",
	"edit": "Edit",
	"mdi": "Manual data input",
	"dnc": "DNC",
	"home": "Machine zero return",
	"jog": "Jog",
	"step": "Step",
	"handle": "Handwheel",
	"short_auto": "AUTO",
	"short_edit": "EDIT",
	"short_mdi": "MDI",
	"short_dnc": "DNC",
	"short_home": "HOME",
	"short_jog": "JOG",
	"short_step": "STEP",
	"short_handle": "MPG"
};
export { mode_default as default };
