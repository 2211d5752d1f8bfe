// Curves over time: monitors, the energy ledger, its closure, the history of a block.
import uPlot from "uplot";
import { line_colour } from "./colours";
import type { Run, Stage } from "./source";
import { is_dark, on_theme } from "./theme";
import { prefixed, short, superscript } from "./units";

export interface Series {
  label: string;
  values: ArrayLike<number>; // SI
  dash?: number[];
}

export interface ChartText {
  what: string; // "displacement"
  unit: string; // SI; empty: none
  log?: boolean;
}

const style = (name: string) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/// One chart in an element; made anew when its data or the colours of the page change.
export class Chart {
  private plot: uPlot | null = null;
  private mark: HTMLElement | null = null;
  private time = 0;
  private remake: (() => void) | null = null;

  constructor(private readonly element: HTMLElement, private readonly height: number, private readonly stages: Stage[],
              private readonly on_time: (time: number) => void) {
    on_theme(() => this.remake?.());
    new ResizeObserver(() => this.plot?.setSize({ width: this.width(), height: this.height })).observe(element);
  }

  private width(): number {
    return Math.max(200, this.element.clientWidth);
  }

  draw(text: ChartText, time: ArrayLike<number>, series: Series[]): void {
    this.remake = () => this.make(text, time, series);
    this.make(text, time, series);
  }

  private make(text: ChartText, time: ArrayLike<number>, series: Series[]): void {
    this.plot?.destroy();
    this.element.replaceChildren();
    let most = 0;
    for (const s of series) for (let i = 0; i < s.values.length; ++i) if (Number.isFinite(s.values[i])) most = Math.max(most, Math.abs(s.values[i]!));
    const unit = text.log ? { factor: 1, name: text.unit } : prefixed(text.unit, most);
    const shown = (values: ArrayLike<number>) =>
      Array.from(values, (v) => (!Number.isFinite(v) || (text.log && !(v > 0)) ? null : v / unit.factor));
    const ink = style("--ink");
    const grid = { stroke: style("--line"), width: 1 };
    const axis = { stroke: ink, grid, ticks: grid, font: "11px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif", labelSize: 20 };
    const label = `${text.what}${unit.name ? ` [${unit.name}]` : ""}`;
    const options: uPlot.Options = {
      width: this.width(),
      height: this.height,
      scales: { x: { time: false }, y: text.log ? { distr: 3 } : {} },
      axes: [
        { ...axis, label: "time [s]" },
        { ...axis, label, size: 58, values: (_u, ticks) => ticks.map((t) => (t === null ? "" : text.log ? `10${superscript(Math.round(Math.log10(t)))}` : tick(t))),
          ...(text.log ? { splits: (_u: uPlot, _i: number, low: number, high: number) => decades(low, high), filter: (_u: uPlot, all: number[]) => all } : {}) },
      ],
      series: [
        { label: "time", value: (_u, v) => (v == null ? "–" : `${v.toFixed(3)} s`) },
        ...series.map((s, i) => ({
          label: s.label, stroke: line_colour(i, is_dark()), width: 1.5, points: { show: false },
          ...(s.dash ? { dash: s.dash } : {}),
          value: (_u: uPlot, v: number | null) => (v == null ? "–" : `${short(v)}${unit.name ? ` ${unit.name}` : ""}`),
        })),
      ],
      cursor: { drag: { x: true, y: false }, points: { size: 6 } },
      hooks: {
        drawClear: [(u) => this.draw_stages(u)],
        ready: [(u) => {
          this.mark = document.createElement("div");
          this.mark.className = "now";
          u.over.append(this.mark);
          u.over.addEventListener("mouseleave", () => setTimeout(() => this.at(this.time)));
          u.over.addEventListener("click", (e) => this.on_time(u.posToVal(e.offsetX, "x")));
        }],
        setSize: [() => this.at(this.time)],
        setScale: [() => this.at(this.time)],
      },
    };
    this.plot = new uPlot(options, [Array.from(time), ...series.map((s) => shown(s.values))] as uPlot.AlignedData, this.element);
    setTimeout(() => this.at(this.time)); // the scales have their ranges once the present task is over
  }

