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
	"unreadable": "La máquina no pudo leer esto",
	"too_large": "El archivo es demasiado grande",
	"log_in": "Inicie sesión primero",
	"busy": "La máquina está ocupada, inténtelo de nuevo",
	"not_text": "El archivo no es texto",
	"too_slow": "La conexión fue demasiado lenta",
	"too_often": "Demasiados intentos: espere un minuto",
	"missing": "La máquina no lo tiene",
	"other_origin": "La máquina solo lo acepta desde su propia página",
	"unknown_host": "La máquina no se reconoce con esta dirección",
	"line_too_long": "Lo enviado de una vez era demasiado largo",
	"too_many_connections": "Ya hay demasiadas conexiones",
	"logged_out": "Se cerró la sesión",
	"dnc_over": "No se espera más de ningún archivo",
	"dnc_foreign": "Este no es el archivo que se estaba enviando"
};
export { error_default as default };
