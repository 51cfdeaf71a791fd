// src/locales/tr/unit.json
var unit_default = {
	"mm": "mm",
	"mm_min": "mm/dk",
	"rpm": "dev/dk",
	"s": "s",
	"ms": "ms",
	"deg": "°",
	"us": "µs"
};
export { unit_default as default };
