// The legend: what a colour means, with units.
import { css, mapped, type Rgb } from "./colours";
import type { Field } from "./fields";
import { element } from "./tables";
import { prefixed, short } from "./units";

export interface LegendText {
  what: string; // "displacement [m]"
  ticks: string[]; // from low to high
  names: [string, Rgb][];
}

export function legend_text(field: Field, range: [number, number], names: [string, Rgb][]): LegendText {
  if (field.kind === "names") return { what: field.label, ticks: [], names };
  const unit = prefixed(field.unit, Math.max(Math.abs(range[0]), Math.abs(range[1])));
  const ticks = [0, 0.25, 0.5, 0.75, 1].map((x) => short((range[0] + x * (range[1] - range[0])) / unit.factor));
  return { what: `${field.label} [${unit.name}]${field.unit === "Pa" && field.kind === "signed" ? ", tension positive" : ""}`, ticks, names: [] };
}

export function show_legend(into: HTMLElement, field: Field, text: LegendText): void {
  if (field.kind === "names") {
    const list = element("div", undefined, "names");
    for (const [name, colour] of text.names) {
      const entry = element("span");
      const swatch = element("span", undefined, "swatch");
      swatch.style.background = css(colour);
      entry.append(swatch, name);
      list.append(entry);
    }
    into.replaceChildren(element("div", text.what, "what"), list);
    return;
  }
  const kind = field.kind;
  const ramp = element("div", undefined, "ramp");
  ramp.style.background = `linear-gradient(to right, ${Array.from({ length: 17 }, (_, i) => css(mapped(kind, i / 16))).join(", ")})`;
  const ticks = element("div", undefined, "ticks");
  for (const t of text.ticks) ticks.append(element("span", t));
  into.replaceChildren(ramp, ticks, element("div", text.what, "what"));
}
