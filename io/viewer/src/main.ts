// The page: binds the source, the scene, the charts and the controls.
import { ledger_series, Chart, closure, monitor_series, MONITOR_QUANTITIES, type Series } from "./charts";
import { css, mapped, name_colour, type Rgb } from "./colours";
import { bind_control, show_control, told } from "./control";
import { ContactBox } from "./contact_box";
import { FAILED, SLIPPING, STICKING } from "./contacts";
import { corner_values, FIELDS, frame_range, has_field, STREAM_FIELDS, STREAM_SCALARS } from "./fields";
import { by_id } from "./elements";
import { cell_areas, cell_at } from "./geometry";
import {
  bolt_lines, contact_lines, COMPRESSION, crosses, diamonds, joint_lines, original_outline, slip_lines, support_marks, TENSION, WATER, water_lines, type ContactLines, type Crosses,
} from "./layers";
import { legend_text, show_legend, type LegendText } from "./legend";
import { merged, Pair, type Shown } from "./pair";
import { draw_picture, png_of, type PictureText } from "./picture";
import { Scene, type Layer } from "./scene";
import { LiveSource } from "./live";
import { ServedSource } from "./served";
import { ReportSource, type Frame, type FrameNote, type Mesh, type Source } from "./source";
import { choose_theme, is_dark, on_theme } from "./theme";
import { element, pairs, show_asked, show_events, show_found, status_of } from "./tables";
import { prefixed, quantity, round_below, seconds, short } from "./units";
import { film_times, make_film } from "./video";

const CROSS_SPACING = 26; // [CSS pixels] between principal stress crosses
const REFRESH = 1000; // [ms] between texts and charts of a stream
const FRAME_TIME = 1000 / 12; // [ms] a frame where simulated time stands still, as between two stages
const LIVE_HISTORY = 300; // frames of a stream that the history of a block is read from
const READING = 150; // [ms] between looks of charts and facts at the instant, while playing

const SERVED = document.body.dataset.source !== undefined;
const LIVE_TEXT = "This is a live stream: what has come since the page was opened. Displacements are rounded to 16 bits of what the points of a block moved. Contacts, stresses and bolts come less often than pictures where there are many: between two of their instants those of the earlier one are shown.";
const MODEL = document.body.dataset.source === "model"; // before a run

function trouble(error: unknown): void {
  const box = by_id("trouble");
  box.textContent = `This page cannot be shown: ${error instanceof Error ? error.message : String(error)}`;
  box.hidden = false;
}

function rgb_of(name: string): Rgb {
  const hex = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)) as Rgb;
}

class Page {
  private readonly run;
  private readonly frames: FrameNote[];
  private readonly scene: Scene | null;
  private readonly charts: Chart[] = [];
  private rows = new Map<string, Float32Array>();
  private mesh: Mesh | null = null;
  private mesh_index = -1;
  private frame: Frame | null = null;
  private index = -1;
  private note: FrameNote | null = null; // of the frame that is shown
  private wanted = 0;
  private loading = false;
  private playing = false;
  private clock = 0; // simulated time while playing [s]
  private last_tick = 0;
  private still = 0; // [ms] since the clock met an instant with two frames
  private fields = FIELDS;
  private field = FIELDS[0]!;
  private following = false; // a stream: the newest frame is shown as it comes
  private slow_asked = false;
  private models_shown = 0; // of a stream (Stream::models)
  private detail_shown: Frame["stress"] | null = null;
  private pair: Pair | null = null;
  private led = false; // the page beside decides what is shown
  private events_shown: unknown = null;
  private legend: LegendText = { what: "", ticks: [], names: [] };
  private chosen = -1;
  private scale_bar = { pixels: 0, text: "" };
  private labels: [string, number, number][] = []; // of monitors: text, place of its middle on the left [CSS pixels]
  private draw_asked = false;
  private own_view = false; // the user has moved the view: it no longer follows the size of the window
  private crosses: Crosses | null = null;
  private forces: ContactLines | null = null;
  private readonly contact_box;
  private most_bolt = 0; // axial force of the frame that is shown [N]
  private most_slip = 0; // of the frame that is shown, where the layer is [m]
  private filming = false;
  private read_at = 0; // when charts and facts were brought to the instant last [ms]
  private was_dense = false;
  private readonly shown: Record<Layer, boolean> = {
    original: true, joints: false, outline: true, crosses: false, water: true, slip: false, contacts: false, bolts: true, supports: true, monitors: true, chosen: true, contact: true,
  };
  private block_chart: Chart | null = null;
  private block_history: { block: number; time: Float64Array; rows: Float64Array[] } | null = null;

  constructor(private readonly source: Source) {
    this.run = source.run;
    this.frames = this.run.frames.list;
    this.contact_box = new ContactBox(this.run, () => this.redraw());
    this.fields = source.live ? STREAM_FIELDS : FIELDS.filter((f) => f.id !== "joint" || this.run.contacts);
    let scene: Scene | null = null;
    try {
      scene = new Scene(by_id<HTMLCanvasElement>("view"), this.run.model.blocks.length);
    } catch {
      trouble("this browser has no WebGL 2, which the animation needs; histories and tables are below");
    }
    this.scene = scene;
  }

  private held = (block: number): boolean => this.run.model.blocks[block]?.held ?? false;

  async start(): Promise<void> {
    this.pair = Pair.find((what) => this.heard(what));
    this.show_text();
    this.fill_controls();
    this.bind();
    this.use_theme();
    this.scene?.resize();
    this.fit();
    await this.go(this.source.live ? this.frames.length - 1 : 0);
    this.rows = await this.source.history();
    this.make_charts();
    this.redraw();
    this.tell_extent(true);
    if (this.source.live) {
      this.set_following(true);
      this.source.live.follow((thinned) => this.stream_changed(thinned), (answer) => this.tell(told(answer)));
      bind_control((command) => this.source.live!.command(command));
      this.show_stream();
    }
    document.body.dataset.ready = "true";
  }

  // ------------------------------------------------------------------------------- the page beside

  private tell_extent(hello: boolean): void {
    const [x, y] = this.run.origin;
    const [x0, y0, x1, y1] = this.run.frames.bounds;
    this.pair?.tell({ ranges: this.run.frames.ranges, bounds: [x0 + x, y0 + y, x1 + x, y1 + y], ...(hello ? { hello } : {}) });
  }

