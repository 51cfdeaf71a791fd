// Texts with values and plural forms.

export type Values = Record<string, string | number>;
export type Catalogue = Record<string, string>;

const rules = new Map<string, Intl.PluralRules>();

/** The form of plural that a language has for a number: `one`, `few`, `many`, `other`. */
export function form(language: string, count: number): string {
  let of = rules.get(language);
  if (!of) {
    of = new Intl.PluralRules(language);
    rules.set(language, of);
  }
  return of.select(count);
}

/** The text of a key. With a value `count` the key of its plural form comes first: `parts_few`. */
export function text(catalogue: Catalogue, language: string, key: string, values?: Values): string {
  let found = catalogue[key];
  if (typeof values?.count === 'number') found = catalogue[`${key}_${form(language, values.count)}`] ?? found;
  if (found === undefined) return key;
  if (!values) return found;
  return found.replace(/\{(\w+)\}/g, (all, name: string) => {
    const value = values[name];
    return value === undefined ? all : String(value);
  });
}
