// What the page shows, and where it comes from. A report has everything in its own elements; `scree view` serves the same
// chunks by their names (served.ts), or sends what a stream brings (live.ts).
import type { Answer } from "./control";

export interface Stage {
  name: string;
  integrator: string;
  duration: number; // [s]
  start: number | null; // [s]; null: not reached
}

export interface FrameNote {
  index: number; // in the run
  time: number; // [s]
  step: number;
  mesh: number;
  stage: string;
  integrator: string;
}

export interface Block {
  name: string;
  material: number;
  held: boolean;
  rings: number[][]; // x, y, x, y, ... as the model first had it
}

export interface Law {
  name: string;
  friction_deg: number;
  cohesion: number;
  tensile_strength: number | null; // null: without limit
}

export type Piece = [number, number, number, number, number]; // x0, y0, x1, y1, law

export interface Run {
  format: number;
  written_by: string;
  title: string;
  folder: string;
  origin: [number, number]; // what all positions are counted from [m]
  model: {
    blocks: Block[];
    materials: { name: string; density: number; young: number; poisson: number }[];
    methods: string[];
    supports: [number, number, boolean, boolean][]; // x, y, held along x, along y
    edges?: [number, number, number, number, boolean][]; // held stretches of outlines, rock to their left; held along both axes, else across alone
    water?: { line: number[]; joints: number[] }[]; // piezometric lines x, y, x, y, ...; joint laws that they fill
    joints: { laws: Law[]; lines: Piece[]; cracks: Piece[] };
  };
  stages: Stage[];
  frames: {
    list: FrameNote[];
    stored: number;
    meshes: number;
    ranges: Record<string, [number, number]>;
    bounds: [number, number, number, number];
  };
  history: {
    monitors: { name: string; stress: boolean; at?: [number, number] }[]; // at: in the model
    ledger: { name: string; side: string; meaning: string }[];
    whole: boolean;
  };
  contacts: boolean;
  bolts?: boolean; // frames have them
  events: [number, string, string][];
  asked: Record<string, unknown> & { case: string; set: string[]; libraries: [string, string][] };
  found: Record<string, unknown> | null;
}

/// Cells of one topology: cell c has the corners cells[offsets[c]] .. cells[offsets[c + 1] - 1].
export interface Mesh {
  origin: Float32Array; // x, y a point, where it was in the model
  offsets: Int32Array;
  cells: Int32Array;
  block: Int32Array; // a cell, as the two below
  material: Int32Array;
  method: Int32Array;
}

export interface Contacts {
  position: Float32Array; // x, y a contact point
  normal: Float32Array; // of the edge, outward of its block; the corner is pushed along it
  force: Float32Array; // normal, tangential a contact point [N]
  slip: Float32Array; // [m]
  blocks: Int32Array; // block of the corner, block of the edge, joint law
  state: Uint8Array; // 1 slipping, 2 sticking; + 4 where its strength has failed
}

/// Bolts that are installed, bolt after bolt from head to toe.
export interface Bolts {
  position: Float32Array; // x, y a node
  force: Float32Array; // axial, from a node to the next, for unit thickness; tension positive [N]
  bolt: Int32Array; // of a node
}

export interface Frame {
  displacement: Float32Array; // x, y a point
  velocity: Float32Array; // x, y a point; of a stream: none
  stress: Float32Array; // xx, yy, xy a point; of a stream: none
  integrator: Uint8Array; // a cell; of a stream: none
  contacts: Contacts | null;
  bolts: Bolts | null;
  scalar?: Float32Array; // a cell, of a stream: the field that it carries
  scalar_field?: string; // which that is
  detail_time?: number; // of a stream: of the instant whose contacts, stress and bolts these are [s]
}

export interface Source {
  readonly run: Run;
  /// Of a stream: `run` and the frames grow.
  readonly live?: Stream;
  mesh(index: number): Promise<Mesh>;
  frame(index: number): Promise<Frame>;
  /// Monitors and the ledger: rows by name (m0.time, m0.u, l.time, l.0, ...).
  history(): Promise<Map<string, Float32Array>>;
}

export interface Stream {
  /// Whether this page may give commands: it has the token, and the server takes them.
  can_control(): boolean;
  /// pause, resume, step N, checkpoint, stop, field NAME.   @pre can_control()
  command(text: string): void;
  /// running, paused, done, ...; empty: not known
  state(): string;
  /// What people are told of it: status, rate, time left.
  status(): string;
  /// Counts the times that names and what is drawn over blocks have come.
  models(): number;
  /// Called after something came; `thinned`: frames that were there are gone.
  follow(changed: (thinned: boolean) => void, answered: (answer: Answer) => void): void;
}

export type Numbers = Float32Array | Int32Array | Uint8Array;

