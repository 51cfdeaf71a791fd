/** A bit of a parameter as the manual prints it, `43#1`, written so that `3#1` is not part of it. */
export const numberedBit = (number: number | string, bit: number): string => `no${number}#${bit}`;

/** A word that is sought: `43#1` is the same as `no43#1`. */
export const asNumberedBit = (word: string): string => (/^\d+#\d$/.test(word) ? `no${word}` : word);
