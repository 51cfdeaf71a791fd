// src/locales/es/activity.json
var activity_default = {
	"idle": "Listo",
	"running": "En marcha",
	"held": "Avance retenido",
	"block_end": "Fin de bloque",
	"stopped": "Parada de programa",
	"returning": "Regresando",
	"by_hand": "Manual",
	"resetting": "Restableciendo",
	"alarm": "Alarma",
	"emergency": "Parada de emergencia"
};
export { activity_default as default };
