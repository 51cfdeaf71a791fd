// src/locales/tr/graphics.json
var graphics_default = {
	"title": "Grafik",
	"none": "Program seçili değil",
	"none_text": "Seçili programın yolu burada çizilir.",
	"iso": "XYZ",
	"top": "XY",
	"front": "XZ",
	"side": "YZ",
	"fit": "Tümünü göster",
	"rapids": "Hızlılar",
	"section": "Kesit",
	"measure": "Ölç",
	"height": "Kesit yüksekliği",
	"live": "Canlı",
	"time": "Zaman",
	"rest": "{time} kaldı",
	"line": "satır {line}",
	"distance": "{distance} mm uzaklık",
	"second": "İkinci noktayı seçin.",
	"facts": "{n} nokta, {x} × {y} × {z} mm",
	"failed": "Yol hesaplanamadı",
	"cut_by_alarm": "Yol programdaki bir alarmda bitiyor",
	"cut_by_size": "Program gösterilenden uzun",
	"turned": "ZY",
	"around": "ZXY",
	"next": "Sonraki görünüm"
};
export { graphics_default as default };
