// src/lib/measuring.ts
/** The edge of a work that was touched by a round tool: the tool's centre, moved by its radius towards the work.
`from` says from where it was touched: from below (the tool stands at the smaller coordinate) or from above. */
function edge(touched, radius, from) {
	return touched + (from === "below" ? radius : -radius);
}
/** The middle of two touches, and how far they are apart with and without the tool's diameter. */
function middle(a, b, radius) {
	const apart = Math.abs(a - b);
	return {
		centre: (a + b) / 2,
		inner: apart + 2 * radius,
		outer: apart - 2 * radius
	};
}
/** The zero of a system, machine positions: what was found has the coordinate there. The control adds the external zero to
each zero that is stored, so that it is taken off here. */
function zeroAt(found, coordinate, external) {
	return Object.fromEntries(Object.entries(found).map(([axis, place]) => [axis, place - coordinate - (external[axis] ?? 0)]));
}
/** The work coordinate systems that a zero can be measured for: G54 to G59, and the additional ones. */
var SYSTEMS = [
	"G54",
	"G55",
	"G56",
	"G57",
	"G58",
	"G59",
	...Array.from({ length: 50 }, (_, index) => `G54 P${index + 1}`)
];
export { SYSTEMS, edge, middle, zeroAt };
