// src/locales/zh/unit.json
var unit_default = {
	"mm": "mm",
	"mm_min": "mm/min",
	"rpm": "r/min",
	"s": "s",
	"ms": "ms",
	"deg": "°",
	"us": "µs"
};
export { unit_default as default };
