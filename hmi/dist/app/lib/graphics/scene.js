import { MM, middle, segments, spanOf } from "./path.js";
import { BufferAttribute, BufferGeometry, Color, DynamicDrawUsage, Line, LineBasicMaterial, LineSegments, OrthographicCamera, Scene, ShaderMaterial, Vector3, WebGLRenderer } from "three";
// src/lib/graphics/scene.ts
/** Segments of the coarse form, and of a piece of the whole. */
var COARSE = 4e4;
var PIECE = 6e4;
/** ms without movement of the camera after which the whole is drawn. */
var SETTLED = 180;
/** ms from one picture of what is done to the next, at least. */
var LEAST = 200;
/** Angles of the camera, and whether the axes are exchanged: Y up, Z where X is. */
var LOOKS = {
	iso: [
		-.7,
		.6,
		false
	],
	top: [
		0,
		Math.PI / 2,
		false
	],
	front: [
		0,
		0,
		false
	],
	side: [
		Math.PI / 2,
		0,
		false
	],
	turned: [
		0,
		0,
		true
	],
	around: [
		-.7,
		.6,
		true
	]
};
var vertex = `
in float kind;
uniform float done;
uniform vec3 shadeDone, shadeCut, shadeArc, shadeRapid;
uniform float showRapid;
flat out vec4 shade;
out float height;
void main() {
  bool isDone = float(gl_VertexID) <= done;
  vec3 rgb = kind < 1.5 ? shadeRapid : kind < 2.5 ? shadeCut : shadeArc;
  // A jump is no move: its segment of the strip is left out.
  shade = vec4(isDone ? (kind < 1.5 ? shadeRapid : shadeDone) : rgb, kind < 0.5 ? 0.0 : kind < 1.5 ? 0.55 * showRapid : 1.0);
  height = position.z;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;
var fragment = `
flat in vec4 shade;
in float height;
uniform vec2 section;
out vec4 colour;
void main() {
  if (shade.a < 0.01 || height < section.x || height > section.y) discard;
  colour = shade;
}`;
var PathScene = class {
	canvas;
	camera = new OrthographicCamera(-1, 1, 1, -1, -1e4, 1e4);
	target = new Vector3();
	yaw = -.7;
	pitch = .6;
	/** Z is where X is else, X where Y is, Y up. */
	turned = false;
	/** mm that are seen in the smaller of width and height. */
	span = 200;
	/** ms that the last frame took to submit, and the segments of it: for who measures. */
	lastFrame = {
		ms: 0,
		segments: 0,
		whole: false
	};
	onview = () => void 0;
	#renderer;
	#scene = new Scene();
	#material;
	/** Of the trail, all of which is done. */
	#trailMaterial;
	#trail = null;
	/** All points as one strip, without an index: what is sent to the graphics is the server's answer as it came. */
	#whole = null;
	#coarse = null;
	#grid = null;
	#gridMaterial = new LineBasicMaterial();
	#path = null;
	#range = null;
	#framing = null;
	#total = 0;
	#at = 0;
	#moved = 0;
	#frame = 0;
	#slow = 0;
	#next = 0;
	#timer;
	#later;
	constructor(canvas) {
		this.canvas = canvas;
		this.#renderer = new WebGLRenderer({
			canvas,
			antialias: false,
			alpha: true,
			preserveDrawingBuffer: true,
			powerPreference: "high-performance"
		});
		this.#renderer.autoClear = false;
		this.#material = new ShaderMaterial({
			glslVersion: "300 es",
			vertexShader: vertex,
			fragmentShader: fragment,
			transparent: true,
			depthTest: false,
			uniforms: {
				done: { value: -1 },
				showRapid: { value: 1 },
				section: { value: [-1e9, 1e9] },
				shadeDone: { value: new Color() },
				shadeCut: { value: new Color() },
				shadeArc: { value: new Color() },
				shadeRapid: { value: new Color() }
			}
		});
		this.#trailMaterial = this.#material.clone();
		this.#trailMaterial.uniforms.done.value = 1e9;
	}
	/** Colours, as CSS has them. */
	shades(shades) {
		const { uniforms } = this.#material;
		uniforms.shadeDone.value.setStyle(shades.done, "");
		uniforms.shadeCut.value.setStyle(shades.cut, "");
		uniforms.shadeArc.value.setStyle(shades.arc, "");
		uniforms.shadeRapid.value.setStyle(shades.rapid, "");
		this.#trailMaterial.uniforms.shadeDone.value.setStyle(shades.trail, "");
		this.#gridMaterial.color.setStyle(shades.grid, "");
		this.#renderer.outputColorSpace = "srgb-linear";
		this.draw();
	}
	/** Another path. */
	load(path) {
		for (const old of [
			this.#whole,
			this.#coarse,
			this.#grid
		]) if (old) {
			this.#scene.remove(old);
			old.geometry.dispose();
		}
		this.#whole = this.#coarse = this.#grid = null;
		this.#path = path;
		this.#total = 0;
		if (path && path.count > 1) {
			const position = new BufferAttribute(path.points, 3);
			const kind = new BufferAttribute(path.kinds, 1);
			const geometry = () => {
				const made = new BufferGeometry();
				made.setAttribute("position", position);
				made.setAttribute("kind", kind);
				return made;
			};
			const show = (lines) => {
				lines.frustumCulled = false;
				this.#scene.add(lines);
				return lines;
			};
			this.#total = path.count - 1;
			this.#whole = show(new Line(geometry(), this.#material));
			if (this.#total > COARSE) this.#coarse = show(new LineSegments(geometry().setIndex(new BufferAttribute(this.#thinned(path), 1)), this.#material));
			this.#grid = this.#floor(path);
		}
		this.fit();
	}
	/** The coarse form; where ends of moves alone are more than it may have, of these so many are taken. */
	#thinned(path) {
		const thin = segments(path, Math.ceil(this.#total / COARSE) * 2);
		const every = Math.ceil(thin.length / 2 / (2 * COARSE));
		if (every <= 1) return thin;
		const some = new Uint32Array(2 * Math.floor(thin.length / 2 / every));
		for (let pair = 0; 2 * pair < some.length; pair++) {
			some[2 * pair] = thin[2 * pair * every];
			some[2 * pair + 1] = thin[2 * pair * every + 1];
		}
		return some;
	}
	#floor(path) {
		const [x0, y0, z0] = path.box.low;
		const [x1, y1] = path.box.high;
		const size = Math.max(x1 - x0, y1 - y0, 10);
		const step = 10 ** Math.floor(Math.log10(size / 4));
		const points = [];
		const from = (value) => Math.floor(value / step - 1) * step;
		const to = (value) => Math.ceil(value / step + 1) * step;
		for (let x = from(x0); x <= to(x1) + 1e-6; x += step) points.push(x, from(y0), z0, x, to(y1), z0);
		for (let y = from(y0); y <= to(y1) + 1e-6; y += step) points.push(from(x0), y, z0, to(x1), y, z0);
		const geometry = new BufferGeometry();
		geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
		const grid = new LineSegments(geometry, this.#gridMaterial);
		grid.renderOrder = -1;
		grid.frustumCulled = false;
		this.#scene.add(grid);
		return grid;
	}
	/** Looks at another range than the whole path, mm of the machine, or with a scale and centre that are set; null for the path
	again. */
	range(box, frame) {
		this.#range = box;
		this.#framing = frame;
		this.fit();
	}
	/** mm of the screen that its shorter side has. */
	get across() {
		return Math.min(this.canvas.clientWidth, this.canvas.clientHeight) * MM;
	}
	/** Looks at the whole path, at the range that is set, or as it is set. */
	fit() {
		const box = this.#range ?? this.#path?.box ?? this.#trail?.of.box;
		if (this.#framing) {
			this.target.set(...this.#framing.centre);
			this.span = Math.max(.01, this.across / this.#framing.scale);
		} else if (box) {
			this.target.set(...middle(box));
			this.span = spanOf(box);
		}
		this.moved();
	}
	look(view) {
		[this.yaw, this.pitch, this.turned] = LOOKS[view];
		this.moved();
	}
	/** Points up to this one are done. On a path that takes long to draw it is drawn now and then. */
	done(index) {
		const uniform = this.#material.uniforms.done;
		if (uniform.value === index) return;
		uniform.value = index;
		this.#soon();
	}
	/** The trail has grown, or is another one. */
	trail(of) {
		if (this.#trail?.of !== of) {
			this.#forget();
			const geometry = new BufferGeometry();
			geometry.setAttribute("position", new BufferAttribute(of.points, 3).setUsage(DynamicDrawUsage));
			geometry.setAttribute("kind", new BufferAttribute(of.kinds, 1).setUsage(DynamicDrawUsage));
			const line = new Line(geometry, this.#trailMaterial);
			line.frustumCulled = false;
			line.renderOrder = 1;
			this.#scene.add(line);
			this.#trail = {
				line,
				of,
				sent: -1
			};
			if (!this.#path && !this.#range && !this.#framing && of.box) {
				this.target.fromArray(of.points, 3 * (of.count - 1));
				this.span = Math.max(this.span, spanOf(of.box));
				this.moved();
			}
		}
		this.#soon();
	}
	#forget() {
		if (!this.#trail) return;
		this.#scene.remove(this.#trail.line);
		this.#trail.line.geometry.dispose();
		this.#trail = null;
	}
	/** Draws when the last picture is old enough. */
	#soon() {
		const wait = this.#next - performance.now();
		if (wait <= 0) this.draw();
		else this.#later ??= setTimeout(() => this.draw(), Math.min(wait, 1e3));
	}
	rapids(shown) {
		this.#material.uniforms.showRapid.value = shown ? 1 : 0;
		this.draw();
	}
	section(low, high) {
		for (const material of [this.#material, this.#trailMaterial]) material.uniforms.section.value = [low, high];
		this.draw();
	}
	size(width, height, ratio) {
		this.#renderer.setPixelRatio(ratio);
		this.#renderer.setSize(width, height, false);
		if (this.#framing) this.fit();
		else this.moved();
	}
	/** The camera moved. */
	moved() {
		this.#moved = performance.now();
		this.draw();
		clearTimeout(this.#timer);
		if (this.#coarse) this.#timer = setTimeout(() => this.draw(), 190);
		this.#place();
		this.onview();
	}
	/** Turns by angles, shifts by pixels. */
	turn(yaw, pitch) {
		this.yaw += yaw;
		this.pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.pitch + pitch));
		this.moved();
	}
	shift(x, y) {
		const scale = this.span / Math.min(this.canvas.clientWidth, this.canvas.clientHeight);
		const right = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
		const up = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
		this.target.addScaledVector(right, -x * scale).addScaledVector(up, y * scale);
		this.moved();
	}
	zoom(factor) {
		this.span = Math.max(.01, Math.min(1e6, this.span * factor));
		this.moved();
	}
	#place() {
		const width = this.canvas.clientWidth || 1;
		const height = this.canvas.clientHeight || 1;
		const half = this.span / 2;
		const [w, h] = width < height ? [half, half * height / width] : [half * width / height, half];
		Object.assign(this.camera, {
			left: -w,
			right: w,
			top: h,
			bottom: -h,
			near: -1e5,
			far: 1e5
		});
		const { yaw, pitch } = this;
		const place = (to, x, y, z) => this.turned ? to.set(y, z, x) : to.set(x, y, z);
		const away = place(new Vector3(), Math.sin(yaw) * Math.cos(pitch), -Math.cos(yaw) * Math.cos(pitch), Math.sin(pitch));
		place(this.camera.up, -Math.sin(yaw) * Math.sin(pitch), Math.cos(yaw) * Math.sin(pitch), Math.cos(pitch));
		this.camera.position.copy(this.target).add(away);
		this.camera.lookAt(this.target);
		this.camera.updateProjectionMatrix();
		this.camera.updateMatrixWorld();
	}
	/** Pixels of a point of the machine. */
	project(x, y, z) {
		const point = new Vector3(x, y, z).project(this.camera);
		return [(point.x + 1) / 2 * this.canvas.clientWidth, (1 - point.y) / 2 * this.canvas.clientHeight];
	}
	/** The point of the path nearest to a pixel; null where none is near. */
	pick(x, y, near = 14) {
		const path = this.#path;
		if (!path) return null;
		const m = this.camera.projectionMatrix.clone().multiply(this.camera.matrixWorldInverse).elements;
		const wide = this.canvas.clientWidth / 2;
		const high = this.canvas.clientHeight / 2;
		const [low, top] = this.#material.uniforms.section.value;
		const rapids = this.#material.uniforms.showRapid.value !== 0;
		let best = null;
		let least = near * near;
		for (let index = 0; index < path.count; index++) {
			const px = path.points[3 * index];
			const py = path.points[3 * index + 1];
			const pz = path.points[3 * index + 2];
			if (pz < low || pz > top) continue;
			if (!rapids && path.kinds[index] <= 1 && (path.kinds[index + 1] ?? 0) <= 1) continue;
			const dx = (m[0] * px + m[4] * py + m[8] * pz + m[12] + 1) * wide - x;
			const dy = (1 - (m[1] * px + m[5] * py + m[9] * pz + m[13])) * high - y;
			const distance = dx * dx + dy * dy;
			if (distance < least) {
				least = distance;
				best = index;
			}
		}
		return best;
	}
	/** Draws anew, soon. */
	draw() {
		clearTimeout(this.#later);
		this.#later = void 0;
		this.#at = 0;
		if (!this.#frame) this.#frame = requestAnimationFrame(() => this.#step());
	}
	#step() {
		this.#frame = 0;
		const start = performance.now();
		if (this.#at === 0) {
			this.#slow = start;
			this.#place();
		}
		const moving = this.#coarse !== null && start - this.#moved < SETTLED;
		let drawn = 0;
		if (this.#at === 0) this.#renderer.clear();
		if (this.#grid) this.#grid.visible = this.#at === 0;
		if (this.#trail) {
			const { line, of, sent } = this.#trail;
			line.visible = this.#at === 0 && of.count > 1;
			if (line.visible && sent !== of.changes) {
				line.geometry.setDrawRange(0, of.count);
				for (const part of ["position", "kind"]) line.geometry.getAttribute(part).needsUpdate = true;
				this.#trail.sent = of.changes;
			}
		}
		if (this.#coarse) this.#coarse.visible = moving;
		if (this.#whole) {
			this.#whole.visible = !moving;
			if (!moving) {
				const left = this.#total - this.#at;
				drawn = Math.min(left, PIECE);
				this.#whole.geometry.setDrawRange(this.#at, drawn + 1);
				this.#at += drawn;
			}
		}
		this.#renderer.render(this.#scene, this.camera);
		this.lastFrame = {
			ms: performance.now() - start,
			segments: drawn,
			whole: !moving && this.#at >= this.#total
		};
		if (!moving && this.#at > 0 && this.#at < this.#total) this.#frame = requestAnimationFrame(() => this.#step());
		else {
			this.#at = 0;
			this.#next = Infinity;
			requestAnimationFrame(() => requestAnimationFrame(() => {
				const took = performance.now() - this.#slow;
				this.#next = performance.now() + Math.max(LEAST, 10 * took);
			}));
		}
	}
	dispose() {
		cancelAnimationFrame(this.#frame);
		clearTimeout(this.#timer);
		clearTimeout(this.#later);
		this.load(null);
		this.#forget();
		cancelAnimationFrame(this.#frame);
		clearTimeout(this.#timer);
		this.#material.dispose();
		this.#trailMaterial.dispose();
		this.#gridMaterial.dispose();
		this.#renderer.dispose();
	}
};
export { PathScene };
