// src/locales/tr/editor.json
var editor_default = {
	"find": "Bul",
	"replace": "Şununla değiştir",
	"next": "Sonraki",
	"previous": "Önceki",
	"all": "Tümü",
	"case": "Büyük/küçük harf duyarlı",
	"expression": "İfade",
	"word": "Tam sözcük",
	"replace_this": "Değiştir",
	"replace_all": "Tümünü değiştir",
	"close": "Kapat",
	"match": "Eşleşme",
	"on_line": "satır",
	"replaced": "$ yer değiştirildi",
	"replaced_on_line": "$ satırında değiştirildi",
	"line": "Satıra git",
	"go": "Git",
	"findings": "Bulgular",
	"no_findings": "Bulgu yok",
	"completions": "Kodlar",
	"deleted": "Silindi"
};
export { editor_default as default };
