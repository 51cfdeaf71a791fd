// src/locales/es/message.json
var message_default = {
	"MSG_AIR": "Presión de aire baja",
	"MSG_LUBE": "Falta lubricante o presión",
	"MSG_COOLANT": "Falta refrigerante",
	"MSG_CONVEYOR": "Transportador de viruta sobrecargado",
	"MSG_DOOR": "Se abrió la puerta durante el programa",
	"MSG_DRIVE": "El accionamiento del husillo no está listo",
	"MSG_TOOL": "El cambio de herramienta tarda demasiado",
	"MSG_POCKET": "No existe ese alojamiento",
	"MSG_MAGAZINE": "El almacén está en el husillo: retírelo primero (M22)"
};
export { message_default as default };
