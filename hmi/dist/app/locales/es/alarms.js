// src/locales/es/alarms.json
var alarms_default = {
	"title": "Alarmas",
	"active": "Activas",
	"history": "Historial",
	"log": "Registro",
	"none": "No hay alarmas",
	"none_text": "La máquina está bien. Las alarmas pasadas están en el historial.",
	"remedy": "Qué hacer:",
	"to_program": "Ir al programa",
	"time": "Hora",
	"number": "Número",
	"text": "Alarma",
	"program": "Programa",
	"who": "Quién",
	"what": "Qué",
	"change": "De qué a qué",
	"clear": "Vaciar",
	"clear_right": "Requiere nivel 3",
	"none_past": "Todavía ninguna alarma",
	"none_past_text": "Aquí quedan las alarmas con su hora, su programa y su remedio.",
	"entries_one": "{n} entrada",
	"entries_other": "{n} entradas",
	"older": "Anteriores"
};
export { alarms_default as default };
