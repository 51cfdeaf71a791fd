// src/locales/ru/unit.json
var unit_default = {
	"mm": "мм",
	"mm_min": "мм/мин",
	"rpm": "об/мин",
	"s": "с",
	"ms": "мс",
	"deg": "°",
	"us": "мкс"
};
export { unit_default as default };
