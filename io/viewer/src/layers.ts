// Lines over the blocks: principal stress crosses, contacts, joints and outlines as the model first had them.
import { mapped, name_colour, type Rgb } from "./colours";
import { FAILED, SLIPPING, STICKING } from "./contacts";
import type { Bolts, Contacts, Frame, Mesh, Piece, Run } from "./source";

export interface LineSet {
  ends: Float32Array; // x0, y0, x1, y1 a line
  tint: Uint8Array; // r, g, b a line
}

class Builder {
  private readonly ends: number[] = [];
  private readonly tint: number[] = [];
  add(x0: number, y0: number, x1: number, y1: number, colour: Rgb): void {
    this.ends.push(x0, y0, x1, y1);
    this.tint.push(...colour);
  }
  done(): LineSet {
    return { ends: new Float32Array(this.ends), tint: new Uint8Array(this.tint) };
  }
}

export const COMPRESSION: Rgb = [24, 82, 160];
export const TENSION: Rgb = [200, 30, 30];
export const WATER: Rgb = [0, 96, 200];

/// The value below which 98 % of the sizes are; 0 where there are none.
function high_of(sizes: number[]): number {
  const sorted = sizes.filter(Number.isFinite).sort((a, b) => a - b);
  return sorted.length > 0 ? sorted[Math.min(sorted.length - 1, Math.floor(0.98 * sorted.length))]! : 0;
}

export interface Crosses extends LineSet {
  stress: number; // of an arm of `arm` [Pa]; 0: no stress
  arm: number; // [m]
}

/// A cross a cell: arms along the principal axes, as long as the stresses are large; at most one in each square of `spacing` [m].
export function crosses(mesh: Mesh, frame: Frame, position: Float32Array, held: (block: number) => boolean, spacing: number): Crosses {
  const taken = new Set<string>();
  const found: { x: number; y: number; xx: number; yy: number; xy: number }[] = [];
  for (let c = 0; c + 1 < mesh.offsets.length; ++c) {
    if (held(mesh.block[c]!)) continue;
    const first = mesh.offsets[c]!;
    const end = mesh.offsets[c + 1]!;
    const sum = { x: 0, y: 0, xx: 0, yy: 0, xy: 0 };
    for (let i = first; i < end; ++i) {
      const p = mesh.cells[i]!;
      sum.x += position[2 * p]! / (end - first);
      sum.y += position[2 * p + 1]! / (end - first);
      sum.xx += frame.stress[3 * p]! / (end - first);
      sum.yy += frame.stress[3 * p + 1]! / (end - first);
      sum.xy += frame.stress[3 * p + 2]! / (end - first);
    }
    const key = `${Math.floor(sum.x / spacing)} ${Math.floor(sum.y / spacing)}`;
    if (taken.has(key)) continue;
    taken.add(key);
    found.push(sum);
  }
  const principal = found.map((s) => {
    const mean = 0.5 * (s.xx + s.yy);
    const radius = Math.hypot(0.5 * (s.xx - s.yy), s.xy);
    const angle = 0.5 * Math.atan2(2 * s.xy, s.xx - s.yy); // of the larger one
    return { ...s, s1: mean + radius, s3: mean - radius, angle };
  });
  const stress = high_of(principal.map((s) => Math.max(Math.abs(s.s1), Math.abs(s.s3))));
  const arm = 0.55 * spacing;
  const lines = new Builder();
  if (stress > 0)
    for (const s of principal)
      for (const [value, angle] of [[s.s1, s.angle], [s.s3, s.angle + 0.5 * Math.PI]] as const) {
        const length = arm * Math.min(1.5, Math.abs(value) / stress);
        const dx = length * Math.cos(angle);
        const dy = length * Math.sin(angle);
        lines.add(s.x - dx, s.y - dy, s.x + dx, s.y + dy, value > 0 ? TENSION : COMPRESSION);
      }
  return { ...lines.done(), stress, arm };
}

export interface ContactLines extends LineSet {
  force: number; // of a line of `length` [N]
  length: number; // [m]
  sticking: number; // how many
  slipping: number;
  failed: number;
}

