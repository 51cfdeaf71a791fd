// src/locales/es/rights.json
var rights_default = {
	"title": "Permisos",
	"level": "Nivel {level}",
	"level_label": "Nivel",
	"level_0": "Sin sesión",
	"level_1": "Fabricante del control",
	"level_2": "Fabricante de la máquina",
	"level_3": "Puesta a punto",
	"level_4": "Usuario final",
	"level_5": "Operador",
	"log_in": "Iniciar sesión",
	"log_out": "Cerrar sesión",
	"logged_in": "Sesión iniciada: {level}",
	"password": "Contraseña",
	"wrong": "Esa no es la contraseña de este nivel.",
	"too_often": "Demasiados intentos. Espere un minuto.",
	"gate": "Inicie sesión primero",
	"gate_text": "Desde este equipo la máquina se ve y se maneja solo después de iniciar sesión."
};
export { rights_default as default };
