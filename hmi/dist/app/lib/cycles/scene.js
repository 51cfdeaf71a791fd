import { distance } from "./geometry.js";
import { subject, toward } from "./items.js";
import { plan } from "./plan.js";
import { section } from "./section.js";
// src/lib/cycles/scene.ts
/** What a form looks like. */
function scene(form, request) {
	const of = subject(form, request);
	return {
		plan: plan(of),
		section: section(of)
	};
}
/** Every point of the items, for their box. */
function places(items) {
	return items.flatMap((item) => {
		switch (item.kind) {
			case "line":
			case "area": return item.points;
			case "measure": {
				const long = distance(item.from, item.to) || 1;
				const [nx, ny] = [-(item.to[1] - item.from[1]) / long, (item.to[0] - item.from[0]) / long];
				return [item.from, item.to].flatMap((p) => [p, [p[0] + nx * item.aside, p[1] + ny * item.aside]]);
			}
			case "angle": return [
				item.at,
				toward(item.at, item.from, item.radius),
				toward(item.at, item.to, item.radius)
			];
			default: return [item.at];
		}
	});
}
export { places, scene };
