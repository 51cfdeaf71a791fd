// src/locales/ru/graphics.json
var graphics_default = {
	"title": "Графика",
	"none": "Программа не выбрана",
	"none_text": "Здесь рисуется траектория выбранной программы.",
	"iso": "XYZ",
	"top": "XY",
	"front": "XZ",
	"side": "YZ",
	"fit": "Показать всё",
	"rapids": "Быстрые ходы",
	"section": "Сечение",
	"measure": "Измерить",
	"height": "Высота сечения",
	"live": "Сейчас",
	"time": "Время",
	"rest": "осталось {time}",
	"line": "строка {line}",
	"distance": "расстояние {distance} мм",
	"second": "Выберите вторую точку.",
	"facts": "{n} точек, {x} × {y} × {z} мм",
	"failed": "Траекторию не удалось рассчитать",
	"cut_by_alarm": "Траектория кончается на ошибке программы",
	"cut_by_size": "Программа длиннее показанного",
	"turned": "ZY",
	"around": "ZXY",
	"next": "Следующий вид"
};
export { graphics_default as default };
