// src/locales/tr/plc.json
var plc_default = {
	"title": "PLC",
	"monitor": "Merdiven",
	"edit": "Değiştir",
	"trace": "İzleme",
	"none": "Bu tezgâhın merdiveni yok",
	"none_text": "Tezgâhı bir tane ile başlatın: --ladder FILE.",
	"nothing": "Uyan basamak yok",
	"rung": "Satır {line} basamağı",
	"force_on": "1’e zorla",
	"force_off": "0’a zorla",
	"force_release": "Serbest bırak",
	"facts": "{rungs} basamak, {instructions} komut",
	"roll_back": "Öncekine dön",
	"start": "Başlat",
	"exchange": "Değiştir",
	"exchange_text": "Merdiven, tezgâh çalışırken iki tarama arasında değiştirilir. Sinyaller, zamanlayıcılar ve sayaçlar korunur.",
	"exchanged": "Merdiven değiştirildi",
	"signals": "Sinyal adları, en çok 32",
	"record": "Kaydet",
	"stop": "Dur",
	"trace_text": "Kontrol her merdiven taramasında örnekler; değişmeyen saklanmaz.",
	"at_signal": "Sinyalle",
	"changes": "Değişen",
	"trigger": "Tetikleme sinyali",
	"waits": "Sinyal bekleniyor …"
};
export { plc_default as default };