  /// Upright lines where stages begin.
  private draw_stages(u: uPlot): void {
    const c = u.ctx;
    c.save();
    c.strokeStyle = c.fillStyle = style("--quiet");
    c.font = `${Math.round(10 * devicePixelRatio)}px system-ui, sans-serif`;
    c.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio]);
    let free = -Infinity;
    for (const stage of this.stages) {
      if (stage.start === null) continue;
      const x = u.valToPos(stage.start, "x", true);
      if (x < u.bbox.left - 1 || x > u.bbox.left + u.bbox.width) continue;
      if (x > u.bbox.left + 1) {
        c.beginPath();
        c.moveTo(x, u.bbox.top);
        c.lineTo(x, u.bbox.top + u.bbox.height);
        c.stroke();
      }
      if (x < free) continue;
      c.fillText(stage.name, x + 3, u.bbox.top - 3);
      free = x + 6 + c.measureText(stage.name).width;
    }
    c.restore();
  }

  /// Marks the instant that the picture shows.
  at(time: number): void {
    this.time = time;
    if (!this.plot || !this.mark) return;
    const x = this.plot.valToPos(time, "x");
    this.mark.style.transform = `translateX(${Math.round(x)}px)`;
    this.mark.hidden = !(x >= 0 && x <= this.plot.over.clientWidth);
    // The legend gives the values of that instant, unless the pointer is over the chart.
    if (!this.plot.over.matches(":hover")) this.plot.setLegend({ idx: this.plot.posToIdx(x) });
  }
}

/// Powers of ten from low to high, at most seven.
function decades(low: number, high: number): number[] {
  const [first, last] = [Math.ceil(Math.log10(low) - 1e-9), Math.floor(Math.log10(high) + 1e-9)];
  const stride = Math.max(1, Math.ceil((last - first + 1) / 7));
  const out: number[] = [];
  for (let e = first; e <= last; e += stride) out.push(10 ** e);
  return out;
}

function tick(value: number): string {
  return Math.abs(value) >= 1e5 ? value.toExponential(1) : String(Number(value.toPrecision(6))).replace("-", "−");
}

type Rows = Map<string, Float32Array>;

/// Columns of the ledger that show: a thousandth of the largest is less than the width of a line.
export function ledger_series(run: Run, rows: Rows, sides: string[]): Series[] {
  const largest = (v: Float32Array) => v.reduce((m, x) => (Number.isFinite(x) ? Math.max(m, Math.abs(x)) : m), 0);
  const columns = run.history.ledger.map((c, i) => ({ ...c, values: rows.get(`l.${i}`) ?? new Float32Array(0) }));
  const most = Math.max(0, ...columns.filter((c) => sides.includes(c.side)).map((c) => largest(c.values)));
  const dash: Record<string, number[]> = { work: [6, 3], dissipated: [8, 3, 2, 3], scheme: [2, 3] };
  return sides.flatMap((side) =>
    columns
      .filter((c) => c.side === side && largest(c.values) > 1e-3 * most)
      .map((c) => ({ label: `${c.name.replaceAll("_", " ")} (${side === "dissipated" ? "dissipation" : side})`, values: c.values, dash: dash[side] })),
  );
}

/// |closure| over the energy moved.
export function closure(rows: Rows): Float32Array {
  const gap = rows.get("l.closure") ?? new Float32Array(0);
  const moved = rows.get("l.moved") ?? new Float32Array(0);
  return gap.map((c, i) => (moved[i]! > 0 ? Math.abs(c) / moved[i]! : 0));
}

export const MONITOR_QUANTITIES = ["displacement", "horizontal displacement", "vertical displacement", "speed", "principal stress σ₁", "principal stress σ₃"];

export function monitor_series(run: Run, rows: Rows, quantity: string): { time: Float32Array; series: Series[]; unit: string } {
  const pick = (at: string): Float32Array => {
    const u = rows.get(`${at}u`) ?? new Float32Array(0);
    const v = rows.get(`${at}v`) ?? new Float32Array(0);
    const s = rows.get(`${at}s`) ?? new Float32Array(0);
    const every = (length: number, f: (i: number) => number) => Float32Array.from({ length }, (_, i) => f(i));
    const principal = (i: number, sign: number) =>
      0.5 * (s[3 * i]! + s[3 * i + 1]!) + sign * Math.hypot(0.5 * (s[3 * i]! - s[3 * i + 1]!), s[3 * i + 2]!);
    if (quantity === "displacement") return every(u.length / 2, (i) => Math.hypot(u[2 * i]!, u[2 * i + 1]!));
    if (quantity === "horizontal displacement") return every(u.length / 2, (i) => u[2 * i]!);
    if (quantity === "vertical displacement") return every(u.length / 2, (i) => u[2 * i + 1]!);
    if (quantity === "speed") return every(v.length / 2, (i) => Math.hypot(v[2 * i]!, v[2 * i + 1]!));
    return every(s.length / 3, (i) => principal(i, quantity.endsWith("σ₁") ? 1 : -1));
  };
  const unit = quantity.includes("stress") ? "Pa" : quantity === "speed" ? "m/s" : "m";
  const time = rows.get("m0.time") ?? new Float32Array(0);
  const series = run.history.monitors.map((m, i) => ({ label: m.name, values: pick(`m${i}.`) }));
  return { time, series, unit };
}
