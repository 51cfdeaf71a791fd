// src/locales/es/plc.json
var plc_default = {
	"title": "PLC",
	"monitor": "Diagrama",
	"edit": "Cambiar",
	"trace": "Registro",
	"none": "Esta máquina no tiene diagrama",
	"none_text": "Arranque la máquina con uno: --ladder FILE.",
	"nothing": "Ningún peldaño coincide",
	"rung": "Peldaño en la línea {line}",
	"force_on": "Forzar a 1",
	"force_off": "Forzar a 0",
	"force_release": "Liberar",
	"facts": "{rungs} peldaños, {instructions} instrucciones",
	"roll_back": "Volver al anterior",
	"start": "Arrancar",
	"exchange": "Sustituir",
	"exchange_text": "El diagrama se sustituye entre dos ciclos con la máquina en marcha. Señales, temporizadores y contadores se conservan.",
	"exchanged": "Diagrama sustituido",
	"signals": "Nombres de señales, hasta 32",
	"record": "Registrar",
	"stop": "Parar",
	"trace_text": "El control muestrea en cada ciclo del PLC; lo que no cambia no se guarda.",
	"at_signal": "Con una señal",
	"changes": "Cambia",
	"trigger": "Señal de disparo",
	"waits": "Espera la señal …"
};
export { plc_default as default };
