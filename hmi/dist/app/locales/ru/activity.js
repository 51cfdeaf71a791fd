// src/locales/ru/activity.json
var activity_default = {
	"idle": "Готов",
	"running": "Работает",
	"held": "Подача остановлена",
	"block_end": "Конец кадра",
	"stopped": "Останов программы",
	"returning": "Возврат",
	"by_hand": "Вручную",
	"resetting": "Сброс",
	"alarm": "Авария",
	"emergency": "Аварийный останов"
};
export { activity_default as default };
