// The contact that is chosen: by a click, or one after the other; followed from frame to frame.
import { by_id } from "./elements";
import { chosen_of, contact_at, contact_facts, type Chosen } from "./contacts";
import type { Contacts, Run } from "./source";
import { pairs } from "./tables";

const REACH = 9; // [CSS pixels] from a click to the contact that it means
const STRIDE = 0.1; // of the model: what is farther away in the next frame is another contact

export class ContactBox {
  private chosen: Chosen | null = null;
  private contacts: Contacts | null = null; // of the frame that is shown

  constructor(private readonly run: Run, private readonly changed: () => void) {}

  /// Where to mark it.
  get place(): [number, number][] {
    return this.chosen ? [this.chosen.place] : [];
  }

  /// @param x,y  of a click [m]   @param scale  pixels a metre; 0: no contacts are drawn   @return whether a contact was meant
  clicked(x: number, y: number, scale: number): boolean {
    const at = this.contacts && scale > 0 ? contact_at(this.contacts, x, y, REACH / scale) : -1;
    this.choose(at);
    if (at >= 0) by_id("contact-box").scrollIntoView({ block: "nearest" });
    return at >= 0;
  }

  /// The next closed contact of a block, or of all where it is -1.
  next(block: number): void {
    const c = this.contacts;
    if (!c) return;
    const all = Array.from(c.state.keys()).filter((i) => block < 0 || c.blocks[3 * i] === block || c.blocks[3 * i + 1] === block);
    const now = this.chosen ? contact_at(c, ...this.chosen.place, Infinity, this.chosen) : -1;
    this.choose(all.length > 0 ? all[(all.indexOf(now) + 1) % all.length]! : -1);
  }

  private choose(at: number): void {
    this.chosen = at < 0 ? null : chosen_of(this.contacts!, at);
    this.show(this.contacts);
    this.changed();
  }

  /// Another frame is shown.
  show(contacts: Contacts | null): void {
    this.contacts = contacts;
    const box = by_id("contact-facts");
    if (!this.chosen || !contacts) return box.replaceChildren();
    const [x0, y0, x1, y1] = this.run.frames.bounds;
    const at = contact_at(contacts, ...this.chosen.place, STRIDE * Math.hypot(x1 - x0, y1 - y0), this.chosen);
    if (at < 0) return pairs(box, [["State", "open at this instant"]]);
    this.chosen = chosen_of(contacts, at);
    pairs(box, contact_facts(this.run, contacts, at));
  }
}
