// src/pages/diagnosis/csv.ts
/** A recording as columns. Cells that are no numbers are 0. */
function csv(text) {
	const rows = text.trim().split("\n").filter((row) => !row.startsWith("#"));
	const names = (rows[0] ?? "").split(",").map((name) => name.trim());
	const columns = names.map(() => []);
	for (const row of rows.slice(1)) {
		const cells = row.split(",");
		names.forEach((_, index) => columns[index].push(Number(cells[index]) || 0));
	}
	return {
		names,
		columns
	};
}
export { csv };
