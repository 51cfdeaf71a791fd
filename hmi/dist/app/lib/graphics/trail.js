// src/lib/graphics/trail.ts
/** Points that are kept; the oldest half goes when they are full. */
var MOST = 2e4;
/** mm that a point may lie beside the line drawn in its place. */
var BESIDE = .005;
var Trail = class {
	points = new Float32Array(3 * MOST);
	/** 0 where a stroke begins, 2 for the line that ends here: as the points of a path (`path.ts`). */
	kinds = new Uint8Array(MOST);
	count = 0;
	/** Counts up with each change. */
	changes = 0;
	/** The last point of a stroke still moves on in the direction in which it left the point before it. */
	#way = null;
	#isUp = true;
	/** The tool is here. Whether there is something new to draw. */
	add(x, y, z) {
		if (this.#isUp) {
			if (this.count > 0 && this.kinds[this.count - 1] === 0) this.count -= 1;
			this.#push(x, y, z, 0);
			this.#isUp = false;
			this.#way = null;
			return false;
		}
		const last = 3 * (this.count - 1);
		const { points } = this;
		const from = this.#way ? last - 3 : last;
		const [dx, dy, dz] = [
			x - points[from],
			y - points[from + 1],
			z - points[from + 2]
		];
		if (Math.hypot(x - points[last], y - points[last + 1], z - points[last + 2]) < BESIDE) return false;
		if (this.#way) {
			const [ux, uy, uz] = this.#way;
			const along = dx * ux + dy * uy + dz * uz;
			if (along >= (points[last] - points[from]) * ux + (points[last + 1] - points[from + 1]) * uy + (points[last + 2] - points[from + 2]) * uz && Math.hypot(dx - along * ux, dy - along * uy, dz - along * uz) < BESIDE) {
				points.set([
					x,
					y,
					z
				], last);
				this.changes += 1;
				return true;
			}
		}
		const [ax, ay, az] = [
			x - points[last],
			y - points[last + 1],
			z - points[last + 2]
		];
		const length = Math.hypot(ax, ay, az);
		this.#way = [
			ax / length,
			ay / length,
			az / length
		];
		this.#push(x, y, z, 2);
		return true;
	}
	/** What comes next begins elsewhere. */
	lift() {
		this.#isUp = true;
	}
	clear() {
		this.count = 0;
		this.changes += 1;
		this.#isUp = true;
		this.#way = null;
	}
	/** The space it takes, mm of the machine; null where there is none. */
	get box() {
		if (this.count < 2) return null;
		const [low, high] = [[
			Infinity,
			Infinity,
			Infinity
		], [
			-Infinity,
			-Infinity,
			-Infinity
		]];
		for (let at = 0; at < 3 * this.count; at++) {
			const value = this.points[at];
			const axis = at % 3;
			low[axis] = Math.min(low[axis], value);
			high[axis] = Math.max(high[axis], value);
		}
		return {
			low,
			high
		};
	}
	#push(x, y, z, kind) {
		if (this.count === MOST) {
			const half = MOST / 2;
			this.points.copyWithin(0, 3 * half);
			this.kinds.copyWithin(0, half);
			this.count = half;
			this.kinds[0] = 0;
		}
		this.points.set([
			x,
			y,
			z
		], 3 * this.count);
		this.kinds[this.count] = kind;
		this.count += 1;
		this.changes += 1;
	}
};
export { Trail };
