// src/lib/state/share.ts
/** `now`, with every part of it that equals that of `before` in the place of it; `before` itself where all is equal.
Changes `now`, which nobody else may have yet. */
function share(before, now) {
	if (before === now || typeof before !== "object" || typeof now !== "object" || before === null || now === null) return now;
	if (Array.isArray(before) !== Array.isArray(now)) return now;
	const [old, fresh] = [before, now];
	const keys = Object.keys(fresh);
	let isSame = keys.length === Object.keys(old).length;
	for (const key of keys) {
		const kept = share(old[key], fresh[key]);
		fresh[key] = kept;
		isSame &&= Object.is(kept, old[key]) && key in old;
	}
	return isSame ? before : now;
}
export { share };
