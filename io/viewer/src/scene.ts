// The blocks in WebGL: cells coloured by a number at their corners, and layers of lines over them.
import {
  BufferAttribute, BufferGeometry, ColorManagement, DataTexture, FloatType, GLSL3, LinearFilter, Mesh as Drawn, OrthographicCamera, RawShaderMaterial,
  RGBAFormat, Scene as Stage3, UnsignedByteType, Vector4, WebGLRenderer,
} from "three";
import { table, type Rgb } from "./colours";
import type { Field } from "./fields";
import { cell_areas, outline, triangles } from "./geometry";
import type { Mesh } from "./source";

/// What is seen: the middle [m] and pixels (CSS) a metre.
export interface View {
  x: number;
  y: number;
  scale: number;
}

const LEAST_BLOCK = 7; // [CSS pixels] across a block of mean size: outlines of smaller ones hide what they enclose
const MANY = 3000; // blocks
const CULLED = 5000; // lines above which only those in view are drawn
const LINE_ROW = 1024; // lines in a row of their textures
const CELL_VERTEX = `precision highp float;
in vec2 position; in float value; in float held;
uniform vec4 view;  // middle, factors to clip space
out float v_value; out float v_held;
void main() { v_value = value; v_held = held; gl_Position = vec4((position - view.xy) * view.zw, 0.0, 1.0); }`;
const CELL_FRAGMENT = `precision highp float;
in float v_value; in float v_held;
uniform vec2 range; uniform sampler2D colours; uniform float names; uniform vec3 ground; uniform vec3 hatch; uniform float pixel;
out vec4 colour;
void main() {
  if (v_held > 0.5) {
    float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 9.0 * pixel);
    colour = vec4(stripe < 1.2 * pixel ? hatch : ground, 1.0);
    return;
  }
  if (v_value > 1e38) {  // NO_VALUE
    colour = vec4(ground, 1.0);
    return;
  }
  float x = names > 0.5 ? (mod(floor(v_value + 0.5), names) + 0.5) / 256.0
                        : (0.5 + 255.0 * clamp((v_value - range.x) / (range.y - range.x), 0.0, 1.0)) / 256.0;
  colour = vec4(texture(colours, vec2(x, 0.5)).rgb, 1.0);
}`;
// A line is a rectangle whose ends and colour stand in textures: its corner is 0 or 1 along it, -1 or 1 across it. (Instances would be as short, but
// software renderers draw each one by itself: 60,000 outlines took 1.3 s.)
const LINE_VERTEX = `precision highp float;
uniform vec4 view; uniform vec2 size; uniform float width; uniform sampler2D ends; uniform sampler2D tint;
out vec3 v_tint;
void main() {
  int line = gl_VertexID / 4, corner = gl_VertexID % 4;
  ivec2 at = ivec2(line % ${LINE_ROW}, line / ${LINE_ROW});
  vec4 here = texelFetch(ends, at, 0);
  vec2 position = vec2(corner == 1 || corner == 2 ? 1.0 : 0.0, corner < 2 ? -1.0 : 1.0);
  vec2 a = (here.xy - view.xy) * view.zw, b = (here.zw - view.xy) * view.zw;
  vec2 along = (b - a) * size;
  float length_ = max(length(along), 1e-6);
  vec2 across = vec2(-along.y, along.x) / length_;
  vec2 cap = along / length_ * (position.x - 0.5) * width;
  gl_Position = vec4(mix(a, b, position.x) + (across * position.y * width + cap) / size, 0.0, 1.0);
  v_tint = texelFetch(tint, at, 0).rgb;
}`;
const LINE_FRAGMENT = `precision highp float;
in vec3 v_tint; uniform float opacity; uniform vec4 over; out vec4 colour;
void main() { colour = vec4(mix(v_tint, over.rgb, over.a), opacity); }`;

