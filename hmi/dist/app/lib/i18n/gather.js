// src/lib/i18n/gather.ts
/** One catalogue of many: the keys of `./PAGE.json` get `PAGE.` before them. */
function gather(files) {
	const all = {};
	for (const [path, catalogue] of Object.entries(files)) {
		const page = path.slice(2, -5);
		for (const [key, value] of Object.entries(catalogue)) all[`${page}.${key}`] = value;
	}
	return all;
}
export { gather };
