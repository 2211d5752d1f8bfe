// One contact point: found by a click, followed from frame to frame, told in words.
import type { Rgb } from "./colours";
import type { Contacts, Run } from "./source";
import { quantity, short } from "./units";

/// A contact that was chosen. Frames do not number their contacts: the next frame has it where the same two blocks touch
/// by the same law, nearest to where it was.
export interface Chosen {
  blocks: [number, number, number]; // of the corner, of the edge, joint law
  place: [number, number]; // [m]
}

export const STICKING: Rgb = [0, 114, 178];
export const SLIPPING: Rgb = [213, 94, 0];
export const FAILED: Rgb = [170, 20, 110];
export const STATE_NAMES = ["no closed contact", "sticking", "slipping", "slipping, strength failed"];
export const STATE_COLOURS: Rgb[] = [[196, 198, 200], STICKING, SLIPPING, FAILED];

/// 1 sticking, 2 slipping, 3 slipping with its strength failed: places in STATE_NAMES.
export const state_rank = (state: number): number => ((state & 3) === 2 ? 1 : state & 4 ? 3 : 2);

/// The contact point nearest to a place, or -1.   @param within  [m]   @param like  only those of this pair of blocks
export function contact_at(contacts: Contacts, x: number, y: number, within: number, like?: Chosen): number {
  let best = -1;
  let least = within;
  for (let i = 0; i < contacts.state.length; ++i) {
    if (like && like.blocks.some((b, k) => contacts.blocks[3 * i + k] !== b)) continue;
    const distance = Math.hypot(contacts.position[2 * i]! - x, contacts.position[2 * i + 1]! - y);
    if (distance <= least) [best, least] = [i, distance];
  }
  return best;
}

export const chosen_of = (contacts: Contacts, i: number): Chosen => ({
  blocks: [contacts.blocks[3 * i]!, contacts.blocks[3 * i + 1]!, contacts.blocks[3 * i + 2]!],
  place: [contacts.position[2 * i]!, contacts.position[2 * i + 1]!],
});

/// What is known of a closed contact point.
export function contact_facts(run: Run, contacts: Contacts, i: number): [string, string | undefined][] {
  const [corner, edge, law] = chosen_of(contacts, i).blocks;
  const [fn, ft] = [contacts.force[2 * i]!, contacts.force[2 * i + 1]!];
  const joint = run.model.joints.laws[law];
  const [x, y] = chosen_of(contacts, i).place;
  return [
    ["Corner of", run.model.blocks[corner]?.name],
    ["Edge of", run.model.blocks[edge]?.name],
    ["Joint", joint ? `${joint.name}, φ = ${short(joint.friction_deg)}°` : undefined],
    ["State", STATE_NAMES[state_rank(contacts.state[i]!)]],
    ["Normal force", `${quantity(fn, "N")}/m`],
    ["Shear force", `${quantity(ft, "N")}/m`],
    ["Shear / normal", fn > 0 ? `${short(Math.abs(ft) / fn)}${joint ? ` (tan φ = ${short(Math.tan((joint.friction_deg * Math.PI) / 180))})` : ""}` : undefined],
    ["Slip", quantity(contacts.slip[i]!, "m")],
    ["At", `${(x + run.origin[0]).toFixed(2)}, ${(y + run.origin[1]).toFixed(2)} m`],
  ];
}

const RANKS = new WeakMap<Contacts, Map<number, number>>();

/// The most critical state of a block's closed contacts, a place in STATE_NAMES.
export function block_rank(contacts: Contacts | null, block: number): number {
  if (!contacts) return 0;
  let ranks = RANKS.get(contacts);
  if (!ranks) {
    RANKS.set(contacts, (ranks = new Map()));
    for (let i = 0; i < contacts.state.length; ++i)
      for (const k of [0, 1]) {
        const b = contacts.blocks[3 * i + k]!;
        ranks.set(b, Math.max(ranks.get(b) ?? 0, state_rank(contacts.state[i]!)));
      }
  }
  return ranks.get(block) ?? 0;
}
