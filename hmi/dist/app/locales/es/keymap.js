// src/locales/es/keymap.json
var keymap_default = {
	"title": "Teclado",
	"jog": "Mover {axes} mientras se pulsa (modo manual)",
	"wheel": "Volante, cuando tiene el foco",
	"save": "Guardar el programa",
	"find": "Buscar y reemplazar",
	"space": "Espacio",
	"complete": "Completar un código",
	"held": "Las teclas que mueven actúan solo mientras se mantienen pulsadas y se sueltan si la ventana pierde el foco.",
	"feed": "Corrección de avance, un paso",
	"spindle": "Corrección del husillo, un paso",
	"rapid": "Corrección de rápidos, un paso"
};
export { keymap_default as default };
