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
	"unreadable": "Dosya metin değil",
	"too_large": "Dosya çok büyük",
	"log_in": "Önce oturum açın",
	"busy": "Makine meşgul, yeniden deneyin"
};
export { error_default as default };
