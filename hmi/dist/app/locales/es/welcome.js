// src/locales/es/welcome.json
var welcome_default = {
	"title": "Bienvenido",
	"machine": "{machine}, habla {dialect}",
	"command": "Manda una sola pantalla a la vez; las demás observan. Se cede con el botón de arriba.",
	"stop": "Reset y parada de emergencia actúan siempre desde cualquier pantalla.",
	"keys": "Las teclas de la máquina actúan mientras se pulsan. Pulse ? para ver las del teclado.",
	"watch": "Solo observar",
	"start": "Tomar el mando"
};
export { welcome_default as default };
