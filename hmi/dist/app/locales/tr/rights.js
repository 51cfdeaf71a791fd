// src/locales/tr/rights.json
var rights_default = {
	"title": "Yetkiler",
	"level": "Düzey {level}",
	"level_label": "Düzey",
	"level_0": "Oturum yok",
	"level_1": "Sistem üreticisi",
	"level_2": "Tezgâh üreticisi",
	"level_3": "Sistem ayarı",
	"level_4": "Son kullanıcı",
	"level_5": "Operatör",
	"log_in": "Oturum aç",
	"log_out": "Oturumu kapat",
	"logged_in": "Oturum açıldı: {level}",
	"password": "Parola",
	"wrong": "Bu, o düzeyin parolası değil.",
	"too_often": "Çok fazla deneme. Bir dakika bekleyin.",
	"gate": "Önce giriş yapın",
	"gate_text": "Bu bilgisayardan makine ancak giriş yapıldıktan sonra görülür ve kullanılır."
};
export { rights_default as default };