/// The force on each closed contact point, as a line through it.
export function contact_lines(contacts: Contacts, longest: number): ContactLines {
  const count = contacts.state.length;
  const size = (i: number) => Math.hypot(contacts.force[2 * i]!, contacts.force[2 * i + 1]!);
  const force = high_of(Array.from({ length: count }, (_, i) => size(i)));
  const out = { force, length: longest, sticking: 0, slipping: 0, failed: 0 };
  const lines = new Builder();
  for (let i = 0; i < count; ++i) {
    const state = contacts.state[i]!;
    if ((state & 3) === 2) out.sticking += 1;
    else out.slipping += 1;
    if (state & 4) out.failed += 1;
    const [nx, ny] = [contacts.normal[2 * i]!, contacts.normal[2 * i + 1]!];
    const [fn, ft] = [contacts.force[2 * i]!, contacts.force[2 * i + 1]!];
    const scale = force > 0 ? (0.5 * longest) / Math.max(force, size(i)) : 0;
    const [dx, dy] = [scale * (fn * nx - ft * ny), scale * (fn * ny + ft * nx)];
    const [x, y] = [contacts.position[2 * i]!, contacts.position[2 * i + 1]!];
    lines.add(x - dx, y - dy, x + dx, y + dy, (state & 3) === 2 ? STICKING : state & 4 ? FAILED : SLIPPING);
  }
  return { ...lines.done(), ...out };
}

export interface SlipLines extends LineSet {
  most: number; // slip of the upper end of the colours [m]
}

/// Slip at each closed contact point, as a stretch of its edge.   @param half  of a stretch [m]
export function slip_lines(contacts: Contacts, half: number): SlipLines {
  const slips = Array.from(contacts.slip, Math.abs);
  const most = slips.reduce((m, s) => (Number.isFinite(s) && s > m ? s : m), 0);
  const lines = new Builder();
  slips.forEach((slip, i) => {
    const [dx, dy] = [-half * contacts.normal[2 * i + 1]!, half * contacts.normal[2 * i]!];
    const [x, y] = [contacts.position[2 * i]!, contacts.position[2 * i + 1]!];
    lines.add(x - dx, y - dy, x + dx, y + dy, mapped("magnitude", most > 0 ? slip / most : 0));
  });
  return { ...lines.done(), most };
}

export interface BoltLines extends LineSet {
  most: number; // axial force of the upper end of the colours [N]
}

/// The segments of bolts, coloured by their axial force.
export function bolt_lines(bolts: Bolts): BoltLines {
  const most = bolts.force.reduce((m, f) => (Math.abs(f) > m ? Math.abs(f) : m), 0);
  const lines = new Builder();
  for (let i = 0; i + 1 < bolts.bolt.length; ++i)
    if (bolts.bolt[i] === bolts.bolt[i + 1])
      lines.add(bolts.position[2 * i]!, bolts.position[2 * i + 1]!, bolts.position[2 * i + 2]!, bolts.position[2 * i + 3]!,
        mapped("magnitude", most > 0 ? Math.abs(bolts.force[i]!) / most : 0));
  return { ...lines.done(), most };
}

/// Piezometric lines, level beyond their ends, with the sign that drawings have for a water level.
/// @param size  of that sign [m]
export function water_lines(run: Run, size: number): LineSet {
  const lines = new Builder();
  const [x0, , x1] = run.frames.bounds;
  for (const { line } of run.model.water ?? []) {
    const last = line.length - 2;
    const points = [Math.min(x0, line[0]!), line[1]!, ...line, Math.max(x1, line[last]!), line[last + 1]!];
    for (let i = 0; i + 3 < points.length; i += 2) lines.add(points[i]!, points[i + 1]!, points[i + 2]!, points[i + 3]!, WATER);
    // On the middle of the longest stretch that is in the model.
    let [best, x, y] = [-1, 0, 0];
    for (let i = 0; i + 3 < points.length; i += 2) {
      const [a, b] = [Math.max(x0, points[i]!), Math.min(x1, points[i + 2]!)];
      if (b - a <= best) continue;
      best = b - a;
      x = 0.5 * (a + b);
      y = points[i + 1]! + ((points[i + 3]! - points[i + 1]!) * (x - points[i]!)) / Math.max(points[i + 2]! - points[i]!, 1e-12);
    }
    lines.add(x, y, x - 0.6 * size, y + size, WATER);
    lines.add(x - 0.6 * size, y + size, x + 0.6 * size, y + size, WATER);
    lines.add(x + 0.6 * size, y + size, x, y, WATER);
    for (const [below, half] of [[0.25, 0.45], [0.5, 0.25]] as const) lines.add(x - half * size, y - below * size, x + half * size, y - below * size, WATER);
  }
  return lines.done();
}