  private heard(what: Shown): void {
    const [x, y] = this.run.origin;
    const select = (id: string, value: string | undefined) => {
      if (value !== undefined) by_id<HTMLSelectElement>(id).value = value;
    };
    if (what.ranges && what.bounds) {
      const frames = this.run.frames;
      const [a, b] = [frames.bounds, what.bounds];
      frames.ranges = merged(frames.ranges, what.ranges);
      frames.bounds = [Math.min(a[0], b[0] - x), Math.min(a[1], b[1] - y), Math.max(a[2], b[2] - x), Math.max(a[3], b[3] - y)];
      this.update_colours();
      if (what.hello) this.tell_extent(false);
    }
    select("field", what.field);
    select("range", what.range);
    select("factor", what.factor);
    if (what.field !== undefined) this.use_choices();
    if (what.fit || what.bounds) this.fit(true);
    if (what.view && this.scene) {
      this.own_view = true;
      Object.assign(this.scene.view, { x: what.view[0] - x, y: what.view[1] - y, scale: what.view[2] });
      this.redraw(true, true);
    }
    if (what.time !== undefined) {
      this.play(false);
      this.led = true;
      void this.go(this.index_at(what.time));
    }
  }

  /// Colours and places as the controls say.
  private use_choices(): void {
    const field = by_id<HTMLSelectElement>("field");
    this.field = this.fields.find((f) => f.id === field.value) ?? this.fields[0]!;
    by_id<HTMLSelectElement>("range").disabled = this.field.kind === "names";
    this.update_places();
    this.update_colours();
    this.redraw();
  }

  private choices_changed(): void {
    this.use_choices();
    this.ask_for_field();
    const value = (id: string) => by_id<HTMLSelectElement>(id).value;
    this.pair?.tell({ field: value("field"), range: value("range"), factor: value("factor") });
  }

  // ------------------------------------------------------------------------------------------ stream

  private set_following(on: boolean): void {
    this.following = on;
    by_id("follow").setAttribute("aria-pressed", String(on));
    if (on) void this.go(this.frames.length - 1);
  }

  /// A field that the stream does not carry is asked for.
  private ask_for_field(): void {
    const live = this.source.live;
    if (!live || !STREAM_SCALARS.includes(this.field) || this.newest_scalar() === this.field.id) return;
    if (live.can_control()) live.command(`field ${this.field.id}`);
    else if (!this.mesh || !this.frame || !has_field(this.field, this.mesh, this.frame)) this.tell(`The stream carries ${this.newest_scalar()}. It carries what this page asks for with scree run --live --control and scree view --live --control.`);
  }

  private newest_scalar(): string {
    return this.frame?.scalar_field ?? "";
  }

  /// What of a stream does not wait for the next look of people.
  private show_stream(): void {
    const live = this.source.live!;
    by_id("control-box").hidden = !live.can_control();
    show_control(live.state());
  }

  private stream_changed(thinned: boolean): void {
    this.show_stream();
    if (thinned && this.note) {
      const at = this.frames.indexOf(this.note);
      this.index = this.wanted = at >= 0 ? at : Math.min(this.index, this.frames.length - 1);
    }
    by_id<HTMLInputElement>("time").max = String(this.frames.length - 1);
    if (this.source.live!.models() !== this.models_shown) this.use_model();
    if (this.frame && this.frame.stress !== this.detail_shown) this.use_detail(this.frame);
    if (this.following) void this.go(this.frames.length - 1);
    if (this.slow_asked) return;
    this.slow_asked = true;
    setTimeout(() => {
      this.slow_asked = false;
      void this.refresh_texts();
    }, REFRESH);
  }

  /// Names have come, or what is drawn over blocks.
  private use_model(): void {
    this.models_shown = this.source.live!.models();
    this.fill_blocks();
    this.fill_layers();
    this.use_theme();
    if (this.mesh) this.scene?.use_mesh(this.mesh, this.held);
    this.update_places();
    this.update_colours();
    this.redraw();
  }

  /// Contacts, stress and bolts of the frame that is shown have come after it.
  private use_detail(frame: Frame): void {
    this.detail_shown = frame.stress;
    this.update_layers();
    this.update_colours();
    this.contact_box.show(frame.contacts);
    this.redraw();
  }

  /// What people read of a stream: once a second.
  private async refresh_texts(): Promise<void> {
    this.show_subtitle();
    show_found(this.run, by_id("found"));
    if (this.events_shown !== this.run.events) {
      this.events_shown = this.run.events;
      show_events(this.run, by_id("events"), (t) => this.go_to_time(t));
    }
    this.mark_stages();
    this.rows = await this.source.history();
    this.make_charts();
    this.update_colours();
    this.redraw();
    if (this.chosen >= 0) void this.follow_block(this.chosen);
  }

  // ------------------------------------------------------------------------------------------- text

  private show_subtitle(): void {
    const run = this.run;
    const last = this.frames[this.frames.length - 1]!;
    by_id("title").textContent = run.title || "Scree run";
    const held = run.model.blocks.filter((b) => b.held).length;
    const how_far = this.source.live ? [this.source.live.status()] : MODEL ? ["before its run"] : [status_of(run), `${short(last.time, 4)} s simulated`];
    by_id("subtitle").textContent = [
      ...(this.pair ? [run.folder] : []), ...how_far, `${run.model.blocks.length} blocks${held > 0 ? `, ${held} of them held` : ""}`,
      `${run.stages.length} ${run.stages.length === 1 ? "stage" : "stages"}`, `Scree ${String(run.asked.version ?? "")}`,
    ].join(" · ");
  }