export const LAYERS = ["original", "joints", "outline", "crosses", "water", "slip", "contacts", "bolts", "supports", "monitors", "chosen", "contact"] as const;
export type Layer = (typeof LAYERS)[number];
const WIDTH: Record<Layer, number> = {
  original: 1, joints: 1.4, outline: 1, crosses: 1.2, water: 2, slip: 4, contacts: 2, bolts: 3, supports: 1.6, monitors: 2, chosen: 3, contact: 2.4,
}; // [CSS pixels]
const OPACITY: Record<Layer, number> = {
  original: 0.55, joints: 0.9, outline: 0.8, crosses: 0.95, water: 1, slip: 1, contacts: 1, bolts: 1, supports: 1, monitors: 1, chosen: 1, contact: 1,
};

// These read on any colour: they have a light seam.
const SEAMED = new Set<Layer>(["crosses", "water", "slip", "contacts", "bolts", "supports", "monitors", "contact"]);

/// Many straight lines of one width.
class Lines {
  readonly drawn: Drawn[]; // the seam first
  private readonly geometry = new BufferGeometry();
  private readonly ends = { value: Lines.texture(new Float32Array(4 * LINE_ROW), FloatType) };
  private readonly tint = { value: Lines.texture(new Uint8Array(4 * LINE_ROW), UnsignedByteType) };
  private room = 0; // lines that the textures hold

  constructor(view: Vector4, size: { value: [number, number] }, width: number, opacity: number, seamed: boolean) {
    const of = (pixels: number, covered: number, over: number[]) => {
      const material = new RawShaderMaterial({
        glslVersion: GLSL3, vertexShader: LINE_VERTEX, fragmentShader: LINE_FRAGMENT, transparent: true, depthTest: false, depthWrite: false, side: 2,
        uniforms: {
          view: { value: view }, size, width: { value: pixels }, opacity: { value: covered }, over: { value: over }, ends: this.ends, tint: this.tint,
        },
      });
      const drawn = new Drawn(this.geometry, material);
      drawn.frustumCulled = false;
      return drawn;
    };
    this.drawn = [...(seamed ? [of(width + 2.4, 0.8, [1, 1, 1, 1])] : []), of(width, opacity, [0, 0, 0, 0])];
    this.set(new Float32Array(0), new Uint8Array(0));
  }

  private static texture(data: Float32Array | Uint8Array, type: typeof FloatType | typeof UnsignedByteType): DataTexture {
    return new DataTexture(data as Float32Array<ArrayBuffer>, LINE_ROW, data.length / (4 * LINE_ROW), RGBAFormat, type);
  }

  /// Lines of one colour, of which only those that may be seen are handed over as the picture is drawn.
  keep(ends: Float32Array, colour: Rgb): void {
    this.kept = { ends, colour };
    this.dirty = true;
  }
  private kept: { ends: Float32Array; colour: Rgb } | null = null;
  private dirty = false;
  private seen = ""; // the window of the last cull
  private part = new Float32Array(0);
  private part_tint = new Uint8Array(0);

  /// @param hidden  they would be too dense to see   @param x0,y0,x1,y1  what is in view [m]
  cull(hidden: boolean, x0: number, y0: number, x1: number, y1: number): void {
    if (!this.kept || !this.shown) return;
    const { ends, colour } = this.kept;
    const all = ends.length / 4 <= CULLED;
    const window = hidden ? "none" : all ? "all" : `${x0} ${y0} ${x1} ${y1}`;
    if (!this.dirty && window === this.seen) return;
    this.dirty = false;
    this.seen = window;
    if (this.part.length < ends.length) {
      this.part = new Float32Array(ends.length);
      this.part_tint = new Uint8Array((3 * ends.length) / 4);
    }
    let count = 0;
    for (let i = 0; i < ends.length && !hidden; i += 4) {
      const [ax, ay, bx, by] = [ends[i]!, ends[i + 1]!, ends[i + 2]!, ends[i + 3]!];
      if (!all && ((ax < x0 && bx < x0) || (ax > x1 && bx > x1) || (ay < y0 && by < y0) || (ay > y1 && by > y1))) continue;
      this.part[4 * count] = ax;
      this.part[4 * count + 1] = ay;
      this.part[4 * count + 2] = bx;
      this.part[4 * count + 3] = by;
      count += 1;
    }
    for (let i = 0; i < 3 * count; ++i) this.part_tint[i] = colour[i % 3]!;
    this.set(this.part.subarray(0, 4 * count), this.part_tint.subarray(0, 3 * count));
  }

