// Profiles that are kept by their names (Fagor 3.3), by the browser.
import type { Contour, ProfileUse } from '$lib/api/cycles';
import { isClosed } from './geometry';

/** What a profile is for; one of depth stands upright. */
export type Use = Exclude<ProfileUse, 'none' | 'depths'> | 'depth';
export type Kept = { isDepth: boolean; contours: Contour[] };

const KEY = 'ferrocut.profiles';

function read(): Record<string, Kept> {
  try {
    const kept = JSON.parse(localStorage.getItem(KEY) ?? '{}') as Record<string, Kept>;
    return Object.fromEntries(Object.entries(kept).filter(([name, one]) => isName(name) && Array.isArray(one?.contours)));
  } catch {
    return {};
  }
}

/** A name that stands in a block as it is. */
export const isName = (name: string): boolean => /^[A-Za-z][A-Za-z0-9_]{0,31}$/.test(name);

/** Whether contours may be a profile of a use. */
export function fits(contours: Contour[], isDepth: boolean, use: Use): boolean {
  if (isDepth !== (use === 'depth')) return false;
  if (use === 'contours') return contours.every(isClosed);
  const [one] = contours;
  if (contours.length !== 1 || !one) return false;
  if (use === 'depth') return !isClosed(one);
  return use === 'path' || (one.elements.length < 25 && one.elements.every((element) => element.kind === 'line'));
}

// Another page of the browser may have kept others since: they are read before any is kept.
const all = $state(read());

/** Whether it is kept beyond this page; a browser may have no room. */
function write(): boolean {
  try {
    localStorage.setItem(KEY, JSON.stringify(all));
    return true;
  } catch {
    return false;
  }
}

export const profiles = {
  /** Those that may stand in the place of a profile, by their names. */
  of(use: Use): [string, Kept][] {
    return Object.entries(all).filter(([, { contours, isDepth }]) => fits(contours, isDepth, use)).sort(([a], [b]) => a.localeCompare(b));
  },
  has(name: string): boolean {
    return Object.hasOwn(all, name);
  },
  keep(name: string, contours: Contour[], isDepth: boolean): boolean {
    Object.assign(all, read());
    all[name] = { isDepth, contours: $state.snapshot(contours) };
    return write();
  },
  /** A copy of its own; ways in and out are those of a path. */
  get(name: string, use: Use): Contour[] {
    const contours = structuredClone($state.snapshot(all[name]?.contours ?? []));
    return use === 'path' ? contours : contours.map((one) => ({ ...one, entry: 0, exit: 0 }));
  },
  remove(name: string): void {
    Object.assign(all, read());
    delete all[name];
    write();
  },
};
