// src/locales/tr/activity.json
var activity_default = {
	"idle": "Hazır",
	"running": "Çalışıyor",
	"held": "İlerleme durduruldu",
	"block_end": "Satır sonu",
	"stopped": "Program durdu",
	"returning": "Geri dönüyor",
	"by_hand": "Elle",
	"resetting": "Sıfırlanıyor",
	"alarm": "Alarm",
	"emergency": "Acil durdurma"
};
export { activity_default as default };
