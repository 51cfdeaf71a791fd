// src/locales/es/mode.json
var mode_default = {
	"auto": "Automático",
	"edit": "Edición",
	"mdi": "Entrada manual",
	"dnc": "DNC",
	"home": "Búsqueda de cero",
	"jog": "Manual continuo",
	"step": "Incremental",
	"handle": "Volante",
	"short_auto": "AUTO",
	"short_edit": "EDIT",
	"short_mdi": "MDI",
	"short_dnc": "DNC",
	"short_home": "CERO",
	"short_jog": "JOG",
	"short_step": "PASO",
	"short_handle": "VOL"
};
export { mode_default as default };
