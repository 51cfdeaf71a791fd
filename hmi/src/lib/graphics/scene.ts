// The path on a canvas of its own, drawn only when camera, data or what is done change. While the camera moves a coarse
// form is drawn; the whole follows in pieces, a piece a frame, so that no frame holds up the hand that turns it.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DynamicDrawUsage,
  Line,
  LineBasicMaterial,
  LineSegments,
  OrthographicCamera,
  Scene,
  ShaderMaterial,
  Vector3,
  WebGLRenderer,
} from 'three';
import { middle, MM, segments, spanOf, type Frame, type Path } from './path';
import type { Trail } from './trail';

/** Segments of the coarse form, and of a piece of the whole. */
const COARSE = 40_000;
const PIECE = 60_000;
/** ms without movement of the camera after which the whole is drawn. */
const SETTLED = 180;
/** ms from one picture of what is done to the next, at least. */
const LEAST = 200;

/** The six views of the machine (GSK990MC part 2, 3.5; as a Fanuc 0i calls them): XYZ, XY, XZ, YZ, ZY, ZXY. */
export type View = 'iso' | 'top' | 'front' | 'side' | 'turned' | 'around';

/** Angles of the camera, and whether the axes are exchanged: Y up, Z where X is. */
const LOOKS: Record<View, [yaw: number, pitch: number, turned: boolean]> = {
  iso: [-0.7, 0.6, false],
  top: [0, Math.PI / 2, false],
  front: [0, 0, false],
  side: [Math.PI / 2, 0, false],
  turned: [0, 0, true],
  around: [-0.7, 0.6, true],
};
export type Shades = { done: string; cut: string; arc: string; rapid: string; grid: string; trail: string };

