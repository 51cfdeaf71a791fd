// What a page says to the thread that draws its digits.

/** Where a number of a sheet stands, and how it looks. */
export type Place = {
  /** Where it ends, or begins, and its middle, px of the screen. */
  edge: number;
  align: 'left' | 'right';
  middle: number;
  /** As a canvas understands it, of px of the screen. */
  font: string;
  /** Room between two characters besides, px of the screen. */
  spacing: number;
  /** A colour for each tone that it may have. */
  colours: string[];
};

/** A number as it is now: its characters, and which of its colours it has. */
export type Shown = { text: string; tone: number };

export type Told =
  | { do: 'new'; sheet: number; canvas: OffscreenCanvas }
  | { do: 'look'; sheet: number; width: number; height: number; places: Place[] }
  | { do: 'show'; numbers: [sheet: number, shown: Shown[]][] }
  | { do: 'drop'; sheet: number };
