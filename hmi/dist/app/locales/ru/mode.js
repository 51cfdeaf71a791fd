// src/locales/ru/mode.json
var mode_default = {
	"auto": "Автомат",
	"edit": "Правка",
	"mdi": "Ручной ввод",
	"dnc": "DNC",
	"home": "Выход в ноль",
	"jog": "Толчковый",
	"step": "Шаговый",
	"handle": "Маховичок",
	"short_auto": "АВТО",
	"short_edit": "ПРАВ",
	"short_mdi": "MDI",
	"short_dnc": "DNC",
	"short_home": "НОЛЬ",
	"short_jog": "РУЧН",
	"short_step": "ШАГ",
	"short_handle": "МАХ"
};
export { mode_default as default };
