// src/locales/es/item.json
var item_default = {
	"programs": "Programas",
	"parameters": "Parámetros",
	"offsets": "Correctores",
	"zeros": "Ceros de pieza",
	"reference-points": "Puntos de referencia",
	"variables": "Variables macro",
	"pitch": "Error de paso",
	"plc": "Datos del PLC",
	"counters": "Contadores",
	"alarms": "Historial de alarmas",
	"log": "Registro de operaciones",
	"position": "Posición",
	"ladder": "Programa PLC",
	"interrupted": "Ejecución interrumpida",
	"rights": "Permisos",
	"memory": "Memoria"
};
export { item_default as default };
