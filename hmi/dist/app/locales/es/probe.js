// src/locales/es/probe.json
var probe_default = {
	"hint": "Se prepara en automático y lo ejecuta la marcha de ciclo.",
	"ready": "Listo: la marcha de ciclo mide",
	"work": "Cero de pieza con palpador",
	"hole": "Agujero",
	"boss": "Saliente",
	"slot": "Ranura",
	"web": "Nervio",
	"edge": "Borde",
	"diameter": "Diámetro",
	"along": "Ancho según {axis}",
	"distance": "Recorrido hasta el borde",
	"height": "Altura del toque",
	"tolerance": "Tolerancia",
	"way": "Sentido del toque",
	"prepare": "Preparar",
	"tool": "Herramienta con medidor",
	"tool_length": "Longitud",
	"tool_diameter": "Diámetro",
	"tool_both": "Ambos",
	"length": "Longitud estimada",
	"tool_hint": "Los campos vacíos se toman de los correctores. El medidor está donde dicen P387 a P389.",
	"last": "Última medición",
	"stored": "Guardado en {what}",
	"nothing": "Aún no se ha medido nada."
};
export { probe_default as default };
