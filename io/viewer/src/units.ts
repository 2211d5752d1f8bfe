// Numbers as people read them.

/// A unit with a prefix: value in SI = value shown * factor.
export interface Unit {
  factor: number;
  name: string;
}

const PREFIXES: [number, string][] = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"]];

/// The prefix that brings `largest` between 1 and 1000; for lengths, speeds and times none above 1.
export function prefixed(si: string, largest: number): Unit {
  if (si === "") return { factor: 1, name: "" };
  const small_only = si === "m" || si === "m/s" || si === "s";
  for (const [factor, prefix] of PREFIXES) {
    if (small_only && factor > 1) continue;
    if (largest >= factor * (factor === 1 && small_only ? 0.1 : 1)) return { factor, name: prefix + si };
  }
  return largest > 0 ? { factor: 1e-6, name: "µ" + si } : { factor: 1, name: si };
}

/// About `digits` significant digits, without an exponent where a reader needs none.
export function short(value: number, digits = 3): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    return `${minus(mantissa!)}·10${superscript(Number(exponent))}`;
  }
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return minus(value.toFixed(Math.min(decimals, 8)));
}

export function quantity(value: number, si: string, digits = 3): string {
  const unit = prefixed(si, Math.abs(value));
  return unit.name ? `${short(value / unit.factor, digits)} ${unit.name}` : short(value, digits);
}

export function seconds(time: number): string {
  return `${time.toFixed(3)} s`;
}

export function minus(text: string): string {
  return text.replace("-", "−");
}

export function superscript(exponent: number): string {
  const digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  return String(exponent)
    .split("")
    .map((c) => (c === "-" ? "⁻" : digits[Number(c)]))
    .join("");
}

/// The largest of 1, 2, 5 times a power of ten that is not above x > 0.
export function round_below(x: number): number {
  const power = 10 ** Math.floor(Math.log10(x));
  for (const step of [5, 2]) if (step * power <= x) return step * power;
  return power;
}
