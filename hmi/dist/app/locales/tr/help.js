// src/locales/tr/help.json
var help_default = {
	"title": "Yardım",
	"search": "Arama",
	"codes": "Kodlar",
	"calculator": "Hesap makinesi",
	"placeholder": "Kodlar, parametreler, alarmlar, değişkenler, sinyaller, adresler",
	"nothing": "Bir şey bulunamadı",
	"empty": "Bir şey arayın",
	"empty_text": "G84 gibi bir kod, alarm ya da parametre numarası veya bir sözcük yazın.",
	"kind_code": "Kod",
	"kind_parameter": "Parametre",
	"kind_alarm": "Alarm",
	"kind_variable": "Değişken",
	"kind_signal": "Sinyal",
	"kind_address": "Adres",
	"choose": "Soldan bir kod seçin.",
	"sum": "İşlem",
	"operations": "İşlemler",
	"parameters": "Parametreler",
	"alarms": "Alarmlar",
	"variables": "Değişkenler",
	"addresses": "Adresler",
	"choose_row": "Soldan bir satır seçin.",
	"not_here": "GSK990MC’nin bu makinede kullanılmayan sayfaları"
};
export { help_default as default };
