// src/locales/ru/editor.json
var editor_default = {
	"find": "Найти",
	"replace": "Заменить на",
	"next": "Далее",
	"previous": "Назад",
	"all": "Все",
	"case": "С учётом регистра",
	"expression": "Выражение",
	"word": "Слово целиком",
	"replace_this": "Заменить",
	"replace_all": "Заменить все",
	"close": "Закрыть",
	"match": "Совпадение",
	"on_line": "в строке",
	"replaced": "Замен: $",
	"replaced_on_line": "Заменено в строке $",
	"line": "Перейти к строке",
	"go": "Перейти",
	"findings": "Замечания",
	"no_findings": "Замечаний нет",
	"completions": "Коды",
	"deleted": "Удалено"
};
export { editor_default as default };
