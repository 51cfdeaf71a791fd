// src/lib/ladder/layout.ts
var CELL = {
	width: 118,
	height: 58
};
function size(node) {
	if (node.kind === "contact") return {
		columns: 1,
		rows: 1
	};
	const sizes = node.parts.map(size);
	return node.kind === "series" ? {
		columns: sizes.reduce((sum, one) => sum + one.columns, 0),
		rows: Math.max(...sizes.map((one) => one.rows))
	} : {
		columns: Math.max(...sizes.map((one) => one.columns)),
		rows: sizes.reduce((sum, one) => sum + one.rows, 0)
	};
}
/** Lays a rung out. `conducts` says whether a contact lets power through, `power` whether it flows behind an
instruction. */
function layout(rung, conducts, power) {
	const drawn = {
		contacts: [],
		outputs: [],
		wires: [],
		width: 0,
		height: 0
	};
	const { width: w, height: h } = CELL;
	const wire = (x1, y1, x2, y2, on) => {
		if (x1 !== x2 || y1 !== y2) drawn.wires.push({
			x1,
			y1,
			x2,
			y2,
			on
		});
	};
	const middle = (row) => row * h + h / 2;
	/** Draws a node from a column and row on; gives whether power leaves it. */
	const place = (node, column, row, wide, fed) => {
		if (node.kind === "contact") {
			const passes = conducts(node);
			const on = fed && passes;
			drawn.contacts.push({
				contact: node,
				x: column * w,
				y: middle(row),
				on,
				conducts: passes
			});
			wire((column + 1) * w, middle(row), (column + wide) * w, middle(row), on);
			return on;
		}
		if (node.kind === "series") {
			let at = column;
			let on = fed;
			node.parts.forEach((part, index) => {
				const own = index === node.parts.length - 1 ? column + wide - at : size(part).columns;
				on = place(part, at, row, own, on);
				at += own;
			});
			return on;
		}
		let at = row;
		let any = false;
		const rows = [];
		for (const part of node.parts) {
			const on = place(part, column, at, wide, fed);
			any ||= on;
			rows.push(at);
			at += size(part).rows;
		}
		const last = rows.at(-1) ?? row;
		wire(column * w, middle(row), column * w, middle(last), fed);
		wire((column + wide) * w, middle(row), (column + wide) * w, middle(last), any);
		return any;
	};
	let row = 0;
	let columns = 1;
	const ends = [];
	for (const condition of rung.conditions) columns = Math.max(columns, size(condition).columns);
	for (const condition of rung.conditions) {
		const on = place(condition, 0, row, columns, true);
		ends.push({
			row,
			on
		});
		row += size(condition).rows;
	}
	if (ends.length === 0) {
		ends.push({
			row: 0,
			on: true
		});
		wire(0, middle(0), columns * w, middle(0), true);
		row = 1;
	}
	const x = columns * w;
	const fed = ends.at(-1).on;
	let at = 0;
	for (const output of rung.outputs) {
		const on = power(output.index);
		drawn.outputs.push({
			output,
			x,
			y: middle(at),
			on: output.kind === "function" ? fed : on
		});
		at += 1;
	}
	if (rung.outputs.length > 1) wire(x, middle(0), x, middle(rung.outputs.length - 1), fed);
	for (const end of ends.slice(1)) wire(x, middle(end.row), x + 12, middle(end.row), end.on);
	drawn.width = x + 230;
	drawn.height = Math.max(row, rung.outputs.length) * h;
	return drawn;
}
export { CELL, layout };
