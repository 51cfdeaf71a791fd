// src/locales/ru/error.json
var error_default = {
	"failed": "Не удалось",
	"not_in_command": "Сначала возьмите управление",
	"taken": "Управляет кто-то другой",
	"no_connection": "Нет связи со станком",
	"no_machine": "Станок не отвечает",
	"no_answer": "Станок не ответил вовремя",
	"no_command": "Станок не знает этой команды",
	"no_object": "Станок не смог это прочесть",
	"bad_id": "Станок не смог это прочесть",
	"refused": "Станок отказал",
	"unreadable": "Файл не является текстом",
	"too_large": "Файл слишком велик",
	"log_in": "Сначала войдите в систему",
	"busy": "Станок занят, повторите позже"
};
export { error_default as default };
