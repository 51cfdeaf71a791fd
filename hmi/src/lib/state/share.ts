// What is told again and again, made of what was there: a part that is as it was is the same object as before, so that
// nothing that shows it looks at it anew.

/** `now`, with every part of it that equals that of `before` in the place of it; `before` itself where all is equal.
    Changes `now`, which nobody else may have yet. */
export function share<Value>(before: unknown, now: Value): Value {
  if (before === now || typeof before !== 'object' || typeof now !== 'object' || before === null || now === null) return now;
  if (Array.isArray(before) !== Array.isArray(now)) return now;
  const [old, fresh] = [before as Record<string, unknown>, now as Record<string, unknown>];
  const keys = Object.keys(fresh);
  let isSame = keys.length === Object.keys(old).length;
  for (const key of keys) {
    const kept = share(old[key], fresh[key]);
    fresh[key] = kept;
    isSame &&= Object.is(kept, old[key]) && key in old;
  }
  return isSame ? (before as Value) : now;
}
