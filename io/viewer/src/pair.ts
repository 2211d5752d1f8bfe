// Two pages side by side (`scree view RUN --compare RUN2`): what one shows, the other shows too. Each is a frame of one page
// and hears the other over a channel of the browser.

/// Places are in the coordinates of the case, so that runs with other local origins agree.
export interface Shown {
  time?: number; // [s]
  field?: string;
  range?: string; // run, frame
  factor?: string; // of displacements
  view?: [number, number, number]; // middle [m], pixels (CSS) a metre
  fit?: true;
  ranges?: Record<string, [number, number]>; // of the whole run
  bounds?: [number, number, number, number];
  hello?: true; // answer with your ranges and bounds
}

export class Pair {
  private readonly channel = new BroadcastChannel("scree-pair");

  /// Null where the page stands alone.
  static find(heard: (what: Shown) => void): Pair | null {
    return window.parent === window ? null : new Pair(heard);
  }

  private constructor(heard: (what: Shown) => void) {
    this.channel.onmessage = (e: MessageEvent<Shown>) => heard(e.data);
  }

  tell(what: Shown): void {
    this.channel.postMessage(what);
  }
}

/// What both ranges span.
export function merged(a: Record<string, [number, number]>, b: Record<string, [number, number]>): Record<string, [number, number]> {
  const out = { ...a };
  for (const [id, [low, high]] of Object.entries(b)) out[id] = [Math.min(low, out[id]?.[0] ?? low), Math.max(high, out[id]?.[1] ?? high)];
  return out;
}
