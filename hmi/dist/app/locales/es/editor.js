// src/locales/es/editor.json
var editor_default = {
	"find": "Buscar",
	"replace": "Reemplazar por",
	"next": "Siguiente",
	"previous": "Anterior",
	"all": "Todo",
	"case": "Mayúsculas y minúsculas",
	"expression": "Expresión",
	"word": "Palabra completa",
	"replace_this": "Reemplazar",
	"replace_all": "Reemplazar todo",
	"close": "Cerrar",
	"match": "Coincidencia",
	"on_line": "en la línea",
	"replaced": "Reemplazos: $",
	"replaced_on_line": "Reemplazado en la línea $",
	"line": "Ir a la línea",
	"go": "Ir",
	"findings": "Avisos",
	"no_findings": "Sin avisos",
	"completions": "Códigos",
	"deleted": "Borrado"
};
export { editor_default as default };
