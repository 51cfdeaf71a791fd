// src/pages/diagnosis/recording.ts
/** Rows that one answer may have: the server gives fewer where they would be too long. */
var MOST = 4e3;
/** Rows of an answer; the line of the names is not one of them. */
function rowsOf(csv) {
	return csv.split("\n").filter((row) => row !== "");
}
/** Waits until all samples are there, then reads them. Nothing where `wait` says that nobody wants it any more. */
async function recorded(ask, wait) {
	while (!(await ask(0, 0)).done) if (!await wait()) return null;
	const first = await ask(0, MOST);
	const [head = "t", ...rows] = rowsOf(first.csv);
	while (rows.length < first.samples) {
		const more = rowsOf((await ask(rows.length, MOST)).csv);
		if (more.length === 0) return null;
		rows.push(...more);
	}
	const names = head.split(",").slice(1);
	const times = [];
	const lines = names.map(() => []);
	for (const row of rows) {
		const cells = row.split(",");
		times.push(Number(cells[0]));
		for (let index = 0; index < names.length; index++) lines[index].push(Number(cells[index + 1]));
	}
	return {
		names,
		times,
		lines
	};
}
export { recorded };
