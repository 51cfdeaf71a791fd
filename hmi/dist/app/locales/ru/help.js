// src/locales/ru/help.json
var help_default = {
	"title": "Справка",
	"search": "Поиск",
	"codes": "Коды",
	"calculator": "Калькулятор",
	"placeholder": "Коды, параметры, аварии, переменные, сигналы, адреса",
	"nothing": "Ничего не найдено",
	"empty": "Найдите нужное",
	"empty_text": "Введите код, например G84, номер аварии или параметра, либо слово.",
	"kind_code": "Код",
	"kind_parameter": "Параметр",
	"kind_alarm": "Авария",
	"kind_variable": "Переменная",
	"kind_signal": "Сигнал",
	"kind_address": "Адрес",
	"choose": "Выберите код слева.",
	"sum": "Выражение",
	"operations": "Операции",
	"parameters": "Параметры",
	"alarms": "Аварии",
	"variables": "Переменные",
	"addresses": "Адреса",
	"choose_row": "Выберите строку слева.",
	"not_here": "Страницы GSK990MC, не нужные этому станку"
};
export { help_default as default };
