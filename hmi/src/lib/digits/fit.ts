// A number that is too long for its place is drawn smaller: none of its characters may be missing.

/** The share of its size at which a number of this width ends inside the sheet. */
export function shareOf(width: number, place: { edge: number; align: 'left' | 'right' }): number {
  return place.align === 'right' && width > place.edge && place.edge > 0 ? place.edge / width : 1;
}

/** The font of a place at a share of its size. */
export function smaller(font: string, share: number): string {
  return font.replace(/[\d.]+(?=px)/, (size) => String(Number(size) * share));
}