  /// @param ends  x0, y0, x1, y1 a line   @param tint  r, g, b a line
  set(ends: Float32Array, tint: Uint8Array): void {
    const lines = ends.length / 4;
    if (lines > this.room) this.grow(lines);
    (this.ends.value.image.data as unknown as Float32Array).set(ends);
    const colours = this.tint.value.image.data as Uint8Array;
    let same = true;
    for (let i = 0; i < lines; ++i)
      for (let k = 0; k < 3; ++k) {
        same = same && colours[4 * i + k] === tint[3 * i + k];
        colours[4 * i + k] = tint[3 * i + k]!;
      }
    if (lines > 0) this.ends.value.needsUpdate = true;
    if (!same) this.tint.value.needsUpdate = true;
    this.geometry.setDrawRange(0, 6 * lines);
    this.empty = lines === 0;
    this.show(this.shown);
  }

  private grow(lines: number): void {
    const rows = Math.ceil((1.2 * lines) / LINE_ROW);
    this.room = rows * LINE_ROW;
    this.ends.value.dispose();
    this.tint.value.dispose();
    this.ends.value = Lines.texture(new Float32Array(4 * this.room), FloatType);
    this.tint.value = Lines.texture(new Uint8Array(4 * this.room), UnsignedByteType);
    this.ends.value.needsUpdate = this.tint.value.needsUpdate = true;
    const index = new Uint32Array(6 * this.room);
    for (let line = 0; line < this.room; ++line) [0, 1, 2, 0, 2, 3].forEach((corner, k) => (index[6 * line + k] = 4 * line + corner));
    this.geometry.dispose();
    this.geometry.setIndex(new BufferAttribute(index, 1));
  }

  private empty = true;
  private shown = true;
  show(on: boolean): void {
    this.shown = on;
    for (const drawn of this.drawn) drawn.visible = on && !this.empty;
  }
}

