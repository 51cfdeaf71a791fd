// src/locales/tr/item.json
var item_default = {
	"programs": "Programlar",
	"parameters": "Parametreler",
	"offsets": "Takım ofsetleri",
	"zeros": "İş sıfırları",
	"reference-points": "Referans noktaları",
	"variables": "Makro değişkenleri",
	"pitch": "Hatve hatası",
	"plc": "PLC verileri",
	"counters": "Sayaçlar",
	"alarms": "Alarm geçmişi",
	"log": "İşlem kaydı",
	"position": "Konum",
	"ladder": "Merdiven programı",
	"interrupted": "Yarıda kalan çalışma",
	"rights": "Yetkiler",
	"memory": "Bellek"
};
export { item_default as default };
