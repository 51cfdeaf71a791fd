// src/locales/tr/alarms.json
var alarms_default = {
	"title": "Alarmlar",
	"active": "Etkin",
	"history": "Geçmiş",
	"log": "İşlem kaydı",
	"none": "Alarm yok",
	"none_text": "Tezgâh iyi durumda. Eski alarmlar geçmiştedir.",
	"remedy": "Ne yapmalı:",
	"to_program": "Programa git",
	"time": "Zaman",
	"number": "No.",
	"text": "Alarm",
	"program": "Program",
	"who": "Kim",
	"what": "Ne",
	"change": "Neden neye",
	"clear": "Boşalt",
	"clear_right": "Düzey 3 gerekir",
	"none_past": "Henüz alarm yok",
	"none_past_text": "Alarmlar burada saati, programı ve çözümüyle durur.",
	"entries_one": "{n} kayıt",
	"entries_other": "{n} kayıt",
	"older": "Daha eskiler"
};
export { alarms_default as default };
