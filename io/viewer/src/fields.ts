// The fields that blocks can be coloured by: a number at each corner of each cell.
import type { Rgb } from "./colours";
import { block_rank, STATE_COLOURS, STATE_NAMES } from "./contacts";
import type { Frame, Mesh, Run } from "./source";

export interface Field {
  id: string;
  label: string;
  unit: string; // SI; empty: names, not numbers
  kind: "magnitude" | "signed" | "names";
  /// At point p.
  point?: (f: Frame, p: number) => number;
  /// Of cell c, for names: their number.
  cell?: (m: Mesh, f: Frame, c: number) => number;
  names?: (run: Run) => string[];
  colours?: Rgb[]; // of the names; without: as name_colour has them
}

const length = (x: number, y: number) => Math.sqrt(x * x + y * y); // Math.hypot takes ten times as long
const mean = (f: Frame, p: number) => 0.5 * (f.stress[3 * p]! + f.stress[3 * p + 1]!);
const radius = (f: Frame, p: number) => length(0.5 * (f.stress[3 * p]! - f.stress[3 * p + 1]!), f.stress[3 * p + 2]!);

export const FIELDS: Field[] = [
  { id: "displacement", label: "displacement", unit: "m", kind: "magnitude", point: (f, p) => length(f.displacement[2 * p]!, f.displacement[2 * p + 1]!) },
  { id: "ux", label: "horizontal displacement", unit: "m", kind: "signed", point: (f, p) => f.displacement[2 * p]! },
  { id: "uy", label: "vertical displacement", unit: "m", kind: "signed", point: (f, p) => f.displacement[2 * p + 1]! },
  { id: "speed", label: "speed", unit: "m/s", kind: "magnitude", point: (f, p) => length(f.velocity[2 * p]!, f.velocity[2 * p + 1]!) },
  { id: "vx", label: "horizontal velocity", unit: "m/s", kind: "signed", point: (f, p) => f.velocity[2 * p]! },
  { id: "vy", label: "vertical velocity", unit: "m/s", kind: "signed", point: (f, p) => f.velocity[2 * p + 1]! },
  { id: "s1", label: "principal stress σ₁ (larger)", unit: "Pa", kind: "signed", point: (f, p) => mean(f, p) + radius(f, p) },
  { id: "s3", label: "principal stress σ₃ (smaller)", unit: "Pa", kind: "signed", point: (f, p) => mean(f, p) - radius(f, p) },
  { id: "shear", label: "maximum shear stress", unit: "Pa", kind: "magnitude", point: radius },
  { id: "sxx", label: "stress σxx", unit: "Pa", kind: "signed", point: (f, p) => f.stress[3 * p]! },
  { id: "syy", label: "stress σyy", unit: "Pa", kind: "signed", point: (f, p) => f.stress[3 * p + 1]! },
  { id: "sxy", label: "shear stress σxy", unit: "Pa", kind: "signed", point: (f, p) => f.stress[3 * p + 2]! },
  { id: "method", label: "method", unit: "", kind: "names", cell: (m, _f, c) => m.method[c]!, names: (r) => r.model.methods.map((n) => n.toUpperCase()) },
  { id: "integrator", label: "time integrator", unit: "", kind: "names", cell: (_m, f, c) => f.integrator[c]!, names: () => ["explicit", "implicit"] },
  { id: "joint", label: "joint state of the blocks", unit: "", kind: "names", cell: (m, f, c) => block_rank(f.contacts, m.block[c]!), names: () => STATE_NAMES, colours: STATE_COLOURS },
  { id: "material", label: "material", unit: "", kind: "names", cell: (m, _f, c) => m.material[c]!, names: (r) => r.model.materials.map((m) => m.name) },
  { id: "block", label: "block", unit: "", kind: "names", cell: (m, _f, c) => m.block[c]! },
];

export const NO_VALUE = 3e38; // drawn in grey: this frame has not that field

/// A field of a stream at cell c from what DETAIL brings: stress and contacts, of the frame's instant or a little before it.
function of_detail(field: Field, m: Mesh, f: Frame, c: number): number {
  if (field.id === "joint") return f.contacts ? block_rank(f.contacts, m.block[c]!) : NO_VALUE;
  const at = field.id === "mean_stress" ? mean : field.unit === "Pa" ? field.point : undefined;
  if (!at || f.stress.length === 0) return NO_VALUE;
  const [first, end] = [m.offsets[c]!, m.offsets[c + 1]!];
  let sum = 0;
  for (let i = first; i < end; ++i) sum += at(f, m.cells[i]!) / (end - first);
  return sum;
}

/// Those of a stream: its frames have displacements, and the one scalar a cell that was asked for (io/live/live_field.h), which a name tells.
export const STREAM_SCALARS: Field[] = [
  ...FIELDS.filter((f) => f.id === "speed"),
  { id: "mean_stress", label: "mean stress", unit: "Pa", kind: "signed" } as Field,
  ...FIELDS.filter((f) => ["s1", "s3", "shear", "sxx", "syy", "sxy", "joint", "integrator"].includes(f.id)),
].map(({ point, ...f }) => ({ ...f, cell: (m: Mesh, frame: Frame, c: number) => (frame.scalar_field === f.id ? frame.scalar![c]! : of_detail({ ...f, point }, m, frame, c)) }));

/// Whether a frame of a stream has a field.
export const has_field = (field: Field, m: Mesh, f: Frame): boolean => !STREAM_SCALARS.includes(field) || m.block.length === 0 || field.cell!(m, f, 0) < NO_VALUE / 2;

export const STREAM_FIELDS: Field[] = [
  ...FIELDS.filter((f) => ["displacement", "ux", "uy"].includes(f.id)), ...STREAM_SCALARS, ...FIELDS.filter((f) => ["method", "material", "block"].includes(f.id)),
];

/// A value a corner (entry of mesh.cells).
export function corner_values(field: Field, mesh: Mesh, frame: Frame, out: Float32Array): void {
  const points = field.point ? new Float32Array(mesh.origin.length / 2) : null;
  if (points) for (let p = 0; p < points.length; ++p) points[p] = field.point!(frame, p);
  for (let c = 0; c + 1 < mesh.offsets.length; ++c) {
    const of_cell = field.cell ? field.cell(mesh, frame, c) : 0;
    for (let i = mesh.offsets[c]!; i < mesh.offsets[c + 1]!; ++i) out[i] = points ? points[mesh.cells[i]!]! : of_cell;
  }
}

/// What the colours span in one frame: all values of a magnitude, 99 % of the corners of a signed field.
export function frame_range(field: Field, mesh: Mesh, values: Float32Array, held: (block: number) => boolean): [number, number] {
  const sizes: number[] = [];
  for (let c = 0; c + 1 < mesh.offsets.length; ++c) {
    if (held(mesh.block[c]!)) continue;
    for (let i = mesh.offsets[c]!; i < mesh.offsets[c + 1]!; ++i) if (Number.isFinite(values[i]) && values[i]! < NO_VALUE / 2) sizes.push(Math.abs(values[i]!));
  }
  sizes.sort((a, b) => a - b);
  const share = field.unit === "Pa" ? 0.99 : 1;
  const most = sizes.length > 0 ? sizes[Math.min(sizes.length - 1, Math.floor(share * sizes.length))]! : 0;
  const high = most > 0 ? most : 1;
  return [field.kind === "signed" ? -high : 0, high];
}
