// src/locales/tr/mode.json
var mode_default = {
	"auto": "Otomatik",
	"edit": "Düzenleme",
	"mdi": "Elle veri girişi",
	"dnc": "DNC",
	"home": "Referansa gitme",
	"jog": "Elle ilerleme",
	"step": "Adım",
	"handle": "El çarkı",
	"short_auto": "OTO",
	"short_edit": "DÜZ",
	"short_mdi": "MDI",
	"short_dnc": "DNC",
	"short_home": "REF",
	"short_jog": "ELLE",
	"short_step": "ADIM",
	"short_handle": "ÇARK"
};
export { mode_default as default };
