// What a browser remembers for its user: language, theme, what is shown.

export const LANGUAGES = ['en', 'zh', 'ru', 'es', 'tr'] as const;
export type Language = (typeof LANGUAGES)[number];
/** With what the page of positions opens; the GSK990MC shows relative ones once it has power (part 2, 3.1). */
export type Coordinates = 'absolute' | 'relative';
export type Theme = 'system' | 'light' | 'dark';

const KEY = 'ferrocut.panel';

type Kept = {
  language: Language;
  theme: Theme;
  coordinates: Coordinates;
  /** Whether the machine panel stands beside the page. */
  panel: boolean;
  /** Whether keys to be touched stand under what is written. */
  keypad: boolean;
  /** The drawing (GSK990MC part 2, 3.5): whether what is drawn goes at the next cycle start; whether the tool
      leaves a trail where no program tells its path; the range that is shown,
      coordinates of the work, mm, null for that of the program; and what stands in the middle, and the scale (1: a millimetre
      is one on the screen), null where they follow from the range. */
  drawing: {
    erases: boolean;
    trail: boolean;
    range: { low: [number, number, number]; high: [number, number, number] } | null;
    frame: { centre: [number, number, number]; scale: number } | null;
  };
  /** Whether the first start was gone through. */
  welcomed: boolean;
};

function fromBrowser(): Language {
  for (const wanted of navigator.languages) {
    const short = wanted.slice(0, 2).toLowerCase();
    const found = LANGUAGES.find((language) => language === short);
    if (found) return found;
  }
  return 'en';
}

function read(): Kept {
  const standard: Kept = { language: fromBrowser(), theme: 'system', coordinates: 'absolute', panel: innerWidth > 1100, keypad: matchMedia('(pointer: coarse)').matches, drawing: { erases: true, trail: true, range: null, frame: null }, welcomed: false };
  try {
    const kept = JSON.parse(localStorage.getItem(KEY) ?? '{}') as Partial<Kept>;
    if (kept.language && !LANGUAGES.includes(kept.language)) delete kept.language;
    return { ...standard, ...kept, drawing: { ...standard.drawing, ...kept.drawing } };
  } catch {
    return standard;
  }
}

export const prefs: Kept = $state(read());

/** Keeps what changes, and puts theme and language into the page. */
export function keepPrefs(): void {
  const system = matchMedia('(prefers-color-scheme: light)');
  const show = () => {
    const theme = prefs.theme === 'system' ? (system.matches ? 'light' : 'dark') : prefs.theme;
    document.documentElement.dataset.theme = theme;
  };
  system.addEventListener('change', show);
  $effect.root(() => {
    $effect(() => {
      show();
      document.documentElement.lang = prefs.language;
      try {
        localStorage.setItem(KEY, JSON.stringify(prefs));
      } catch {
        // A browser that keeps nothing asks again next time.
      }
    });
  });
}
