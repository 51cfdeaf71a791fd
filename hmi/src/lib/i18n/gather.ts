import type { Catalogue } from './plural';

/** One catalogue of many: the keys of `./PAGE.json` get `PAGE.` before them. */
export function gather(files: Record<string, Catalogue>): Catalogue {
  const all: Catalogue = {};
  for (const [path, catalogue] of Object.entries(files)) {
    const page = path.slice(2, -5);
    for (const [key, value] of Object.entries(catalogue)) all[`${page}.${key}`] = value;
  }
  return all;
}
