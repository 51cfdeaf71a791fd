// src/locales/es/diagnosis.json
var diagnosis_default = {
	"title": "Diagnóstico",
	"signals": "Señales",
	"waveform": "Osciloscopio",
	"timing": "Tiempos",
	"area": "Área",
	"more": "{n} más: búsquelas.",
	"velocity": "Velocidad",
	"position": "Posición",
	"error": "Error de seguimiento",
	"path": "F y S",
	"duration": "Duración",
	"record": "Registrar cada periodo",
	"waveform_text": "Los valores en vivo llegan 50 veces por segundo; un registro tiene cada periodo. Arrastre para ampliar, doble clic para verlo todo.",
	"periods": "Periodos desde el arranque",
	"drift": "Adelanto sobre este reloj",
	"gap": "Entre actualizaciones: mitad, 99 %",
	"gaps": "Tiempo entre actualizaciones",
	"round": "Ida y vuelta"
};
export { diagnosis_default as default };
