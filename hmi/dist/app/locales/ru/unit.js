// src/locales/ru/unit.json
var unit_default = {
	"mm": "мм",
	"mm_min": "мм/мин",
	"rpm": "об/мин",
	"s": "с",
	"ms": "мс",
	"deg": "°",
	"us": "мкс",
	"mm_s2": "мм/с²",
	"mm_s3": "мм/с³",
	"h": "ч",
	"day": "сут",
	"bit_s": "бит/с"
};
export { unit_default as default };
