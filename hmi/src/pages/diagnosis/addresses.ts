// The bytes of a ladder's memory (`docs/plc.md`): how many each area has.

/** First bytes and numbers of bytes. */
const ROOMS = {
  X: [[0, 128]],
  Y: [[0, 128]],
  F: [[0, 768]],
  G: [[0, 768]],
  R: [[0, 8000], [9000, 118]],
  K: [[0, 100]],
  T: [[0, 500]],
  C: [[0, 400]],
  D: [[0, 10_000]],
  A: [[0, 250]],
} as const;
export type Area = keyof typeof ROOMS;
export const AREAS = Object.keys(ROOMS) as Area[];

/** Addresses of all bytes of an area. */
export function bytesOf(area: Area): string[] {
  return ROOMS[area].flatMap(([first, count]) => Array.from({ length: count }, (_, index) => `${area}${first + index}`));
}

/** A byte or a bit as the control calls it: `x0020.3` is X20.3. Null where there is none. */
export function addressOf(text: string): string | null {
  const match = /^([XYFGRKTCDA])0*(\d{1,5})(?:\.([0-7]))?$/.exec(text.trim().toUpperCase());
  if (!match) return null;
  const byte = Number(match[2]);
  const isThere = ROOMS[match[1] as Area].some(([first, count]) => byte >= first && byte < first + count);
  return isThere ? `${match[1]}${byte}${match[3] ? `.${match[3]}` : ''}` : null;
}
