// src/locales/ru/item.json
var item_default = {
	"programs": "Программы",
	"parameters": "Параметры",
	"offsets": "Коррекции инструмента",
	"zeros": "Нули детали",
	"reference-points": "Опорные точки",
	"variables": "Макропеременные",
	"pitch": "Ошибка шага",
	"plc": "Данные ПЛК",
	"counters": "Счётчики",
	"alarms": "История аварий",
	"log": "Журнал действий",
	"position": "Положение",
	"ladder": "Программа ПЛК",
	"interrupted": "Прерванный прогон",
	"rights": "Права",
	"memory": "Память"
};
export { item_default as default };
