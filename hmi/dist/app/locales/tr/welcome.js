// src/locales/tr/welcome.json
var welcome_default = {
	"title": "Hoş geldiniz",
	"machine": "{machine}, dili {dialect}",
	"command": "Komuta her an tek ekrandadır; diğerleri izler. Üstteki düğmeyle devredilir.",
	"stop": "Sıfırlama ve acil stop her ekrandan her an çalışır.",
	"keys": "Tezgâh tuşları basılı tutuldukça çalışır. Klavye için ? tuşuna basın.",
	"watch": "Yalnız izle",
	"start": "Komutayı al"
};
export { welcome_default as default };
