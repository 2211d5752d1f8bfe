// Triangles, outlines and places of a mesh: what changes with the topology only.
import earcut from "earcut";
import type { Mesh } from "./source";

/// Corners of triangles, as entries of mesh.cells.
export function triangles(mesh: Mesh): Uint32Array {
  const out: number[] = [];
  for (let c = 0; c + 1 < mesh.offsets.length; ++c) {
    const first = mesh.offsets[c]!;
    const count = mesh.offsets[c + 1]! - first;
    if (count === 3) {
      out.push(first, first + 1, first + 2);
      continue;
    }
    const ring: number[] = [];
    for (let i = 0; i < count; ++i) {
      const p = mesh.cells[first + i]!;
      ring.push(mesh.origin[2 * p]!, mesh.origin[2 * p + 1]!);
    }
    for (const corner of earcut(ring)) out.push(first + corner);
  }
  return new Uint32Array(out);
}

/// Edges that one cell of a block has alone (two points each): its outline, its holes and its cracks. Edges are matched by where their points
/// were in the model, so cells need not share points.
export function outline(mesh: Mesh): { edges: Uint32Array; block: Int32Array } {
  let extent = 0;
  for (const x of mesh.origin) extent = Math.max(extent, Math.abs(x));
  const grid = Math.max(1e-6 * extent, 1e-30);
  const place = new Map<string, number>(); // of a block's points in the model
  const spot = (block: number, p: number) => {
    const key = `${block} ${Math.round(mesh.origin[2 * p]! / grid)} ${Math.round(mesh.origin[2 * p + 1]! / grid)}`;
    let id = place.get(key);
    if (id === undefined) place.set(key, (id = place.size));
    return id;
  };
  const seen = new Map<string, { a: number; b: number; block: number; count: number }>();
  for (let c = 0; c + 1 < mesh.offsets.length; ++c) {
    const first = mesh.offsets[c]!;
    const end = mesh.offsets[c + 1]!;
    for (let i = first; i < end; ++i) {
      const a = mesh.cells[i]!;
      const b = mesh.cells[i + 1 < end ? i + 1 : first]!;
      const s = spot(mesh.block[c]!, a);
      const t = spot(mesh.block[c]!, b);
      const key = s < t ? `${s} ${t}` : `${t} ${s}`;
      const edge = seen.get(key);
      if (edge) edge.count += 1;
      else seen.set(key, { a, b, block: mesh.block[c]!, count: 1 });
    }
  }
  const alone = [...seen.values()].filter((e) => e.count === 1);
  return { edges: new Uint32Array(alone.flatMap((e) => [e.a, e.b])), block: new Int32Array(alone.map((e) => e.block)) };
}

/// The cell that holds a place, or -1.
export function cell_at(mesh: Mesh, position: Float32Array, x: number, y: number): number {
  for (let c = 0; c + 1 < mesh.offsets.length; ++c) {
    const first = mesh.offsets[c]!;
    const end = mesh.offsets[c + 1]!;
    let inside = false;
    for (let i = first, j = end - 1; i < end; j = i++) {
      const p = 2 * mesh.cells[i]!;
      const q = 2 * mesh.cells[j]!;
      const yp = position[p + 1]!;
      const yq = position[q + 1]!;
      if (yp > y !== yq > y && x < position[p]! + ((y - yp) / (yq - yp)) * (position[q]! - position[p]!)) inside = !inside;
    }
    if (inside) return c;
  }
  return -1;
}

/// Areas of all cells in the model [m2].
export function cell_areas(mesh: Mesh): Float64Array {
  const out = new Float64Array(mesh.offsets.length - 1);
  for (let c = 0; c < out.length; ++c) {
    const first = mesh.offsets[c]!;
    const end = mesh.offsets[c + 1]!;
    let twice = 0;
    for (let i = first, j = end - 1; i < end; j = i++) {
      const p = 2 * mesh.cells[i]!;
      const q = 2 * mesh.cells[j]!;
      twice += mesh.origin[q]! * mesh.origin[p + 1]! - mesh.origin[p]! * mesh.origin[q + 1]!;
    }
    out[c] = Math.abs(0.5 * twice);
  }
  return out;
}
