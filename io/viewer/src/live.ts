// A run that streams: messages of `scree view --live` over a WebSocket (io/serve/live_messages.h). What has come stays, so
// that one can go back in time; what came before the page was opened is not known.
import { token, type Answer } from "./control";
import { STREAM_FIELDS, STREAM_SCALARS } from "./fields";
import { KEPT_BYTES, mesh_of, over_blocks, unpack, type Block, type Frame, type FrameNote, type Mesh, type Run, type Source, type Stream } from "./source";
import { seconds, short } from "./units";

interface Head {
  kind: string;
  session: number;
}
interface RunHead extends Head {
  run: string;
  title: string;
  version: string;
  field: string; // that frames carry which do not say it themselves, as those of an older server
  control?: boolean;
  end_time: number;
  origin: [number, number];
  bounds: [number, number, number, number];
  blocks: number;
  materials: number;
}
interface ModelHead extends Head {
  blocks: Omit<Block, "rings">[];
  materials: Run["model"]["materials"];
  supports: Run["model"]["supports"];
  edges: Run["model"]["edges"];
  water: Run["model"]["water"];
  joints: Run["model"]["joints"];
  bolts: number;
}
interface DetailHead extends Head {
  mesh: number;
  time: number;
}
interface MeshHead extends Head {
  mesh: number;
  methods: string[];
}
interface FrameHead extends Head {
  mesh: number;
  time: number;
  step: number;
  stage: string;
  integrator: string;
  field?: string;
}
type Pair = [number, number];
interface RowsHead extends Head {
  monitors?: { time: number; list: { name: string; at: Pair; u: Pair; v: Pair }[] };
  ledger?: { time: number; columns: { name: string; side: string; value: number }[]; energy: number; closure: number; moved: number; passed: number };
}
interface Status extends Head {
  status: string;
  reason?: string;
  url?: string;
  run?: string;
  trouble?: string;
  time: number;
  end_time: number;
  rate: number;
  time_left: number;
  silent: number;
  steps: number;
  cuts: number;
  passes: number;
  contacts: number;
  blocks: number;
  elements: number;
  unknowns: number;
}

const RETRY = 500; // [ms] between attempts to connect
const NAMES = 1500; // [ms] that names are waited for once there is a picture: they come every second
const SILENCE = 3; // [s] after which people are told; INFO comes every second

const text = new TextDecoder();

export class LiveSource implements Source, Stream {
  readonly live: Stream = this;
  run!: Run;
  private readonly token = token();
  private takes_commands = false;
  private carried = "";
  private asked: string | null = null; // a command without its answer
  private answered: (answer: Answer) => void = () => undefined;
  private session = -1;
  private connected = false;
  private last_status: Status | null = null;
  private socket: WebSocket | null = null;
  private readonly meshes = new Map<number, Mesh>();
  private frames: Frame[] = [];
  private bytes = 0;
  private rows = new Map<string, number[]>();
  private models_come = 0;
  private detail: (Pick<Frame, "contacts" | "bolts" | "stress"> & DetailHead) | null = null; // the newest
  private shown = false; // the page has been given this source
  private changed: (thinned: boolean) => void = () => undefined;
  private ready: (source: LiveSource) => void = () => undefined;

  /// The source, as soon as there is a frame.   @param waiting  is told what is waited for
  static open(waiting: (what: string) => void): Promise<LiveSource> {
    const source = new LiveSource(waiting);
    return new Promise((done) => {
      source.ready = done;
      source.connect();
    });
  }

  private constructor(private readonly waiting: (what: string) => void) {}

  follow(changed: (thinned: boolean) => void, answered: (answer: Answer) => void): void {
    this.changed = changed;
    this.answered = answered;
  }

  can_control(): boolean {
    return this.takes_commands && this.token !== "";
  }

  command(text: string): void {
    this.asked = text;
    this.socket?.send(`${this.token} ${text}`);
  }

  models(): number {
    return this.models_come;
  }

  state(): string {
    return this.connected ? this.last_status?.status ?? "" : "";
  }

