// src/locales/ru/alarms.json
var alarms_default = {
	"title": "Аварии",
	"active": "Текущие",
	"history": "История",
	"log": "Журнал действий",
	"none": "Аварий нет",
	"none_text": "Станок в порядке. Прошлые аварии – в истории.",
	"remedy": "Что делать:",
	"to_program": "К программе",
	"time": "Время",
	"number": "Номер",
	"text": "Авария",
	"program": "Программа",
	"who": "Кто",
	"what": "Что",
	"change": "Было → стало",
	"clear": "Очистить",
	"clear_right": "Нужен уровень 3",
	"none_past": "Аварий ещё не было",
	"none_past_text": "Здесь появятся аварии со временем, программой и способом устранения.",
	"entries_one": "{n} запись",
	"entries_few": "{n} записи",
	"entries_many": "{n} записей",
	"entries_other": "{n} записи",
	"older": "Более ранние"
};
export { alarms_default as default };
