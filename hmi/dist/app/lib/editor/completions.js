// src/lib/editor/completions.ts
/** A code without the zeros that it may be written with. */
var bare = (word) => word.toUpperCase().replace(/^([GM])0+(?=\d)/, "$1");
/** The words that what is typed may become. M3 is M03 before it is the beginning of M30. */
function completions(words, typed) {
	const begun = typed.toUpperCase();
	return words.filter(({ word }) => word.toUpperCase().startsWith(begun) || bare(word).startsWith(bare(begun))).sort((a, b) => Number(bare(b.word) === bare(begun)) - Number(bare(a.word) === bare(begun)));
}
export { completions };