  mesh(index: number): Promise<Mesh> {
    const found = this.meshes.get(index);
    return found ? Promise.resolve(found) : Promise.reject(new Error(`mesh ${index} has not come`));
  }

  frame(index: number): Promise<Frame> {
    const found = this.frames[index];
    return found ? Promise.resolve(found) : Promise.reject(new Error(`frame ${index} has not come`));
  }

  history(): Promise<Map<string, Float32Array>> {
    return Promise.resolve(new Map([...this.rows].map(([name, values]) => [name, Float32Array.from(values)])));
  }

  status(): string {
    if (!this.connected) return "connection to scree view lost; trying again";
    const s = this.last_status;
    if (!s) return "";
    const going = s.status === "running" || s.status === "paused";
    const parts = [s.status + (s.reason ? `: ${s.reason}` : "")];
    if (going && s.silent >= SILENCE) parts.push(`silent for ${s.silent} s`);
    if (s.status === "running" && s.rate > 0) parts.push(`${short(s.rate)} s/s`);
    if (s.status === "running" && s.time_left >= 0) parts.push(`${short(s.time_left, 2)} s left`);
    return [...parts, `${seconds(Math.max(s.time, this.run.frames.list[this.run.frames.list.length - 1]?.time ?? 0))} of ${seconds(s.end_time)}`].join(" · ");
  }

  // ------------------------------------------------------------------------------------ connection

