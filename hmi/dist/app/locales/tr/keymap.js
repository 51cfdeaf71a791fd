// src/locales/tr/keymap.json
var keymap_default = {
	"title": "Klavye",
	"jog": "Basılıyken {axes} hareketi (elle modu)",
	"wheel": "El çarkı (odaktayken)",
	"save": "Programı kaydet",
	"find": "Bul ve değiştir",
	"space": "Boşluk",
	"complete": "Kodu tamamla",
	"held": "Hareket tuşları yalnız basılıyken çalışır; pencere odağı yitirince durur.",
	"feed": "İlerleme oranı, bir adım",
	"spindle": "İş mili oranı, bir adım",
	"rapid": "Hızlı hareket oranı, bir adım"
};
export { keymap_default as default };