/// x0, y0, x1, y1 a line.
export function original_outline(run: Run): Float32Array {
  const ends: number[] = [];
  for (const block of run.model.blocks)
    for (const ring of block.rings)
      for (let i = 0; i < ring.length; i += 2) {
        const j = (i + 2) % ring.length;
        ends.push(ring[i]!, ring[i + 1]!, ring[j]!, ring[j + 1]!);
      }
  return Float32Array.from(ends);
}

/// Supports as engineers draw them. Held stretches of outlines: hatching outside, off the line where the stretch may slide. Points: a triangle below (held along y) or beside (held along x alone) the point, with a ground line where it is
/// held along both axes and a gap above that line where it may roll.   @param size  of a triangle [m]
export function support_marks(run: Run, colour: Rgb, size: number): LineSet {
  const lines = new Builder();
  for (const [x0, y0, x1, y1, fixed] of run.model.edges ?? []) {
    const length = Math.hypot(x1 - x0, y1 - y0);
    if (!(length > 0)) continue;
    const [ax, ay] = [(x1 - x0) / length, (y1 - y0) / length];
    const place = (along: number, out: number): [number, number] => [x0 + along * ax + out * ay, y0 + along * ay - out * ax];
    const ground = fixed ? 0 : 0.35 * size; // rollers stand off the ground
    lines.add(x0, y0, x1, y1, colour);
    if (!fixed) lines.add(...place(0, ground), ...place(length, ground), colour);
    const ticks = Math.min(400, Math.max(1, Math.round(length / (0.8 * size))));
    for (let i = 0; i < ticks; ++i) {
      const at = ((i + 0.5) * length) / ticks;
      lines.add(...place(at, ground), ...place(at - 0.35 * size, ground + 0.35 * size), colour);
    }
  }
  for (const [x, y, fix_x, fix_y] of run.model.supports) {
    // Along the support (a, down or left) and across it (b).
    const place = (a: number, b: number): [number, number] => (fix_y ? [x + b * size, y - a * size] : [x - a * size, y + b * size]);
    const line = (a0: number, b0: number, a1: number, b1: number) => lines.add(...place(a0, b0), ...place(a1, b1), colour);
    const foot = fix_x && fix_y ? 1 : 1.25; // a roller stands above its ground
    line(0, 0, 1, -0.6);
    line(0, 0, 1, 0.6);
    line(1, -0.6, 1, 0.6);
    line(foot, -0.8, foot, 0.8);
    for (const b of [-0.6, -0.2, 0.2, 0.6]) line(foot, b, foot + 0.3, b - 0.25);
  }
  return lines.done();
}

/// A diamond at each place.   @param size  half of it [m]
export function diamonds(places: [number, number][], colour: Rgb, size: number): LineSet {
  const lines = new Builder();
  for (const [x, y] of places)
    for (const [a, b, c, d] of [[1, 0, 0, 1], [0, 1, -1, 0], [-1, 0, 0, -1], [0, -1, 1, 0]] as const)
      lines.add(x + a * size, y + b * size, x + c * size, y + d * size, colour);
  return lines.done();
}

/// Joints and cracks in the colour of their law.
export function joint_lines(run: Run): LineSet {
  const lines = new Builder();
  const add = (pieces: Piece[]) => pieces.forEach(([x0, y0, x1, y1, law]) => lines.add(x0, y0, x1, y1, name_colour(law + 3)));
  add(run.model.joints.lines);
  add(run.model.joints.cracks);
  return lines.done();
}