  private connect(): void {
    const address = new URL("live", location.href);
    address.protocol = "ws:";
    address.hash = "";
    const socket = (this.socket = new WebSocket(address));
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.connected = true;
      this.changed(false);
    };
    socket.onmessage = (e: MessageEvent<ArrayBuffer>) => this.take(new Uint8Array(e.data));
    socket.onclose = () => {
      this.connected = false;
      if (this.frames.length === 0) this.waiting("scree view does not answer; trying again");
      else this.changed(false);
      setTimeout(() => this.connect(), RETRY);
    };
  }

  private take(bytes: Uint8Array): void {
    const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
    const head = JSON.parse(text.decode(bytes.subarray(4, 4 + length))) as Head;
    const arrays = bytes.subarray(4 + length);
    if (head.kind === "run" && this.session >= 0 && head.session !== this.session) {
      location.reload(); // another run: everything begins anew
      return;
    }
    if (head.kind === "run") this.take_run(head as RunHead);
    else if (head.kind === "status") this.take_status(head as Status);
    else if (head.kind === "answer") this.take_answer(head as Head & Answer);
    else if (head.session === this.session) {
      if (head.kind === "mesh") this.take_mesh(head as MeshHead, arrays);
      else if (head.kind === "model") this.take_model(head as ModelHead);
      else if (head.kind === "detail") this.take_detail(head as DetailHead, arrays);
      else if (head.kind === "rows") this.take_rows(head as RowsHead);
      else if (head.kind === "events") this.run.events = (head as Head & { list: Run["events"] }).list;
      else if (head.kind === "frame") this.take_frame(head as FrameHead, arrays);
    }
    if (head.kind === "frame" || head.kind === "detail") this.socket?.send("n"); // the next one may come
  }

  // -------------------------------------------------------------------------------------- messages

  private take_run(head: RunHead): void {
    if (!this.run) {
      this.session = head.session;
      this.takes_commands = head.control ?? false;
      this.carried = head.field;
      this.run = {
        format: 1, written_by: head.version, title: head.title, folder: head.run, origin: head.origin,
        model: { blocks: [], materials: [], methods: [], supports: [], joints: { laws: [], lines: [], cracks: [] } },
        stages: [], frames: { list: [], stored: 0, meshes: 0, ranges: {}, bounds: head.bounds },
        history: { monitors: [], ledger: [], whole: true }, contacts: true, events: [],
        asked: { case: "", set: [], libraries: [], version: head.version }, found: null,
      };
    }
    // Names come a little later.
    const { blocks, materials } = this.run.model;
    while (blocks.length < head.blocks) blocks.push({ name: `block ${blocks.length + 1}`, material: -1, held: false, rings: [] });
    while (materials.length < head.materials) materials.push({ name: `material ${materials.length + 1}`, density: NaN, young: NaN, poisson: NaN });
  }

  private take_model(head: ModelHead): void {
    const model = this.run.model;
    head.blocks.forEach((b, i) => (model.blocks[i] = { ...b, rings: [] }));
    head.materials.forEach((m, i) => (model.materials[i] = m));
    [model.supports, model.edges, model.water, model.joints] = [head.supports, head.edges, head.water, head.joints];
    this.run.bolts = head.bolts > 0;
    this.models_come += 1;
    this.show();
    this.changed(false);
  }

  /// Contacts, stress and bolts: of the frames from their instant on, until newer ones come.
  private take_detail(head: DetailHead, bytes: Uint8Array): void {
    const arrays = unpack(bytes);
    this.detail = { ...head, ...over_blocks(arrays), stress: (arrays.get("stress") as Float32Array | undefined) ?? new Float32Array(0) };
    const list = this.run.frames.list;
    for (let i = list.length - 1; i >= 0 && list[i]!.time >= head.time && list[i]!.mesh === head.mesh; --i) this.add_detail(this.frames[i]!, list[i]!);
    this.bytes += 4 * this.detail.stress.length + 41 * (this.detail.contacts?.state.length ?? 0);
    this.changed(false);
  }

  private add_detail(frame: Frame, note: FrameNote): void {
    const detail = this.detail;
    if (!detail || detail.mesh !== note.mesh || detail.time > note.time) return;
    [frame.contacts, frame.bolts, frame.stress, frame.detail_time] = [detail.contacts, detail.bolts, detail.stress, detail.time];
  }

  /// Gives the page what there is, once there is a picture and the names have come, or have been waited for.
  private show(waited = false): void {
    if (this.shown || this.frames.length === 0 || !(waited || this.models_come > 0)) return;
    this.shown = true;
    this.ready(this);
  }

  private take_status(s: Status): void {
    if (s.session < 0) {
      const who = s.run ? `a run named ${s.run}` : "any run";
      this.waiting(s.trouble || `Nothing is heard of ${who} on ${s.url}: waiting. Does it stream? scree run CASE --live`);
      return;
    }
    if (s.session !== this.session) return;
    this.last_status = s;
    this.run.found = {
      status: s.status, reason: s.reason ?? "", final_time: s.time, steps: s.steps, cuts: s.cuts, open_close_passes: s.passes, blocks_count: s.blocks,
      elements: s.elements, unknowns: s.unknowns, contacts: s.contacts,
    };
    this.changed(false);
  }

  private take_answer(head: Head & Answer): void {
    if (head.command !== this.asked) return; // that of another page, or one from before this page came
    this.asked = null;
    this.answered(head);
  }

  private take_mesh(head: MeshHead, bytes: Uint8Array): void {
    const mesh = mesh_of(unpack(bytes));
    // Each mesh counts its methods anew; the page counts those of all.
    const methods = this.run.model.methods;
    for (const name of head.methods) if (!methods.includes(name)) methods.push(name);
    mesh.method = mesh.method.map((m) => methods.indexOf(head.methods[m] ?? ""));
    for (let c = 0; c < mesh.block.length; ++c) this.run.model.blocks[mesh.block[c]!]!.material = mesh.material[c]!;
    if (!this.meshes.has(head.mesh)) this.meshes.set(head.mesh, mesh);
  }

  private take_frame(head: FrameHead, bytes: Uint8Array): void {
    const list = this.run.frames.list;
    const last = list[list.length - 1];
    if (!this.meshes.has(head.mesh) || (last && last.time === head.time && last.mesh === head.mesh)) return; // sent again after a new connection
    const arrays = unpack(bytes);
    const frame: Frame = {
      displacement: arrays.get("displacement") as Float32Array, scalar: arrays.get("scalar") as Float32Array, scalar_field: head.field ?? this.carried,
      velocity: new Float32Array(0), stress: new Float32Array(0), integrator: new Uint8Array(0), contacts: null, bolts: null,
    };
    this.grow_ranges(frame);
    const stages = this.run.stages;
    if (stages[stages.length - 1]?.name !== head.stage) stages.push({ name: head.stage, integrator: head.integrator, duration: 0, start: head.time });
    const note: FrameNote = { index: list.length, time: head.time, step: head.step, mesh: head.mesh, stage: head.stage, integrator: head.integrator };
    list.push(note);
    this.add_detail(frame, note);
    this.frames.push(frame);
    this.bytes += 4 * (frame.displacement.length + frame.scalar!.length);
    this.run.frames.stored += 1;
    const thinned = this.bytes > KEPT_BYTES;
    if (thinned) this.thin();
    if (this.frames.length === 1) setTimeout(() => this.show(true), NAMES);
    this.show();
    this.changed(thinned);
  }

  private grow_ranges(frame: Frame): void {
    const carried = STREAM_SCALARS.find((f) => f.id === frame.scalar_field && f.kind !== "names");
    const most: Record<string, number> = { displacement: 0, ux: 0, uy: 0 };
    const u = frame.displacement;
    for (let p = 0; p + 1 < u.length; p += 2) {
      const [x, y] = [Math.abs(u[p]!), Math.abs(u[p + 1]!)];
      if (x > most.ux!) most.ux = x;
      if (y > most.uy!) most.uy = y;
      const size = Math.hypot(x, y);
      if (size > most.displacement!) most.displacement = size;
    }
    if (carried) most[carried.id] = frame.scalar!.reduce((m, s) => (Math.abs(s) > m ? Math.abs(s) : m), 0);
    const ranges = this.run.frames.ranges;
    for (const [id, size] of Object.entries(most)) {
      const high = Math.max(size, ranges[id]?.[1] ?? 0);
      const signed = STREAM_FIELDS.find((f) => f.id === id)?.kind === "signed";
      if (high > 0) ranges[id] = [signed ? -high : 0, high];
    }
  }

  /// Every second frame of the older ones goes; the ends of stages and meshes stay.
  private thin(): void {
    const list = this.run.frames.list;
    const ends = (i: number) => list[i]!.stage !== list[i - 1]?.stage || list[i]!.stage !== list[i + 1]?.stage || list[i]!.mesh !== list[i + 1]?.mesh;
    const kept = list.map((_, i) => i).filter((i) => i % 2 === 0 || i > 0.75 * list.length || ends(i));
    this.frames = kept.map((i) => this.frames[i]!);
    const notes: FrameNote[] = kept.map((i) => list[i]!);
    list.splice(0, list.length, ...notes);
    // Frames between two details share the first of them.
    const details = new Set(this.frames.map((f) => f.stress));
    this.bytes = this.frames.reduce((sum, f) => sum + 4 * (f.displacement.length + f.scalar!.length + (details.delete(f.stress) ? f.stress.length : 0)), 0);
  }

  private take_rows(head: RowsHead): void {
    const row = (name: string, ...values: number[]) => {
      const all = this.rows.get(name);
      if (all) all.push(...values);
      else this.rows.set(name, values);
    };
    const is_new = (name: string, time: number) => !(time <= (this.rows.get(name)?.slice(-1)[0] ?? -Infinity));
    const monitors = head.monitors;
    if (monitors && monitors.list.length > 0 && is_new("m0.time", monitors.time)) {
      this.run.history.monitors = monitors.list.map((m) => ({ name: m.name, stress: false, at: m.at }));
      monitors.list.forEach((m, i) => {
        row(`m${i}.time`, monitors.time);
        row(`m${i}.u`, ...m.u);
        row(`m${i}.v`, ...m.v);
      });
    }
    const ledger = head.ledger;
    if (ledger && is_new("l.time", ledger.time)) {
      this.run.history.ledger = ledger.columns.map((c) => ({ name: c.name, side: c.side, meaning: "" }));
      row("l.time", ledger.time);
      for (const name of ["energy", "closure", "moved", "passed"] as const) row(`l.${name}`, ledger[name]);
      ledger.columns.forEach((c, i) => row(`l.${i}`, c.value));
    }
  }
}
