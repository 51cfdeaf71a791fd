// src/locales/es/error.json
var error_default = {
	"failed": "No ha funcionado",
	"not_in_command": "Tome primero el mando",
	"taken": "Otra persona está al mando",
	"no_connection": "Sin conexión con la máquina",
	"no_machine": "La máquina no responde",
	"no_answer": "La máquina no respondió a tiempo",
	"no_command": "La máquina no conoce esta orden",
	"no_object": "La máquina no pudo leer esto",
	"bad_id": "La máquina no pudo leer esto",
	"refused": "La máquina lo rechazó",
	"unreadable": "El archivo no es texto",
	"too_large": "El archivo es demasiado grande",
	"log_in": "Inicie sesión primero",
	"busy": "La máquina está ocupada, inténtelo de nuevo"
};
export { error_default as default };
