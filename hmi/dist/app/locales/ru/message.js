// src/locales/ru/message.json
var message_default = {
	"MSG_AIR": "Низкое давление воздуха",
	"MSG_LUBE": "Мало смазки или нет давления",
	"MSG_COOLANT": "Мало СОЖ",
	"MSG_CONVEYOR": "Перегрузка транспортёра стружки",
	"MSG_DOOR": "Дверь открыта во время работы",
	"MSG_DRIVE": "Привод шпинделя не готов",
	"MSG_TOOL": "Смена инструмента слишком долгая",
	"MSG_POCKET": "Нет такого гнезда",
	"MSG_MAGAZINE": "Магазин у шпинделя: сначала отведите его (M22)"
};
export { message_default as default };