/// The arrays of a chunk as io/report/chunk.h lays them out.
export function unpack(bytes: Uint8Array): Map<string, Numbers> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = view.getUint32(0, true);
  const arrays = new Map<string, Numbers>();
  let at = 4 + 24 * count;
  for (let a = 0; a < count; ++a) {
    const head = 4 + 24 * a;
    let name = "";
    for (let i = 0; i < 16 && bytes[head + i] !== 0; ++i) name += String.fromCharCode(bytes[head + i]!);
    const type = view.getUint32(head + 16, true);
    const length = view.getUint32(head + 20, true);
    const width = type === 2 ? 1 : 4;
    if (at + width * length > bytes.length) throw new Error(`array ${name} is cut short`);
    const planes = bytes.subarray(at, at + width * length);
    at += width * length;
    if (type === 2) {
      arrays.set(name, planes.slice());
      continue;
    }
    // Little endian, as every machine with WebGL is.
    const out = new Uint32Array(length);
    const [second, third, fourth] = [length, 2 * length, 3 * length];
    for (let i = 0; i < length; ++i) out[i] = planes[i]! | (planes[second + i]! << 8) | (planes[third + i]! << 16) | (planes[fourth + i]! << 24);
    arrays.set(name, type === 0 ? new Float32Array(out.buffer) : new Int32Array(out.buffer));
  }
  return arrays;
}

/// The bytes of a chunk that was compressed (zlib).
export async function inflate(bytes: Uint8Array): Promise<Uint8Array> {
  if (typeof DecompressionStream === "undefined")
    throw new Error("this browser is too old to read a run: it takes Chrome 80, Firefox 113, Safari 16.4 or later");
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function array<T extends Numbers>(arrays: Map<string, Numbers>, name: string): T {
  const found = arrays.get(name);
  if (!found) throw new Error(`there is no array ${name}; the run is damaged`);
  return found as T;
}

export function mesh_of(a: Map<string, Numbers>): Mesh {
  return {
    origin: array(a, "origin"),
    offsets: array(a, "offsets"),
    cells: array(a, "cells"),
    block: array(a, "block"),
    material: array(a, "material"),
    method: array(a, "method"),
  };
}

export function frame_of(a: Map<string, Numbers>): Frame {
  return {
    displacement: array(a, "displacement"),
    velocity: array(a, "velocity"),
    stress: array(a, "stress"),
    integrator: array(a, "integrator"),
    ...over_blocks(a),
  };
}

/// What is drawn over blocks.
export function over_blocks(a: Map<string, Numbers>): Pick<Frame, "contacts" | "bolts"> {
  return {
    contacts: !a.has("c.state")
      ? null
      : {
          position: array(a, "c.position"),
          normal: array(a, "c.normal"),
          force: array(a, "c.force"),
          slip: array(a, "c.slip"),
          blocks: array(a, "c.blocks"),
          state: array(a, "c.state"),
        },
    bolts: !a.has("b.bolt") ? null : { position: array(a, "b.position"), force: array(a, "b.force"), bolt: array(a, "b.bolt") },
  };
}

export const KEPT_BYTES = 300e6; // of unpacked frames

/// Chunks by name: mesh-0, frame-0, history.
export abstract class ChunkSource implements Source {
  private readonly meshes = new Map<number, Promise<Mesh>>();
  private readonly frames = new Map<number, Promise<Frame>>();
  private readonly sizes = new Map<number, number>();
  private kept = 0;

  constructor(readonly run: Run) {
    if (run.format !== 1) throw new Error(`the run has format ${run.format}, which this page cannot read`);
  }

  /// The compressed bytes of a chunk.
  protected abstract packed(name: string): Promise<Uint8Array>;

  mesh(index: number): Promise<Mesh> {
    let found = this.meshes.get(index);
    if (!found) this.meshes.set(index, (found = this.chunk(`mesh-${index}`).then(mesh_of)));
    return found;
  }

  frame(index: number): Promise<Frame> {
    let found = this.frames.get(index);
    if (found) {
      this.frames.delete(index); // the last one used stands last
    } else {
      found = this.chunk(`frame-${index}`).then(frame_of);
      void found.then(
        (f) => this.keep(index, 4 * (f.displacement.length + f.velocity.length + f.stress.length)),
        () => this.frames.delete(index), // what failed is asked for again
      );
    }
    this.frames.set(index, found);
    return found;
  }

  async history(): Promise<Map<string, Float32Array>> {
    return (await this.chunk("history")) as Map<string, Float32Array>;
  }

  private keep(index: number, bytes: number): void {
    this.sizes.set(index, bytes);
    this.kept += bytes;
    for (const oldest of this.frames.keys()) {
      if (this.kept <= KEPT_BYTES || oldest === index) break;
      this.kept -= this.sizes.get(oldest) ?? 0;
      this.sizes.delete(oldest);
      this.frames.delete(oldest);
    }
  }

  private async chunk(name: string): Promise<Map<string, Numbers>> {
    return unpack(await inflate(await this.packed(name)));
  }
}

/// The elements of the page itself.
export class ReportSource extends ChunkSource {
  constructor() {
    super(JSON.parse(text_of("run")) as Run);
  }

  protected async packed(name: string): Promise<Uint8Array> {
    const binary = atob(text_of(name));
    const bytes = new Uint8Array(binary.length);
    for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
    return bytes;
  }
}

function text_of(name: string): string {
  const element = document.getElementById(`scree-${name}`);
  if (!element || element.textContent === null) throw new Error(`the report lacks its part ${name}; it is damaged`);
  return element.textContent;
}
