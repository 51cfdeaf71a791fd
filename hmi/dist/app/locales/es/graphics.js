// src/locales/es/graphics.json
var graphics_default = {
	"title": "Gráficos",
	"none": "No hay programa seleccionado",
	"none_text": "Aquí se dibuja la trayectoria del programa seleccionado.",
	"iso": "XYZ",
	"top": "XY",
	"front": "XZ",
	"side": "YZ",
	"fit": "Ver todo",
	"rapids": "Rápidos",
	"section": "Sección",
	"measure": "Medir",
	"height": "Altura de la sección",
	"live": "En vivo",
	"time": "Tiempo",
	"rest": "quedan {time}",
	"line": "línea {line}",
	"distance": "{distance} mm de distancia",
	"second": "Elija el segundo punto.",
	"facts": "{n} puntos, {x} × {y} × {z} mm",
	"failed": "No se pudo calcular la trayectoria",
	"cut_by_alarm": "La trayectoria acaba en una alarma del programa",
	"cut_by_size": "El programa es más largo que lo mostrado",
	"turned": "ZY",
	"around": "ZXY",
	"next": "Vista siguiente"
};
export { graphics_default as default };