  private show_text(): void {
    const run = this.run;
    this.show_subtitle();
    const shown = this.frames.length;
    by_id("thinning").textContent = this.source.live ? LIVE_TEXT : [
      MODEL ? "This is the model before its run."
        : SERVED ? `All ${shown} stored frames are served as they are asked for; the range of colours is that of at most 300 of them.`
        : shown < run.frames.stored ? `${shown} of the ${run.frames.stored} stored frames are in this file (scree report --size says how large it may be).`
        : `All ${shown} stored frames are in this file.`,
      "Displacements have 17 significant bits, velocities and stresses 12. Stress is recovered at the corners of elements, as in scree snapshot.",
      run.history.whole ? "" : "Histories are thinned in time.",
      run.contacts ? "Of the contact points, those that are closed are here." : "The run stored no contacts (output.contacts).",
    ].join(" ");
    by_id("licences").textContent = document.getElementById("scree-licences")?.textContent ?? "";
    if (MODEL) by_id("found-box").hidden = by_id("charts").hidden = by_id("transport").hidden = true;
    else show_found(run, by_id("found"));
    by_id("asked-box").hidden = this.source.live !== undefined;
    by_id("follow").hidden = this.source.live === undefined;
    by_id("contact-box").hidden = !run.contacts;
    by_id("film").hidden = MODEL;
    show_asked(run, by_id("asked"));
    show_events(run, by_id("events"), (t) => this.go_to_time(t));
  }

  /// Names of the blocks in their list.
  private fill_blocks(): void {
    const select = by_id<HTMLSelectElement>("block");
    while (select.options.length > 1) select.remove(1); // the first is none
    for (const [i, b] of this.run.model.blocks.entries()) {
      const option = element("option", b.name);
      option.value = String(i);
      select.append(option);
    }
    select.value = String(this.chosen);
  }

  private fill_controls(): void {
    const fill = (id: string, entries: [string, string][], value?: string) => {
      const select = by_id<HTMLSelectElement>(id);
      for (const [key, text] of entries) {
        const option = element("option", text);
        option.value = key;
        select.append(option);
      }
      if (value !== undefined) select.value = value;
    };
    fill("field", this.fields.map((f) => [f.id, f.label]));
    this.fill_blocks();
    const live = this.source.live !== undefined; // without stresses of monitors, and without velocities of points
    fill("monitor-quantity", MONITOR_QUANTITIES.filter((q) => !live || !q.includes("stress")).map((q) => [q, q]));
    fill("block-quantity", MONITOR_QUANTITIES.filter((q) => !live || q !== "speed").map((q) => [q, q]));
    const length = this.frames[this.frames.length - 1]!.time - this.frames[0]!.time;
    const speeds = [0.001, 0.01, 0.1, 0.25, 0.5, 1, 2, 5, 10, 100, 1000];
    // The run as a whole takes about ten seconds.
    const near = !(length > 0) ? 1 : speeds.reduce((a, b) => (Math.abs(Math.log((b * 10) / length)) < Math.abs(Math.log((a * 10) / length)) ? b : a), 1);
    fill("speed", speeds.map((s) => [String(s), s === 1 ? "real time" : `× ${s}`]), String(near));
    this.fill_layers();
    const time = by_id<HTMLInputElement>("time");
    time.max = String(this.frames.length - 1);
    this.mark_stages();
  }

  private fill_layers(): void {
    const live = this.source.live !== undefined;
    const layers = by_id("layers");
    layers.replaceChildren(...layers.querySelectorAll(":scope > :not(label)"));
    const entries: [Layer, string][] = [["outline", "outlines of the blocks"]];
    entries.push(["original", "original outline"]);
    entries.push(["joints", "joints as drawn"], ["crosses", "principal stress crosses"]);
    if (this.run.model.supports.length + (this.run.model.edges ?? []).length > 0) entries.push(["supports", "supports"]);
    if (live || this.run.history.monitors.some((m) => m.at)) entries.push(["monitors", "monitors"]);
    if ((this.run.model.water ?? []).length > 0) entries.push(["water", "water levels"]);
    if (this.run.bolts) entries.push(["bolts", "bolts and their forces"]);
    if (this.run.contacts) entries.push(["contacts", "contact forces and states"], ["slip", "slip of the joints"]);
    const drawn = this.run.model.joints.lines.length + this.run.model.joints.cracks.length > 0;
    for (const [layer, text] of entries) {
      if (layer === "joints" && !drawn) continue;
      const label = element("label");
      const box = element("input");
      box.type = "checkbox";
      box.id = `layer-${layer}`;
      box.checked = this.shown[layer];
      box.addEventListener("change", () => {
        this.shown[layer] = box.checked;
        this.scene?.show(layer, box.checked);
        this.update_layers();
        this.update_marks();
        this.redraw();
      });
      label.append(box, ` ${text}`);
      layers.append(label);
    }
  }

  /// Names of the stages below the slider, where they begin.
  private mark_stages(): void {
    const marks: [number, string][] = [];
    this.frames.forEach((f, i) => {
      if (i === 0 || f.stage !== this.frames[i - 1]!.stage) marks.push([i, f.stage]);
    });
    const last = Math.max(1, this.frames.length - 1);
    by_id("stages").replaceChildren();
    marks.forEach(([i, name], k) => {
      const mark = element("span", name);
      mark.title = name;
      mark.style.left = `${(100 * i) / last}%`;
      mark.style.width = `${(100 * ((marks[k + 1]?.[0] ?? last) - i)) / last}%`;
      by_id("stages").append(mark);
    });
  }

  // --------------------------------------------------------------------------------------- controls

  private bind(): void {
    const on = (id: string, event: string, act: () => void) => by_id(id).addEventListener(event, act);
    on("play", "click", () => this.play(!this.playing));
    on("follow", "click", () => (this.play(false), this.set_following(true)));
    on("back", "click", () => this.step(-1));
    on("next", "click", () => this.step(1));
    on("time", "input", () => this.seek(Number(by_id<HTMLInputElement>("time").value)));
    on("zoom-in", "click", () => this.zoom(1.3));
    on("zoom-out", "click", () => this.zoom(1 / 1.3));
    on("fit", "click", () => this.fit());
    on("save", "click", () => void this.save());
    on("film", "click", () => void this.film());
    on("contact-next", "click", () => this.contact_box.next(this.chosen));
    on("theme", "change", () => choose_theme(by_id<HTMLSelectElement>("theme").value));
    for (const id of ["field", "range", "factor"]) on(id, "change", () => this.choices_changed());
    on("block", "change", () => this.choose(Number(by_id<HTMLSelectElement>("block").value)));
    on("monitor-quantity", "change", () => this.draw_monitors());
    on("block-quantity", "change", () => this.draw_block());
    on("ledger-sides", "change", () => this.draw_ledger());
    document.addEventListener("keydown", (e) => this.key(e));
    on_theme(() => (this.use_theme(), this.redraw()));
    if (!this.scene) return;
    new ResizeObserver(() => {
      this.scene!.resize();
      if (this.own_view) this.redraw(true, true);
      else this.fit();
    }).observe(by_id("picture"));
    this.bind_pointer(by_id<HTMLCanvasElement>("view"), this.scene);
  }

