// src/lib/i18n/plural.ts
var rules = /* @__PURE__ */ new Map();
/** The form of plural that a language has for a number: `one`, `few`, `many`, `other`. */
function form(language, count) {
	let of = rules.get(language);
	if (!of) {
		of = new Intl.PluralRules(language);
		rules.set(language, of);
	}
	return of.select(count);
}
/** The text of a key. With a value `count` the key of its plural form comes first: `parts_few`. */
function text(catalogue, language, key, values) {
	let found = catalogue[key];
	if (typeof values?.count === "number") found = catalogue[`${key}_${form(language, values.count)}`] ?? found;
	if (found === void 0) return key;
	if (!values) return found;
	return found.replace(/\{(\w+)\}/g, (all, name) => {
		const value = values[name];
		return value === void 0 ? all : String(value);
	});
}
export { form, text };
