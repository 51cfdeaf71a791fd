// src/locales/tr/unit.json
var unit_default = {
	"mm": "mm",
	"mm_min": "mm/dk",
	"rpm": "dev/dk",
	"s": "s",
	"ms": "ms",
	"deg": "°",
	"us": "µs",
	"mm_s2": "mm/s²",
	"mm_s3": "mm/s³",
	"h": "sa",
	"day": "gün",
	"bit_s": "bit/s"
};
export { unit_default as default };
