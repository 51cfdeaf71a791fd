// The words that what is typed may become.
import type { Word } from '$lib/api/answers';

/** A code without the zeros that it may be written with. */
const bare = (word: string) => word.toUpperCase().replace(/^([GM])0+(?=\d)/, '$1');

/** The words that what is typed may become. M3 is M03 before it is the beginning of M30. */
export function completions(words: readonly Word[], typed: string): Word[] {
  const begun = typed.toUpperCase();
  const found = words.filter(({ word }) => word.toUpperCase().startsWith(begun) || bare(word).startsWith(bare(begun)));
  return found.sort((a, b) => Number(bare(b.word) === bare(begun)) - Number(bare(a.word) === bare(begun)));
}