  private bind_pointer(view: HTMLCanvasElement, scene: Scene): void {
    const pointers = new Map<number, [number, number]>();
    let moved = 0;
    view.addEventListener("pointerdown", (e) => {
      view.setPointerCapture(e.pointerId);
      pointers.set(e.pointerId, [e.offsetX, e.offsetY]);
      moved = 0;
    });
    view.addEventListener("pointermove", (e) => {
      const [x, y] = scene.place(e.offsetX, e.offsetY);
      by_id("pointer").textContent = `x = ${(x + this.run.origin[0]).toFixed(2)} m, y = ${(y + this.run.origin[1]).toFixed(2)} m`;
      const from = pointers.get(e.pointerId);
      if (!from) return;
      const [dx, dy] = [e.offsetX - from[0], e.offsetY - from[1]];
      moved += Math.abs(dx) + Math.abs(dy);
      if (pointers.size === 2) {
        const other = [...pointers].find(([id]) => id !== e.pointerId)![1];
        const spread = (p: number, q: number) => Math.hypot(p - other[0], q - other[1]);
        scene.zoom(spread(e.offsetX, e.offsetY) / Math.max(1, spread(...from)), other[0], other[1]);
      } else if (moved > 3) {
        scene.view.x -= dx / scene.view.scale;
        scene.view.y += dy / scene.view.scale;
      }
      pointers.set(e.pointerId, [e.offsetX, e.offsetY]);
      if (moved > 3) this.own_view = true;
      this.redraw(true);
    });
    const up = (e: PointerEvent) => pointers.delete(e.pointerId);
    view.addEventListener("pointercancel", up);
    view.addEventListener("pointerleave", () => (by_id("pointer").textContent = ""));
    view.addEventListener("pointerup", (e) => {
      up(e);
      if (moved <= 3 && this.mesh) {
        const [x, y] = scene.place(e.offsetX, e.offsetY);
        if (this.contact_box.clicked(x, y, this.shown.contacts || this.shown.slip ? scene.view.scale : 0)) return;
        const cell = cell_at(this.mesh, scene.position, x, y);
        this.choose(cell < 0 ? -1 : this.mesh.block[cell]!);
        if (cell >= 0) by_id("block-box").scrollIntoView({ block: "nearest" });
      }
    });
    view.addEventListener("wheel", (e) => {
      e.preventDefault();
      scene.zoom(Math.exp(-e.deltaY * (e.deltaMode === 1 ? 0.05 : 0.0015)), e.offsetX, e.offsetY);
      this.own_view = true;
      this.redraw(true);
    }, { passive: false });
  }

  private key(e: KeyboardEvent): void {
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    const target = e.target as HTMLElement;
    if (target.closest("input, select, textarea, pre, summary, .scroll")) return;
    const in_view = target.id === "view";
    const pan = (dx: number, dy: number) => {
      const view = this.scene!.view;
      view.x += (dx * 40) / view.scale;
      view.y += (dy * 40) / view.scale;
      this.own_view = true;
      this.redraw(true);
    };
    const pans: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    if (in_view && this.scene && pans[e.key]) {
      pan(...pans[e.key]!);
      e.preventDefault();
      return;
    }
    const acts: Record<string, () => void> = {
      " ": () => this.play(!this.playing), ArrowLeft: () => this.step(-1), ArrowRight: () => this.step(1),
      Home: () => this.seek(0), End: () => this.seek(this.frames.length - 1), "+": () => this.zoom(1.3), "=": () => this.zoom(1.3), "-": () => this.zoom(1 / 1.3),
      "0": () => this.fit(), s: () => void this.save(), S: () => void this.save(), v: () => void this.film(), V: () => void this.film(),
      c: () => this.contact_box.next(this.chosen), C: () => this.contact_box.next(this.chosen),
    };
    const act = acts[e.key];
    if (!act || (e.key === " " && target.tagName === "BUTTON")) return;
    e.preventDefault();
    act();
  }

  // ------------------------------------------------------------------------------------------- time

  private step(by: number): void {
    this.seek(Math.min(this.frames.length - 1, Math.max(0, this.wanted + by)));
  }

  /// Shows a frame and stops playing.
  private seek(index: number): void {
    this.led = false;
    this.play(false);
    if (this.source.live) this.set_following(false);
    void this.go(index).then(() => this.say());
  }

  private go_to_time(time: number): void {
    this.seek(this.index_at(time));
  }

  private index_at(time: number): number {
    let index = 0;
    this.frames.forEach((f, i) => {
      if (f.time <= time + 1e-9) index = i;
    });
    return index;
  }

  /// The frame asked for last is shown; those in between may be left out.
  private async go(index: number): Promise<void> {
    this.wanted = index;
    if (this.loading) return;
    this.loading = true;
    try {
      while (this.note !== this.frames[this.wanted]) {
        const now = this.wanted;
        const note = this.frames[now]!;
        const [frame, mesh] = await Promise.all([this.source.frame(now), this.source.mesh(note.mesh)]);
        if (this.mesh_index !== note.mesh) {
          this.mesh = mesh;
          this.mesh_index = note.mesh;
          this.scene?.use_mesh(mesh, this.held);
          if (this.source.live && this.scene) this.show_original();
        }
        this.frame = frame;
        this.index = Math.max(0, this.frames.indexOf(note)); // frames of a stream may have been thinned meanwhile
        this.note = note;
        this.update_places();
        this.update_colours();
        this.show_instant();
        this.redraw();
        if (!this.led) this.pair?.tell({ time: note.time });
      }
    } catch (error) {
      this.play(false);
      trouble(error);
    } finally {
      this.loading = false;
    }
  }

