// src/locales/tr/probe.json
var probe_default = {
	"hint": "Otomatikte hazırlanır, çevrim başlatma ile yapılır.",
	"ready": "Hazır: çevrim başlatma ölçer",
	"work": "Probla iş parçası sıfırı",
	"hole": "Delik",
	"boss": "Göbek",
	"slot": "Kanal",
	"web": "Kaburga",
	"edge": "Kenar",
	"diameter": "Çap",
	"along": "{axis} boyunca genişlik",
	"distance": "Kenara kadar yol",
	"height": "Dokunma yüksekliği",
	"tolerance": "Tolerans",
	"way": "Dokunma yönü",
	"prepare": "Hazırla",
	"tool": "Takım ölçücüyle takım",
	"tool_length": "Boy",
	"tool_diameter": "Çap",
	"tool_both": "İkisi",
	"length": "Tahmini boy",
	"tool_hint": "Boş alanlar ofsetlerden alınır. Ölçücünün yeri P387 ile P389'dadır.",
	"last": "Son ölçüm",
	"stored": "{what} yerine yazıldı",
	"nothing": "Henüz bir şey ölçülmedi."
};
export { probe_default as default };
