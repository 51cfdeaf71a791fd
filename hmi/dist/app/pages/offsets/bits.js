// src/pages/offsets/bits.ts
/** A bit of a parameter as the manual prints it, `43#1`, written so that `3#1` is not part of it. */
var numberedBit = (number, bit) => `no${number}#${bit}`;
/** A word that is sought: `43#1` is the same as `no43#1`. */
var asNumberedBit = (word) => /^\d+#\d$/.test(word) ? `no${word}` : word;
export { asNumberedBit, numberedBit };