const vertex = /* glsl */ `
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
const fragment = /* glsl */ `
flat in vec4 shade;
in float height;
uniform vec2 section;
out vec4 colour;
void main() {
  if (shade.a < 0.01 || height < section.x || height > section.y) discard;
  colour = shade;
}`;

export class PathScene {
  readonly camera = new OrthographicCamera(-1, 1, 1, -1, -10_000, 10_000);
  readonly target = new Vector3();
  yaw = -0.7;
  pitch = 0.6;
  /** Z is where X is else, X where Y is, Y up. */
  turned = false;
  /** mm that are seen in the smaller of width and height. */
  span = 200;
  /** ms that the last frame took to submit, and the segments of it: for who measures. */
  lastFrame = { ms: 0, segments: 0, whole: false };
  onview: () => void = () => undefined;

  #renderer: WebGLRenderer;
  #scene = new Scene();
  #material: ShaderMaterial;
  /** Of the trail, all of which is done. */
  #trailMaterial: ShaderMaterial;
  #trail: { line: Line; of: Trail; sent: number } | null = null;
  /** All points as one strip, without an index: what is sent to the graphics is the server's answer as it came. */
  #whole: Line | null = null;
  #coarse: LineSegments | null = null;
  #grid: LineSegments | null = null;
  #gridMaterial = new LineBasicMaterial();
  #path: Path | null = null;
  #range: Path['box'] | null = null;
  #framing: Frame | null = null;
  #total = 0;
  #at = 0;
  #moved = 0;
  #frame = 0;
  #slow = 0;
  #next = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #later: ReturnType<typeof setTimeout> | undefined;

  constructor(readonly canvas: HTMLCanvasElement) {
    this.#renderer = new WebGLRenderer({ canvas, antialias: false, alpha: true, preserveDrawingBuffer: true, powerPreference: 'high-performance' });
    this.#renderer.autoClear = false;
    this.#material = new ShaderMaterial({
      glslVersion: '300 es',
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
        shadeRapid: { value: new Color() },
      },
    });
    this.#trailMaterial = this.#material.clone();
    this.#trailMaterial.uniforms.done!.value = 1e9;
  }

  /** Colours, as CSS has them. */
  shades(shades: Shades): void {
    const { uniforms } = this.#material;
    uniforms.shadeDone!.value.setStyle(shades.done, '');
    uniforms.shadeCut!.value.setStyle(shades.cut, '');
    uniforms.shadeArc!.value.setStyle(shades.arc, '');
    uniforms.shadeRapid!.value.setStyle(shades.rapid, '');
    this.#trailMaterial.uniforms.shadeDone!.value.setStyle(shades.trail, '');
    this.#gridMaterial.color.setStyle(shades.grid, '');
    this.#renderer.outputColorSpace = 'srgb-linear';
    this.draw();
  }

  /** Another path. */
  load(path: Path | null): void {
    for (const old of [this.#whole, this.#coarse, this.#grid]) {
      if (old) {
        this.#scene.remove(old);
        old.geometry.dispose();
      }
    }
    this.#whole = this.#coarse = this.#grid = null;
    this.#path = path;
    this.#total = 0;
    if (path && path.count > 1) {
      const position = new BufferAttribute(path.points, 3);
      const kind = new BufferAttribute(path.kinds, 1);
      const geometry = () => {
        const made = new BufferGeometry();
        made.setAttribute('position', position);
        made.setAttribute('kind', kind);
        return made;
      };
      const show = <Lines extends Line>(lines: Lines): Lines => {
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
  #thinned(path: Path): Uint32Array {
    const thin = segments(path, Math.ceil(this.#total / COARSE) * 2);
    const every = Math.ceil(thin.length / 2 / (2 * COARSE));
    if (every <= 1) return thin;
    const some = new Uint32Array(2 * Math.floor(thin.length / 2 / every));
    for (let pair = 0; 2 * pair < some.length; pair++) {
      some[2 * pair] = thin[2 * pair * every]!;
      some[2 * pair + 1] = thin[2 * pair * every + 1]!;
    }
    return some;
  }

  #floor(path: Path): LineSegments {
    const [x0, y0, z0] = path.box.low;
    const [x1, y1] = path.box.high;
    const size = Math.max(x1 - x0, y1 - y0, 10);
    const step = 10 ** Math.floor(Math.log10(size / 4));
    const points: number[] = [];
    const from = (value: number) => Math.floor(value / step - 1) * step;
    const to = (value: number) => Math.ceil(value / step + 1) * step;
    for (let x = from(x0); x <= to(x1) + 1e-6; x += step) points.push(x, from(y0), z0, x, to(y1), z0);
    for (let y = from(y0); y <= to(y1) + 1e-6; y += step) points.push(from(x0), y, z0, to(x1), y, z0);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(points), 3));
    const grid = new LineSegments(geometry, this.#gridMaterial);
    grid.renderOrder = -1;
    grid.frustumCulled = false;
    this.#scene.add(grid);
    return grid;
  }

  /** Looks at another range than the whole path, mm of the machine, or with a scale and centre that are set; null for the path
      again. */
  range(box: Path['box'] | null, frame: Frame | null): void {
    this.#range = box;
    this.#framing = frame;
    this.fit();
  }

  /** mm of the screen that its shorter side has. */
  get across(): number {
    return Math.min(this.canvas.clientWidth, this.canvas.clientHeight) * MM;
  }

  /** Looks at the whole path, at the range that is set, or as it is set. */
  fit(): void {
    const box = this.#range ?? this.#path?.box ?? this.#trail?.of.box;
    if (this.#framing) {
      this.target.set(...this.#framing.centre);
      this.span = Math.max(0.01, this.across / this.#framing.scale);
    } else if (box) {
      this.target.set(...middle(box));
      this.span = spanOf(box);
    }
    this.moved();
  }

  look(view: View): void {
    [this.yaw, this.pitch, this.turned] = LOOKS[view];
    this.moved();
  }

  /** Points up to this one are done. On a path that takes long to draw it is drawn now and then. */
  done(index: number): void {
    const uniform = this.#material.uniforms.done!;
    if (uniform.value === index) return;
    uniform.value = index;
    this.#soon();
  }

  /** The trail has grown, or is another one. */
  trail(of: Trail): void {
    if (this.#trail?.of !== of) {
      this.#forget();
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(of.points, 3).setUsage(DynamicDrawUsage));
      geometry.setAttribute('kind', new BufferAttribute(of.kinds, 1).setUsage(DynamicDrawUsage));
      const line = new Line(geometry, this.#trailMaterial);
      line.frustumCulled = false;
      line.renderOrder = 1;
      this.#scene.add(line);
      this.#trail = { line, of, sent: -1 };
      // Without a path there is nothing else to look at.
      if (!this.#path && !this.#range && !this.#framing && of.box) {
        this.target.fromArray(of.points, 3 * (of.count - 1));
        this.span = Math.max(this.span, spanOf(of.box));
        this.moved();
      }
    }
    this.#soon();
  }

  #forget(): void {
    if (!this.#trail) return;
    this.#scene.remove(this.#trail.line);
    this.#trail.line.geometry.dispose();
    this.#trail = null;
  }

  /** Draws when the last picture is old enough. */
  #soon(): void {
    const wait = this.#next - performance.now();
    if (wait <= 0) this.draw();
    else this.#later ??= setTimeout(() => this.draw(), Math.min(wait, 1000));
  }

  rapids(shown: boolean): void {
    this.#material.uniforms.showRapid!.value = shown ? 1 : 0;
    this.draw();
  }

  section(low: number, high: number): void {
    for (const material of [this.#material, this.#trailMaterial]) material.uniforms.section!.value = [low, high];
    this.draw();
  }

  size(width: number, height: number, ratio: number): void {
    this.#renderer.setPixelRatio(ratio);
    this.#renderer.setSize(width, height, false);
    // How much is seen at a scale that is set depends on the size.
    if (this.#framing) this.fit();
    else this.moved();
  }

  /** The camera moved. */
  moved(): void {
    this.#moved = performance.now();
    this.draw();
    clearTimeout(this.#timer);
    if (this.#coarse) this.#timer = setTimeout(() => this.draw(), SETTLED + 10);
    // Who draws over the path asks at once where its points are now.
    this.#place();
    this.onview();
  }

  /** Turns by angles, shifts by pixels. */
  turn(yaw: number, pitch: number): void {
    this.yaw += yaw;
    this.pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.pitch + pitch));
    this.moved();
  }
  shift(x: number, y: number): void {
    const scale = this.span / Math.min(this.canvas.clientWidth, this.canvas.clientHeight);
    const right = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    this.target.addScaledVector(right, -x * scale).addScaledVector(up, y * scale);
    this.moved();
  }
  zoom(factor: number): void {
    this.span = Math.max(0.01, Math.min(1e6, this.span * factor));
    this.moved();
  }

  #place(): void {
    const width = this.canvas.clientWidth || 1;
    const height = this.canvas.clientHeight || 1;
    const half = this.span / 2;
    const [w, h] = width < height ? [half, (half * height) / width] : [(half * width) / height, half];
    Object.assign(this.camera, { left: -w, right: w, top: h, bottom: -h, near: -1e5, far: 1e5 });
    const { yaw, pitch } = this;
    const place = (to: Vector3, x: number, y: number, z: number) => (this.turned ? to.set(y, z, x) : to.set(x, y, z));
    const away = place(new Vector3(), Math.sin(yaw) * Math.cos(pitch), -Math.cos(yaw) * Math.cos(pitch), Math.sin(pitch));
    place(this.camera.up, -Math.sin(yaw) * Math.sin(pitch), Math.cos(yaw) * Math.sin(pitch), Math.cos(pitch));
    this.camera.position.copy(this.target).add(away);
    this.camera.lookAt(this.target);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }

  /** Pixels of a point of the machine. */
  project(x: number, y: number, z: number): [number, number] {
    const point = new Vector3(x, y, z).project(this.camera);
    return [((point.x + 1) / 2) * this.canvas.clientWidth, ((1 - point.y) / 2) * this.canvas.clientHeight];
  }

  /** The point of the path nearest to a pixel; null where none is near. */
  pick(x: number, y: number, near = 14): number | null {
    const path = this.#path;
    if (!path) return null;
    const m = this.camera.projectionMatrix.clone().multiply(this.camera.matrixWorldInverse).elements;
    const wide = this.canvas.clientWidth / 2;
    const high = this.canvas.clientHeight / 2;
    const [low, top] = this.#material.uniforms.section!.value as [number, number];
    const rapids = this.#material.uniforms.showRapid!.value !== 0;
    let best: number | null = null;
    let least = near * near;
    for (let index = 0; index < path.count; index++) {
      const px = path.points[3 * index]!;
      const py = path.points[3 * index + 1]!;
      const pz = path.points[3 * index + 2]!;
      if (pz < low || pz > top) continue;
      // Between rapids that are hidden.
      if (!rapids && path.kinds[index]! <= 1 && (path.kinds[index + 1] ?? 0) <= 1) continue;
      const dx = (m[0]! * px + m[4]! * py + m[8]! * pz + m[12]! + 1) * wide - x;
      const dy = (1 - (m[1]! * px + m[5]! * py + m[9]! * pz + m[13]!)) * high - y;
      const distance = dx * dx + dy * dy;
      if (distance < least) {
        least = distance;
        best = index;
      }
    }
    return best;
  }

  /** Draws anew, soon. */
  draw(): void {
    clearTimeout(this.#later);
    this.#later = undefined;
    this.#at = 0;
    if (!this.#frame) this.#frame = requestAnimationFrame(() => this.#step());
  }

  #step(): void {
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
        for (const part of ['position', 'kind']) line.geometry.getAttribute(part).needsUpdate = true;
        this.#trail.sent = of.changes;
      }
    }
    if (this.#coarse) this.#coarse.visible = moving;
    if (this.#whole) {
      this.#whole.visible = !moving;
      if (!moving) {
        const left = this.#total - this.#at;
        drawn = Math.min(left, PIECE);
        // A strip of so many segments has a point more.
        this.#whole.geometry.setDrawRange(this.#at, drawn + 1);
        this.#at += drawn;
      }
    }
    this.#renderer.render(this.#scene, this.camera);
    this.lastFrame = { ms: performance.now() - start, segments: drawn, whole: !moving && this.#at >= this.#total };
    if (!moving && this.#at > 0 && this.#at < this.#total) {
      this.#frame = requestAnimationFrame(() => this.#step());
    } else {
      this.#at = 0;
      // What is done is drawn for a tenth of the time at most. How long a picture takes is known when the browser is
      // ready for the next one.
      this.#next = Infinity;
      requestAnimationFrame(() =>
        requestAnimationFrame(() => {
          const took = performance.now() - this.#slow;
          this.#next = performance.now() + Math.max(LEAST, 10 * took);
        }),
      );
    }
  }

  dispose(): void {
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
}
