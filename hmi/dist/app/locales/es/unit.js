// src/locales/es/unit.json
var unit_default = {
	"mm": "mm",
	"mm_min": "mm/min",
	"rpm": "r/min",
	"s": "s",
	"ms": "ms",
	"deg": "°",
	"us": "µs",
	"mm_s2": "mm/s²",
	"mm_s3": "mm/s³",
	"h": "h",
	"day": "d",
	"bit_s": "bit/s"
};
export { unit_default as default };
