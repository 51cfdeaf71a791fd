// The texts of the panel. A catalogue a page and language stands in `src/locales/LANGUAGE/PAGE.json`; its keys are
// called `PAGE.KEY`. All catalogues of one language are loaded together, those of the others are not.
import { prefs, type Language } from '$lib/state/prefs.svelte';
import { text, type Catalogue, type Values } from './plural';
import { unitKey } from './units';

const loaders: Record<Language, () => Promise<{ default: Catalogue }>> = {
  en: () => import('../../locales/en'),
  zh: () => import('../../locales/zh'),
  ru: () => import('../../locales/ru'),
  es: () => import('../../locales/es'),
  tr: () => import('../../locales/tr'),
};

let loaded = $state.raw<{ language: Language; catalogue: Catalogue }>({ language: 'en', catalogue: {} });

/** Loads the catalogues of a language and takes them into use. */
export async function load(language: Language): Promise<void> {
  const { default: catalogue } = await loaders[language]();
  if (prefs.language === language) loaded = { language, catalogue };
}

/** The text of a key, such as `position.title`. */
export function t(key: string, values?: Values): string {
  return text(loaded.catalogue, loaded.language, key, values);
}

/** The sign of a unit as the control's tables write it, in the user's language; one that has no text stays as it is. */
export function unit(sign: string): string {
  const key = unitKey(sign);
  return has(key) ? t(key) : sign;
}

/** Whether there is a text. */
export function has(key: string): boolean {
  return key in loaded.catalogue;
}

/** The language whose texts are shown. */
export function language(): Language {
  return loaded.language;
}

const numbers = new Map<string, Intl.NumberFormat>();

/** A number of the user's language, for texts; measures are shown by `$lib/numbers`. */
export function number(value: number, digits = 0): string {
  const key = `${loaded.language}.${digits}`;
  let format = numbers.get(key);
  if (!format) {
    format = new Intl.NumberFormat(loaded.language, { minimumFractionDigits: digits, maximumFractionDigits: digits });
    numbers.set(key, format);
  }
  return format.format(value);
}

/** A time of day with its date, from ms since 1970. */
export function moment(ms: number): string {
  return ms > 0 ? new Intl.DateTimeFormat(loaded.language, { dateStyle: 'short', timeStyle: 'medium' }).format(ms) : '–';
}
