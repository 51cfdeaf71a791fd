// src/locales/tr/diagnosis.json
var diagnosis_default = {
	"title": "Tanılama",
	"signals": "Sinyaller",
	"waveform": "Dalga biçimi",
	"timing": "Zamanlama",
	"area": "Alan",
	"more": "{n} tane daha: arayın.",
	"velocity": "Hız",
	"position": "Konum",
	"error": "İzleme hatası",
	"path": "F ve S",
	"duration": "Süre",
	"record": "Her periyodu kaydet",
	"waveform_text": "Canlı değerler saniyede 50 kez gelir; kayıtta her periyot vardır. Yakınlaştırmak için sürükleyin, tümü için çift tıklayın.",
	"periods": "Başlangıçtan beri periyot",
	"drift": "Bu saatten ileri",
	"gap": "Güncelleme aralığı: yarısı, %99",
	"gaps": "Güncellemeler arası süre",
	"round": "Gidiş dönüş"
};
export { diagnosis_default as default };
