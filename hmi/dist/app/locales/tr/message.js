// src/locales/tr/message.json
var message_default = {
	"MSG_AIR": "Hava basıncı düşük",
	"MSG_LUBE": "Yağ az ya da basınçsız",
	"MSG_COOLANT": "Soğutma sıvısı az",
	"MSG_CONVEYOR": "Talaş konveyörü aşırı yüklü",
	"MSG_DOOR": "Program çalışırken kapı açıldı",
	"MSG_DRIVE": "İş mili sürücüsü hazır değil",
	"MSG_TOOL": "Takım değişimi çok uzun sürdü",
	"MSG_POCKET": "Böyle bir yuva yok",
	"MSG_MAGAZINE": "Magazin iş milinde: önce geri gönderin (M22)"
};
export { message_default as default };