  private play(on: boolean): void {
    if (on === this.playing) return;
    if (on && this.source.live) this.set_following(false);
    if (on) this.led = false;
    this.playing = on;
    const button = by_id("play");
    button.textContent = on ? "Pause" : "Play";
    button.setAttribute("aria-pressed", String(on));
    if (!on) {
      if (this.index >= 0) this.show_instant();
      return this.say();
    }
    if (this.wanted >= this.frames.length - 1) this.wanted = 0;
    this.clock = this.frames[this.wanted]!.time;
    this.last_tick = performance.now();
    this.still = 0;
    const tick = (now: number) => {
      if (!this.playing) return;
      const passed = Math.min(250, Math.max(0, now - this.last_tick));
      this.last_tick = now;
      if (!this.loading) this.advance(passed);
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
    void this.go(this.wanted);
  }

  private advance(passed: number): void {
    const next = this.frames[this.wanted + 1];
    if (!next) return this.play(false);
    // Two frames of one instant, as where a stage ends and the next begins: each is seen.
    if (next.time <= this.frames[this.wanted]!.time) {
      this.still += passed;
      if (this.still >= FRAME_TIME) {
        this.still = 0;
        void this.go(this.wanted + 1);
      }
      return;
    }
    this.clock += (passed / 1000) * Number(by_id<HTMLSelectElement>("speed").value);
    let index = this.wanted;
    while (index + 1 < this.frames.length && this.frames[index + 1]!.time <= this.clock && this.frames[index + 1]!.time > this.frames[index]!.time) ++index;
    if (index !== this.wanted) void this.go(index);
    for (const ahead of [1, 2]) if (index + ahead < this.frames.length) void this.source.frame(index + ahead).catch(() => undefined);
  }

  private instant(): string {
    const f = this.frames[this.index]!;
    return `t = ${seconds(f.time)}, ${f.stage}`;
  }

  private show_instant(): void {
    const f = this.frames[this.index]!;
    by_id("instant").textContent = this.instant();
    const time = by_id<HTMLInputElement>("time");
    time.value = String(this.index);
    time.setAttribute("aria-valuetext", `${seconds(f.time)}, stage ${f.stage}, frame ${this.index + 1} of ${this.frames.length}`);
    by_id("view").setAttribute("aria-label", `The blocks at ${seconds(f.time)} in stage ${f.stage}, coloured by ${this.field.label}`);
    // What people read need not keep pace with what they see.
    const now = performance.now();
    if (this.playing && now - this.read_at < READING) return;
    this.read_at = now;
    for (const chart of this.charts) chart.at(f.time);
    this.show_block_facts();
    this.contact_box.show(this.frame?.contacts ?? null);
  }

  private say(): void {
    if (this.index >= 0) by_id("said").textContent = this.instant();
  }

  // ----------------------------------------------------------------------------------------- picture

  private use_theme(): void {
    this.scene?.use_theme({ ground: rgb_of("--paper"), ink: rgb_of("--edge"), held: rgb_of("--held"), hatch: rgb_of("--hatch"), original: rgb_of("--original") });
    if (!this.scene) return;
    this.show_original();
    const joints = joint_lines(this.run);
    this.scene.use_lines("joints", joints.ends, joints.tint);
    for (const layer of Object.keys(this.shown) as Layer[]) this.scene.show(layer, this.shown[layer]);
    if (this.frame) this.update_places();
  }

  /// The blocks as the model had them; a stream knows no more of them than its mesh.
  private show_original(): void {
    const colour = rgb_of("--original");
    this.scene!.use_original(this.source.live ? this.scene!.original_lines() : original_outline(this.run), colour);
  }

  private factor(): number {
    return Number(by_id<HTMLSelectElement>("factor").value);
  }

  private update_places(): void {
    if (!this.scene || !this.frame) return;
    this.scene.use_displacement(this.frame.displacement, this.factor());
    this.scene.choose(this.chosen);
    this.update_layers();
  }

  private update_layers(): void {
    if (!this.scene || !this.frame || !this.mesh) return;
    this.crosses = this.shown.crosses ? crosses(this.mesh, this.frame, this.scene.position, this.held, CROSS_SPACING / this.scene.view.scale) : null;
    if (this.crosses) this.scene.use_lines("crosses", this.crosses.ends, this.crosses.tint);
    this.forces = null;
    if (this.shown.contacts && this.frame.contacts) {
      const [x0, y0, x1, y1] = this.run.frames.bounds;
      this.forces = contact_lines(this.frame.contacts, 0.08 * Math.hypot(x1 - x0, y1 - y0));
      this.scene.use_lines("contacts", this.forces.ends, this.forces.tint);
    }
    const bolts = this.shown.bolts && this.frame.bolts ? bolt_lines(this.frame.bolts) : null;
    if (this.run.bolts) this.scene.use_lines("bolts", bolts?.ends ?? new Float32Array(0), bolts?.tint ?? new Uint8Array(0));
    this.most_bolt = bolts?.most ?? 0;
    this.most_slip = this.shown.slip && this.frame.contacts ? slip_lines(this.frame.contacts, 1).most : 0;
    this.show_layer_key();
  }

  /// What keeps its size on the screen: supports, slip, the chosen contact, and monitors with their names.
  private update_marks(): void {
    if (!this.scene || this.index < 0) return;
    const pixel = 1 / this.scene.view.scale;
    const supports = support_marks(this.run, rgb_of("--mark"), 11 * pixel);
    this.scene.use_lines("supports", supports.ends, supports.tint);
    const water = water_lines(this.run, 12 * pixel);
    this.scene.use_lines("water", water.ends, water.tint);
    if (this.shown.slip && this.frame?.contacts) {
      const slip = slip_lines(this.frame.contacts, 7 * pixel);
      this.scene.use_lines("slip", slip.ends, slip.tint);
    }
    const chosen = diamonds(this.contact_box.place, [230, 60, 0], 9 * pixel);
    this.scene.use_lines("contact", chosen.ends, chosen.tint);
    const time = this.frames[this.index]!.time;
    const places: [number, number][] = [];
    const labels: HTMLElement[] = [];
    this.labels = [];
    if (this.shown.monitors)
      this.run.history.monitors.forEach((m, i) => {
        const at = this.monitor_place(m.at, i, time);
        if (!at) return;
        places.push(at);
        const [px, py] = this.scene!.pixel(...at);
        const label = element("span", m.name);
        label.style.transform = `translate(${px + 8}px, ${py - 20}px)`;
        labels.push(label);
        this.labels.push([m.name, px + 12, py - 11]);
      });
    by_id("labels").replaceChildren(...labels);
    const marks = diamonds(places, rgb_of("--mark"), 5 * pixel);
    this.scene.use_lines("monitors", marks.ends, marks.tint);
  }

  /// Where a monitor is: its place in the model and the last stored displacement that is not later.
  private monitor_place(at: [number, number] | undefined, monitor: number, time: number): [number, number] | null {
    const times = this.rows.get(`m${monitor}.time`);
    const u = this.rows.get(`m${monitor}.u`);
    if (!at || !times || !u || times.length === 0) return null;
    let [low, high] = [0, times.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle]! <= time * (1 + 1e-6) + 1e-9) low = middle;
      else high = middle - 1;
    }
    return [at[0] + this.factor() * u[2 * low]!, at[1] + this.factor() * u[2 * low + 1]!];
  }

  private show_layer_key(): void {
    this.was_dense = this.scene?.dense ?? false;
    const key = by_id("layer-key");
    key.replaceChildren();
    const line = (entries: [Rgb, string][], more = "") => {
      const row = element("div");
      for (const [colour, text] of entries) {
        const swatch = element("span", undefined, "swatch");
        swatch.style.background = css(colour);
        row.append(swatch, `${text}  `);
      }
      row.append(more);
      key.append(row);
    };
    if (this.scene?.dense && (this.shown.outline || this.shown.original)) line([], "Outlines of blocks as small as here show when one zooms in.");
    if (this.run.model.blocks.some((b) => b.held)) line([], "Hatched: held or driven as a whole.");
    if (this.shown.joints) line(this.run.model.joints.laws.map((l, i) => [name_colour(i + 3), l.name]));
    if (this.crosses && this.crosses.stress > 0) line([[COMPRESSION, "compression"], [TENSION, "tension"]], `· Longest arm: ${quantity(this.crosses.stress, "Pa", 2)}.`);
    if (this.forces) {
      const f = this.forces;
      line([[STICKING, `sticking (${f.sticking})`], [SLIPPING, `slipping (${f.slipping})`], [FAILED, `slipping, strength failed (${f.failed})`]],
        f.force > 0 ? `${this.of_when()}· Longest line: ${quantity(f.force, "N", 2)} for 1 m of thickness.` : "· No forces.");
    }
    if (this.shown.slip && this.run.contacts) line([[mapped("magnitude", 0), "slip 0"], [mapped("magnitude", 1), `${quantity(this.most_slip, "m")} (largest now)`]]);
    if (this.shown.bolts && this.run.bolts) line([[mapped("magnitude", 0), "bolt force 0"], [mapped("magnitude", 1), `${quantity(this.most_bolt, "N")}/m (largest now)`]]);
    if (this.shown.water)
      for (const { joints } of this.run.model.water ?? [])
        line([[WATER, `water in ${joints.length === 0 ? "all joints" : joints.map((j) => this.run.model.joints.laws[j]?.name).join(", ")}`]]);
  }

  /// Of a stream: the instant of contacts, stresses and bolts where it is not that of the picture.
  private of_when(): string {
    const [time, of] = [this.note?.time, this.frame?.detail_time];
    return of === undefined || of === time ? "" : `at ${seconds(of)} `;
  }

  private names(): [string, Rgb][] {
    if (this.field.kind !== "names") return [];
    if (!this.field.names) return Array.from({ length: 10 }, (_, i) => ["", name_colour(i)] as [string, Rgb]);
    return this.field.names(this.run).map((n, i) => [n, this.field.colours?.[i] ?? name_colour(i)]);
  }

  private update_colours(): void {
    if (!this.scene || !this.frame || !this.mesh) return;
    const values = this.scene.values;
    corner_values(this.field, this.mesh, this.frame, values);
    const whole = this.run.frames.ranges[this.field.id];
    const of_run = by_id<HTMLSelectElement>("range").value === "run" && whole;
    const range = this.field.kind === "names" ? ([0, 1] as [number, number]) : of_run ? whole : frame_range(this.field, this.mesh, values, this.held);
    const names = this.names();
    this.scene.use_colours(this.field, range, names.map(([, c]) => c));
    this.legend = legend_text(this.field, range, names.filter(([n]) => n !== ""));
    if (STREAM_SCALARS.includes(this.field) && this.frame.scalar_field !== this.field.id)
      this.legend.what += has_field(this.field, this.mesh, this.frame) ? this.of_when() && `, ${this.of_when()}` : ": not in this frame";
    if (this.field.id === "joint") this.legend.what += ": the worst of their contacts";
    if (this.field.id === "block") this.legend.what = "block (neighbours differ in colour; the list below has the names)";
    show_legend(by_id("legend"), this.field, this.legend);
    by_id("view").setAttribute("aria-label", `The blocks at ${seconds(this.frames[this.index]!.time)} in stage ${this.frames[this.index]!.stage}, coloured by ${this.field.label}`);
  }

  /// @param moved  the view has, so what has a size on the screen is made anew   @param told  by the page beside
  private redraw(moved = false, told = false): void {
    if (moved && this.own_view && !told && this.scene) {
      const { x, y, scale } = this.scene.view;
      this.pair?.tell({ view: [x + this.run.origin[0], y + this.run.origin[1], scale] });
    }
    if (moved && this.shown.crosses) this.update_layers();
    else if (this.scene && this.scene.dense !== this.was_dense) this.show_layer_key();
    if (this.draw_asked || !this.scene) return;
    this.draw_asked = true;
    requestAnimationFrame(() => {
      this.draw_asked = false;
      this.update_marks();
      this.scene!.render();
      this.show_scale();
    });
  }

  private show_scale(): void {
    const scale = this.scene!.view.scale;
    const metres = round_below(140 / scale);
    const unit = prefixed("m", metres);
    this.scale_bar = { pixels: metres * scale, text: metres >= 1000 ? `${metres / 1000} km` : `${Number((metres / unit.factor).toPrecision(3))} ${unit.name}` };
    by_id("scale-bar").style.width = `${this.scale_bar.pixels}px`;
    by_id("scale-text").textContent = this.scale_bar.text;
  }

  private fit(told = false): void {
    if (!told && this.own_view) this.pair?.tell({ fit: true });
    this.own_view = false;
    this.scene?.fit(...this.run.frames.bounds);
    this.redraw(true);
  }

  private zoom(factor: number): void {
    this.own_view = true;
    this.scene?.zoom(factor, 0.5 * this.scene.width, 0.5 * this.scene.height);
    this.redraw(true);
  }

  private picture_text(): PictureText {
    return {
      title: this.run.title || "Scree run", instant: this.instant(), scale: this.scale_bar, field: this.field, legend: this.legend, dark: is_dark(), labels: this.labels,
    };
  }

  private hand_out(blob: Blob, name: string): void {
    const link = element("a");
    link.href = URL.createObjectURL(blob);
    link.download = `${this.run.folder || "scree"}-${this.field.id}-${name}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  private async save(): Promise<void> {
    if (!this.scene) return;
    this.scene.render();
    this.hand_out(await png_of(draw_picture(this.scene.canvas, this.picture_text())), `${this.frames[this.index]!.time.toFixed(3)}s.png`);
  }

  /// Saves the animation as it is shown, at the speed that is chosen; a second time: ends it early.
  private async film(): Promise<void> {
    if (this.filming) {
      this.filming = false;
      return;
    }
    if (!this.scene) return;
    this.play(false);
    if (this.source.live) this.set_following(false);
    const before = this.index;
    this.filming = true;
    const button = by_id<HTMLButtonElement>("film");
    button.setAttribute("aria-pressed", "true");
    try {
      const film = await make_film(this.film_steps(), (step, sheet) => this.film_picture(step, sheet), (share) => {
        button.textContent = `Stop (${Math.round(100 * share)} %)`;
        return this.filming;
      });
      this.hand_out(film, "film.webm");
      this.tell("The film is saved.");
    } catch (error) {
      this.tell(`The film cannot be made: ${error instanceof Error ? error.message : String(error)}`);
    } finally {
      this.filming = false;
      button.textContent = "Film";
      button.setAttribute("aria-pressed", "false");
      void this.go(before);
    }
  }

  private async film_picture(step: number, sheet: HTMLCanvasElement): Promise<void> {
    if (step !== this.index) await this.go(step);
    this.update_marks();
    this.scene!.render();
    draw_picture(this.scene!.canvas, this.picture_text(), sheet);
  }

  /// The frame of each picture of a film.
  private film_steps(): number[] {
    const [first, last] = [this.frames[0]!.time, this.frames[this.frames.length - 1]!.time];
    return film_times(first, last, Number(by_id<HTMLSelectElement>("speed").value)).map((t) => this.index_at(t));
  }

  private tell(text: string): void {
    by_id("said").textContent = text;
    by_id("note").textContent = text;
    by_id("note").hidden = false;
    setTimeout(() => (by_id("note").hidden = true), 6000);
  }

  // ------------------------------------------------------------------------------------------ block

  private choose(block: number): void {
    this.chosen = block;
    by_id<HTMLSelectElement>("block").value = String(block);
    this.scene?.choose(block);
    this.redraw();
    this.show_block_facts();
    by_id("block-figure").hidden = block < 0;
    if (block >= 0 && !MODEL) void this.follow_block(block);
  }

  /// Means over the cells of a block, weighted by their areas in the model: displacement, velocity, stress.
  private block_mean(mesh: Mesh, frame: Frame, block: number, areas: Float64Array): number[] | null {
    const sum = new Float64Array(7);
    let area = 0;
    for (let c = 0; c < areas.length; ++c) {
      if (mesh.block[c] !== block) continue;
      const first = mesh.offsets[c]!;
      const end = mesh.offsets[c + 1]!;
      const weight = areas[c]! / (end - first);
      area += areas[c]!;
      for (let i = first; i < end; ++i) {
        const p = mesh.cells[i]!;
        for (const k of [0, 1]) {
          sum[k] += weight * frame.displacement[2 * p + k]!;
          sum[2 + k] += weight * frame.velocity[2 * p + k]!;
        }
        for (const k of [0, 1, 2]) sum[4 + k] += weight * frame.stress[3 * p + k]!;
      }
    }
    return area > 0 ? Array.from(sum, (s) => s / area) : null;
  }

  private show_block_facts(): void {
    const box = by_id("block-facts");
    const block = this.run.model.blocks[this.chosen];
    if (!block || !this.mesh || !this.frame) return box.replaceChildren();
    const cell = this.mesh.block.indexOf(this.chosen);
    const mean = cell < 0 ? null : this.block_mean(this.mesh, this.frame, this.chosen, this.areas(this.mesh));
    const area = block.rings.length > 0 ? this.ring_area(block.rings) : this.areas(this.mesh).reduce((sum, a, c) => (this.mesh!.block[c] === this.chosen ? sum + a : sum), 0);
    const rows: [string, string | undefined][] = [
      ["Material", this.run.model.materials[block.material]?.name],
      ["Area", `${short(area)} m²`],
      ["Held", block.held ? "yes" : undefined],
    ];
    if (mean && cell >= 0) {
      const radius = Math.hypot(0.5 * (mean[4]! - mean[5]!), mean[6]!);
      const middle = 0.5 * (mean[4]! + mean[5]!);
      rows.push(
        ["Method", `${(this.run.model.methods[this.mesh.method[cell]!] ?? "").toUpperCase()}${this.frame.integrator.length === 0 ? "" : this.frame.integrator[cell] === 0 ? ", explicit" : ", implicit"}`],
        ["Displacement", `${quantity(Math.hypot(mean[0]!, mean[1]!), "m")} (${quantity(mean[0]!, "m")}, ${quantity(mean[1]!, "m")})`],
      );
      if (!this.source.live) rows.push(["Speed", quantity(Math.hypot(mean[2]!, mean[3]!), "m/s")]);
      if (this.frame.stress.length > 0)
        rows.push(["Mean σ₁, σ₃", `${quantity(middle + radius, "Pa")}, ${quantity(middle - radius, "Pa")}`]);
      const contacts = this.frame.contacts;
      if (contacts) {
        let touching = 0;
        for (let i = 0; i < contacts.state.length; ++i) if (contacts.blocks[3 * i] === this.chosen || contacts.blocks[3 * i + 1] === this.chosen) touching += 1;
        rows.push(["Closed contacts", String(touching)]);
      }
    }
    pairs(box, rows);
  }

  private readonly area_of = new WeakMap<Mesh, Float64Array>();
  private areas(mesh: Mesh): Float64Array {
    let found = this.area_of.get(mesh);
    if (!found) this.area_of.set(mesh, (found = cell_areas(mesh)));
    return found;
  }

  /// The outer ring less the holes.
  private ring_area(rings: number[][]): number {
    const areas = rings.map((r) => {
      let twice = 0;
      for (let i = 0; i < r.length; i += 2) {
        const j = (i + 2) % r.length;
        twice += r[i]! * r[j + 1]! - r[j]! * r[i + 1]!;
      }
      return Math.abs(0.5 * twice);
    });
    return areas.reduce((sum, a, i) => (i === 0 ? a : sum - a), 0);
  }

  /// Reads all frames for the history of one block; another choice ends it.
  private async follow_block(block: number): Promise<void> {
    const time: number[] = [];
    const rows: number[][] = [];
    const stride = this.source.live ? Math.ceil(this.frames.length / LIVE_HISTORY) : 1; // a stream is read again and again
    for (let i = 0; i < this.frames.length && this.chosen === block; i += stride) {
      const note = this.frames[i]!;
      const [frame, mesh] = await Promise.all([this.source.frame(i), this.source.mesh(note.mesh)]);
      const mean = this.block_mean(mesh, frame, block, this.areas(mesh));
      if (!mean) continue;
      time.push(note.time);
      rows.push(mean);
    }
    if (this.chosen !== block) return;
    this.block_history = { block, time: Float64Array.from(time), rows: rows.map((r) => Float64Array.from(r)) };
    this.draw_block();
  }

  private draw_block(): void {
    const history = this.block_history;
    if (!history || history.block !== this.chosen) return;
    if (!this.block_chart) this.charts.push((this.block_chart = this.chart("block-chart", 220)));
    by_id("block-title").textContent = `Block ${this.run.model.blocks[history.block]!.name}`;
    const what = by_id<HTMLSelectElement>("block-quantity").value;
    const principal = (r: Float64Array, sign: number) => 0.5 * (r[4]! + r[5]!) + sign * Math.hypot(0.5 * (r[4]! - r[5]!), r[6]!);
    const pick: Record<string, (r: Float64Array) => number> = {
      displacement: (r) => Math.hypot(r[0]!, r[1]!), "horizontal displacement": (r) => r[0]!, "vertical displacement": (r) => r[1]!,
      speed: (r) => Math.hypot(r[2]!, r[3]!), "principal stress σ₁": (r) => principal(r, 1), "principal stress σ₃": (r) => principal(r, -1),
    };
    const unit = what.includes("stress") ? "Pa" : what === "speed" ? "m/s" : "m";
    const series: Series[] = [{ label: `mean ${what}`, values: history.rows.map(pick[what]!) }];
    this.block_chart.draw({ what, unit }, history.time, series);
    this.block_chart.at(this.frames[this.index]!.time);
  }

  // ----------------------------------------------------------------------------------------- charts

  private chart(id: string, height: number): Chart {
    return new Chart(by_id(id), height, this.run.stages, (t) => this.go_to_time(t));
  }

  private monitor_chart: Chart | null = null;
  private ledger_chart: Chart | null = null;

  private closure_chart: Chart | null = null;

  private make_charts(): void {
    if (MODEL) return;
    by_id("monitor-figure").hidden = this.run.history.monitors.length === 0;
    if (this.run.history.monitors.length > 0) {
      if (!this.monitor_chart) this.charts.push((this.monitor_chart = this.chart("monitor-chart", 240)));
      this.draw_monitors();
    }
    if (!this.ledger_chart) this.charts.push((this.ledger_chart = this.chart("energy-chart", 240)));
    this.draw_ledger();
    const values = closure(this.rows);
    if (values.some((v) => v > 0)) {
      if (!this.closure_chart) this.charts.push((this.closure_chart = this.chart("closure-chart", 200)));
      this.closure_chart.draw({ what: "|closure| / moved", unit: "", log: true }, this.rows.get("l.time")!, [{ label: "closure", values }]);
    } else by_id("closure-chart").textContent = "Zero at every stored time.";
    for (const chart of this.charts) chart.at(this.frames[this.index]!.time);
  }

  private draw_monitors(): void {
    const quantity_ = by_id<HTMLSelectElement>("monitor-quantity").value;
    const { time, series, unit } = monitor_series(this.run, this.rows, quantity_);
    this.monitor_chart?.draw({ what: quantity_, unit }, time, series);
    this.describe("monitor-chart", `Histories of the monitors, ${quantity_}`, series, unit);
  }

  private draw_ledger(): void {
    const sides = by_id<HTMLSelectElement>("ledger-sides").value.split(" ");
    const series = ledger_series(this.run, this.rows, sides);
    this.ledger_chart?.draw({ what: "energy", unit: "J" }, this.rows.get("l.time") ?? [], series);
    this.describe("energy-chart", "Energy ledger over time", series, "J");
  }

  /// What a screen reader says of a chart: its last values.
  private describe(id: string, what: string, series: Series[], unit: string): void {
    const ends = series.map((s) => `${s.label} ${quantity(s.values[s.values.length - 1] ?? NaN, unit)}`);
    by_id(id).setAttribute("aria-label", `${what}. At the end: ${ends.join("; ")}`);
  }
}

/// Where the data of this page are: `data-source` of the body as the server wrote it, none in a report.
async function open_source(): Promise<Source> {
  const kind = document.body.dataset.source;
  if (kind === undefined) return new ReportSource();
  if (kind !== "live") return ServedSource.open();
  const source = await LiveSource.open((what) => (by_id("subtitle").textContent = what));
  return source;
}

void open_source()
  .then((source) => new Page(source).start())
  .catch(trouble);
