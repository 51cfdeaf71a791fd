// src/locales/es/help.json
var help_default = {
	"title": "Ayuda",
	"search": "Búsqueda",
	"codes": "Códigos",
	"calculator": "Calculadora",
	"placeholder": "Códigos, parámetros, alarmas, variables, señales, direcciones",
	"nothing": "No se encontró nada",
	"empty": "Busque algo",
	"empty_text": "Escriba un código como G84, un número de alarma o parámetro, o una palabra.",
	"kind_code": "Código",
	"kind_parameter": "Parámetro",
	"kind_alarm": "Alarma",
	"kind_variable": "Variable",
	"kind_signal": "Señal",
	"kind_address": "Dirección",
	"choose": "Elija un código a la izquierda.",
	"sum": "Operación",
	"operations": "Operaciones",
	"parameters": "Parámetros",
	"alarms": "Alarmas",
	"variables": "Variables",
	"addresses": "Direcciones",
	"choose_row": "Elija una fila a la izquierda.",
	"not_here": "Páginas del GSK990MC que esta máquina no usa"
};
export { help_default as default };
