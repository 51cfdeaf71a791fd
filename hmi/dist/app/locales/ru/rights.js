// src/locales/ru/rights.json
var rights_default = {
	"title": "Права",
	"level": "Уровень {level}",
	"level_label": "Уровень",
	"level_0": "Вход не выполнен",
	"level_1": "Изготовитель ЧПУ",
	"level_2": "Станкостроитель",
	"level_3": "Наладчик системы",
	"level_4": "Конечный пользователь",
	"level_5": "Оператор",
	"log_in": "Войти",
	"log_out": "Выйти",
	"logged_in": "Вход выполнен: {level}",
	"password": "Пароль",
	"wrong": "Это не пароль этого уровня.",
	"too_often": "Слишком много попыток. Подождите минуту.",
	"gate": "Сначала войдите",
	"gate_text": "С этого компьютера станок виден и управляется только после входа."
};
export { rights_default as default };