/// Whether this browser has no graphics card for WebGL.
function drawn_by_processor(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  const info = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = gl && info ? String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

export interface Theme {
  ground: Rgb;
  ink: Rgb;
  held: Rgb;
  hatch: Rgb;
  original: Rgb;
}

export class Scene {
  readonly view: View = { x: 0, y: 0, scale: 1 };
  private readonly renderer: WebGLRenderer;
  private readonly stage = new Stage3();
  private readonly camera = new OrthographicCamera();
  private readonly window = new Vector4();
  private readonly size = { value: [1, 1] as [number, number] };
  private readonly cells: Drawn;
  private readonly material: RawShaderMaterial;
  private readonly lines: Record<Layer, Lines>;
  private readonly tables = { magnitude: Scene.texture(table("magnitude")), signed: Scene.texture(table("signed")) };
  private names: DataTexture | null = null;
  private mesh: Mesh | null = null;
  private edges: Uint32Array = new Uint32Array(0);
  private edge_block: Int32Array = new Int32Array(0);
  private edge_ends: Float32Array = new Float32Array(0);
  private block_size = 1; // the mean one: root of an area [m]
  position: Float32Array = new Float32Array(0); // x, y a point, now
  private theme: Theme | null = null;
  width = 1; // [CSS pixels]
  height = 1;

  /// @param blocks  how many are to be drawn: smooth edges of very many take too long where the processor draws them
  constructor(readonly canvas: HTMLCanvasElement, blocks: number) {
    ColorManagement.enabled = false; // colours are those of the screen, in shaders and for the ground alike
    this.renderer = new WebGLRenderer({ canvas, antialias: blocks < MANY || !drawn_by_processor(), preserveDrawingBuffer: true });
    this.renderer.sortObjects = false; // layers are drawn in the order they are added; nothing has a bounding sphere
    this.material = new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: CELL_VERTEX, fragmentShader: CELL_FRAGMENT, depthTest: false, depthWrite: false, side: 2,
      uniforms: {
        view: { value: this.window }, range: { value: [0, 1] }, colours: { value: this.tables.magnitude }, names: { value: 0 },
        ground: { value: [1, 1, 1] }, hatch: { value: [0, 0, 0] }, pixel: { value: 1 },
      },
    });
    this.cells = new Drawn(new BufferGeometry(), this.material);
    this.cells.frustumCulled = false;
    this.stage.add(this.cells);
    this.lines = Object.fromEntries(
      LAYERS.map((layer) => [layer, new Lines(this.window, this.size, WIDTH[layer], OPACITY[layer], SEAMED.has(layer))]),
    ) as Record<Layer, Lines>;
    for (const layer of LAYERS) this.stage.add(...this.lines[layer].drawn);
  }

  private static texture(colours: Uint8Array): DataTexture {
    const texture = new DataTexture(colours as Uint8Array<ArrayBuffer>, 256, 1, RGBAFormat);
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.needsUpdate = true;
    return texture;
  }

  use_theme(theme: Theme): void {
    this.theme = theme;
    const unit = (c: Rgb) => c.map((x) => x / 255);
    this.material.uniforms.ground!.value = unit(theme.held);
    this.material.uniforms.hatch!.value = unit(theme.hatch);
    this.renderer.setClearColor((theme.ground[0] << 16) | (theme.ground[1] << 8) | theme.ground[2], 1);
    this.lines.outline.keep(this.edge_ends, theme.ink);
  }

  resize(): void {
    const ratio = Math.min(3, globalThis.devicePixelRatio || 1);
    this.width = Math.max(1, this.canvas.clientWidth);
    this.height = Math.max(1, this.canvas.clientHeight);
    this.renderer.outputColorSpace = "srgb-linear"; // shaders write the colours of the screen themselves
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.width, this.height, false);
    this.size.value = [this.width, this.height];
    this.material.uniforms.pixel!.value = ratio;
  }

  use_mesh(mesh: Mesh, held: (block: number) => boolean): void {
    this.mesh = mesh;
    const geometry = new BufferGeometry();
    const corners = mesh.cells.length;
    const is_held = new Float32Array(corners);
    for (let c = 0; c + 1 < mesh.offsets.length; ++c)
      if (held(mesh.block[c]!)) is_held.fill(1, mesh.offsets[c], mesh.offsets[c + 1]);
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(2 * corners), 2));
    geometry.setAttribute("value", new BufferAttribute(new Float32Array(corners), 1));
    geometry.setAttribute("held", new BufferAttribute(is_held, 1));
    geometry.setIndex(new BufferAttribute(triangles(mesh), 1));
    this.cells.geometry.dispose();
    this.cells.geometry = geometry;
    this.position = new Float32Array(mesh.origin.length);
    const found = outline(mesh);
    this.edges = found.edges;
    this.edge_block = found.block;
    this.edge_ends = new Float32Array(2 * this.edges.length);
    this.block_size = Math.sqrt(cell_areas(mesh).reduce((sum, a) => sum + a, 0) / Math.max(1, new Set(mesh.block).size));
  }

  /// The outlines where the model had them, as x0, y0, x1, y1 a line.
  original_lines(): Float32Array {
    const origin = this.mesh?.origin ?? new Float32Array(0);
    const ends = new Float32Array(2 * this.edges.length);
    this.edges.forEach((p, e) => ends.set([origin[2 * p]!, origin[2 * p + 1]!], 2 * e));
    return ends;
  }
  use_original(ends: Float32Array, colour: Rgb): void {
    this.lines.original.keep(ends, colour);
  }

  /// Whether blocks are too small on the screen for their outlines.
  get dense(): boolean {
    return this.block_size * this.view.scale < LEAST_BLOCK;
  }

  /// @param factor  how many times larger than they are displacements are drawn
  use_displacement(displacement: Float32Array, factor: number): void {
    const mesh = this.mesh!;
    for (let i = 0; i < this.position.length; ++i) this.position[i] = mesh.origin[i]! + factor * displacement[i]!;
    const at = this.cells.geometry.getAttribute("position") as BufferAttribute;
    const out = at.array as Float32Array;
    for (let i = 0; i < mesh.cells.length; ++i) {
      const p = mesh.cells[i]!;
      out[2 * i] = this.position[2 * p]!;
      out[2 * i + 1] = this.position[2 * p + 1]!;
    }
    at.needsUpdate = true;
    for (let e = 0; e < this.edges.length; ++e) {
      const p = this.edges[e]!;
      this.edge_ends[2 * e] = this.position[2 * p]!;
      this.edge_ends[2 * e + 1] = this.position[2 * p + 1]!;
    }
    this.lines.outline.keep(this.edge_ends, this.theme?.ink ?? [0, 0, 0]);
  }

  /// Corner values, to be written into and then shown by use_colours.
  get values(): Float32Array {
    return (this.cells.geometry.getAttribute("value") as BufferAttribute).array as Float32Array;
  }

  use_colours(field: Field, range: [number, number], names: Rgb[]): void {
    (this.cells.geometry.getAttribute("value") as BufferAttribute).needsUpdate = true;
    this.material.uniforms.range!.value = range;
    this.material.uniforms.names!.value = field.kind === "names" ? Math.max(1, names.length) : 0;
    if (field.kind !== "names") {
      this.material.uniforms.colours!.value = this.tables[field.kind];
      return;
    }
    const colours = new Uint8Array(4 * 256);
    names.slice(0, 256).forEach((c, i) => colours.set([...c, 255], 4 * i));
    this.names?.dispose();
    this.names = Scene.texture(colours);
    this.material.uniforms.colours!.value = this.names;
  }

  use_lines(layer: Layer, ends: Float32Array, tint: Uint8Array): void {
    this.lines[layer].set(ends, tint);
  }
  show(layer: Layer, on: boolean): void {
    this.lines[layer].show(on);
  }

  /// Draws the outline of one block thick; -1: none.
  choose(block: number): void {
    const ends: number[] = [];
    for (let e = 0; e < this.edge_block.length; ++e)
      if (this.edge_block[e] === block) ends.push(...this.edge_ends.subarray(4 * e, 4 * e + 4));
    const tint = new Uint8Array((3 * ends.length) / 4);
    for (let i = 0; i < tint.length; ++i) tint[i] = [230, 60, 0][i % 3]!;
    this.lines.chosen.set(new Float32Array(ends), tint);
  }

  /// Shows a box [m] whole, below what lies over the upper and above what lies over the lower edge of the picture.
  fit(x0: number, y0: number, x1: number, y1: number): void {
    const [side, top, foot] = [20, 52, 42]; // [CSS pixels]
    const [w, h] = [Math.max(20, this.width - 2 * side), Math.max(20, this.height - top - foot)];
    this.view.scale = Math.min(w / Math.max(x1 - x0, 1e-9), h / Math.max(y1 - y0, 1e-9));
    this.view.x = 0.5 * (x0 + x1);
    this.view.y = 0.5 * (y0 + y1) + (0.5 * (top - foot)) / this.view.scale;
  }

  zoom(factor: number, px: number, py: number): void {
    const [x, y] = this.place(px, py);
    this.view.scale *= factor;
    this.view.x = x - (px - 0.5 * this.width) / this.view.scale;
    this.view.y = y + (py - 0.5 * this.height) / this.view.scale;
  }

  /// The place [m] below a pixel, and the pixel of a place.
  place(px: number, py: number): [number, number] {
    return [this.view.x + (px - 0.5 * this.width) / this.view.scale, this.view.y - (py - 0.5 * this.height) / this.view.scale];
  }
  pixel(x: number, y: number): [number, number] {
    return [0.5 * this.width + (x - this.view.x) * this.view.scale, 0.5 * this.height - (y - this.view.y) * this.view.scale];
  }

  render(): void {
    this.window.set(this.view.x, this.view.y, (2 * this.view.scale) / this.width, (2 * this.view.scale) / this.height);
    const [half_width, half_height] = [(0.5 * this.width) / this.view.scale, (0.5 * this.height) / this.view.scale];
    const { x, y } = this.view;
    for (const layer of ["outline", "original"] as const) this.lines[layer].cull(this.dense, x - half_width, y - half_height, x + half_width, y + half_height);
    this.renderer.render(this.stage, this.camera);
  }
}
