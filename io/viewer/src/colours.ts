// Colour maps: viridis for magnitudes, blue through white to red for signed fields, distinct colours for names.

export type Rgb = [number, number, number]; // 0 to 255

const VIRIDIS = ["440154", "482878", "3e4a89", "31688e", "26828e", "1f9e89", "35b779", "6ece58", "b5de2b", "fde725"];
const DIVERGING = ["053061", "2166ac", "4393c3", "92c5de", "d1e5f0", "f7f7f7", "fddbc7", "f4a582", "d6604d", "b2182b", "67001f"];
// Paul Tol's muted scheme: told apart by colour-blind readers as well.
const DISTINCT = ["88ccee", "ddcc77", "44aa99", "cc6677", "999933", "aa4499", "117733", "6699cc", "ee99aa", "997700"];

const rgb = (hex: string): Rgb => [0, 2, 4].map((i) => parseInt(hex.slice(i, i + 2), 16)) as Rgb;
const STOPS = { magnitude: VIRIDIS.map(rgb), signed: DIVERGING.map(rgb) };
const NAMES = DISTINCT.map(rgb);

export function mapped(kind: "magnitude" | "signed", x: number): Rgb {
  const stops = STOPS[kind];
  const at = Math.min(1, Math.max(0, x)) * (stops.length - 1);
  const i = Math.min(stops.length - 2, Math.floor(at));
  return [0, 1, 2].map((k) => Math.round(stops[i]![k]! + (at - i) * (stops[i + 1]![k]! - stops[i]![k]!))) as Rgb;
}

/// 256 colours, RGBA a colour.
export function table(kind: "magnitude" | "signed"): Uint8Array {
  const out = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) out.set([...mapped(kind, i / 255), 255], 4 * i);
  return out;
}

export const name_colour = (index: number): Rgb => NAMES[index % NAMES.length]!;
export const css = (c: Rgb): string => `rgb(${c[0]}, ${c[1]}, ${c[2]})`;

/// Lines of charts that read on a light and on a dark ground.
export function line_colour(index: number, dark: boolean): string {
  const light = ["#0072b2", "#c0392b", "#007a5e", "#8e44ad", "#a86500", "#2c3e50", "#b8327a", "#4d6b00", "#0099a8", "#7a5230"];
  const night = ["#56b4e9", "#ff8a75", "#3fd6a8", "#d09bf0", "#f5b942", "#c9d4dd", "#ff8fc7", "#b5d65a", "#5ee0ec", "#d9ad80"];
  return (dark ? night : light)[index % light.length]!;
}
