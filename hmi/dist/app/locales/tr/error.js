// src/locales/tr/error.json
var error_default = {
	"failed": "Olmadı",
	"not_in_command": "Önce komutayı alın",
	"taken": "Komuta başkasında",
	"no_connection": "Tezgâhla bağlantı yok",
	"no_machine": "Tezgâh yanıt vermiyor",
	"no_answer": "Tezgâh zamanında yanıt vermedi",
	"no_command": "Tezgâh bu komutu bilmiyor",
	"no_object": "Tezgâh bunu okuyamadı",
	"bad_id": "Tezgâh bunu okuyamadı",
	"refused": "Tezgâh bunu reddetti",
	"unreadable": "Tezgâh bunu okuyamadı",
	"too_large": "Dosya çok büyük",
	"log_in": "Önce oturum açın",
	"busy": "Makine meşgul, yeniden deneyin",
	"not_text": "Dosya metin değil",
	"too_slow": "Bağlantı çok yavaştı",
	"too_often": "Çok fazla deneme: bir dakika bekleyin",
	"missing": "Tezgâhta bu yok",
	"other_origin": "Tezgâh bunu yalnız kendi sayfasından kabul eder",
	"unknown_host": "Tezgâh kendini bu adresle tanımıyor",
	"line_too_long": "Bir defada gönderilen çok uzundu",
	"too_many_connections": "Zaten çok fazla bağlantı var",
	"logged_out": "Oturum kapatıldı",
	"dnc_over": "Dosyanın devamı beklenmiyor",
	"dnc_foreign": "Bu, gönderilmekte olan dosya değil"
};
export { error_default as default };
