// What was asked and what came out, as text. Everything from a run goes in by textContent.
import type { Run } from "./source";
import { quantity, seconds, short } from "./units";

export function element<K extends keyof HTMLElementTagNameMap>(tag: K, text?: string, name?: string): HTMLElementTagNameMap[K] {
  const out = document.createElement(tag);
  if (text !== undefined) out.textContent = text;
  if (name) out.className = name;
  return out;
}

/// Rows of a name and a value.
export function pairs(into: HTMLElement, rows: [string, string | undefined][]): void {
  const list = element("dl");
  for (const [name, value] of rows) {
    if (value === undefined || value === "") continue;
    list.append(element("dt", name), element("dd", value));
  }
  into.replaceChildren(list);
}

export function table(heads: string[], rows: string[][], caption: string): HTMLTableElement {
  const out = element("table");
  out.append(element("caption", caption));
  const head = element("tr");
  for (const h of heads) {
    const cell = element("th", h);
    cell.scope = "col";
    head.append(cell);
  }
  const thead = element("thead");
  thead.append(head);
  const body = element("tbody");
  for (const row of rows) {
    const line = element("tr");
    for (const text of row) line.append(element("td", text));
    body.append(line);
  }
  out.append(thead, body);
  return out;
}

type Found = Record<string, unknown>;
const number = (f: Found | null | undefined, key: string): number | undefined => (typeof f?.[key] === "number" ? (f[key] as number) : undefined);
const words = (f: Found | null | undefined, key: string): string | undefined => (typeof f?.[key] === "string" ? (f[key] as string) : undefined);
const inside = (f: Found | null | undefined, key: string): Found | null => (f && typeof f[key] === "object" ? (f[key] as Found) : null);
const count = (n: number | undefined): string | undefined => n?.toLocaleString("en").replaceAll(",", " ");

const STATUS: Record<string, string> = {
  done: "done", interrupted: "interrupted", not_converged: "did not converge", non_finite: "ended with numbers that are not finite",
};

export function status_of(run: Run): string {
  const status = words(run.found, "status") ?? String(run.asked.status ?? "");
  return STATUS[status] ?? (status || "has not ended");
}

export function show_asked(run: Run, into: HTMLElement): void {
  const a = run.asked as Found;
  const rows: [string, string | undefined][] = [
    ["Run", run.folder],
    ["Command line", words(a, "command_line")],
    ["Settings changed", run.asked.set.join(", ")],
    ["Scree", [words(a, "version"), words(a, "commit")].filter(Boolean).join(", commit ")],
    ["Built with", [words(a, "compiler"), words(a, "instruction_set")].filter(Boolean).join(", ")],
    ["Libraries", run.asked.libraries.map(([n, v]) => `${n} ${v}`).join(", ")],
    ["Threads", count(number(run.found, "threads"))],
    ["Resumed at", words(a, "resumed")],
    ["SHA-256 of the case", words(a, "case_sha256")],
  ];
  pairs(into, rows);
  into.append(
    table(["Stage", "Time integration", "Start", "Planned"],
      run.stages.map((s) => [s.name, s.integrator, s.start === null ? "not reached" : seconds(s.start), seconds(s.duration)]), "Stages"),
    table(["Material", "Density", "Young's modulus", "Poisson's ratio"],
      run.model.materials.map((m) => [m.name, `${short(m.density, 4)} kg/m³`, quantity(m.young, "Pa"), short(m.poisson)]), "Materials"),
    table(["Joint", "Friction", "Cohesion", "Tensile strength"],
      run.model.joints.laws.map((l) => [l.name, `${short(l.friction_deg)}°`, quantity(l.cohesion, "Pa"), l.tensile_strength === null ? "unlimited" : quantity(l.tensile_strength, "Pa")]), "Joint laws"),
  );
  const details = element("details");
  details.append(element("summary", "Case file"));
  const text = element("pre", run.asked.case);
  text.tabIndex = 0;
  text.setAttribute("aria-label", "Text of the case file");
  details.append(text);
  into.append(details);
}

export function show_found(run: Run, into: HTMLElement): void {
  const f = run.found;
  const ledger = inside(f, "ledger");
  const wall = inside(f, "wall_seconds");
  const friction = inside(f, "friction");
  const closure = number(ledger, "relative_closure");
  const share = number(ledger, "scheme_passed_share");
  const memory = number(f, "peak_memory_bytes");
  const last = run.frames.list[run.frames.list.length - 1]!;
  pairs(into, [
    ["Status", status_of(run)],
    ["Reason", words(f, "reason")],
    ["Simulated time", seconds(number(f, "final_time") ?? last.time)],
    ["Steps", count(number(f, "steps") ?? last.step)],
    ["Step cuts", count(number(f, "cuts"))],
    ["Open-close passes", count(number(f, "open_close_passes"))],
    ["Blocks, elements (end)", f ? `${count(number(f, "blocks_count"))}, ${count(number(f, "elements"))}` : count(run.model.blocks.length)],
    ["Unknowns (end)", count(number(f, "unknowns"))],
    ["Contacts (end)", count(number(f, "contacts"))],
    ["Energy moved", number(ledger, "moved") === undefined ? undefined : quantity(number(ledger, "moved")!, "J")],
    ["Ledger closure", closure === undefined ? undefined : `${short(closure)} of ${words(ledger, "relative_closure_of") ?? "the energy moved"}`],
    ["Largest scheme column", share === undefined ? undefined : `${short(100 * share)} % of the energy passed`],
    ["Friction, worst ratio", number(friction, "worst_ratio") === undefined ? undefined : short(number(friction, "worst_ratio")!)],
    ["Wall time", number(wall, "total") === undefined ? undefined : `${short(number(wall, "total")!)} s`],
    ["Peak memory", memory === undefined ? undefined : `${short(memory / 1e6)} MB`],
    ["State hash", words(f, "state_hash")],
  ]);
  if (!f) into.append(element("p", "The run has no summary: it goes on, or it was killed.", "note"));
  const moved = (Array.isArray(f?.blocks) ? (f.blocks as Found[]) : [])
    .map((b) => ({ name: words(b, "name") ?? "", method: words(b, "method") ?? "", displacement: number(b, "displacement") ?? 0 }))
    .sort((a, b) => b.displacement - a.displacement)
    .slice(0, 8);
  if (moved.length > 0)
    into.append(table(["Block", "Method", "Mean displacement"], moved.map((b) => [b.name, b.method, quantity(b.displacement, "m")]), "Blocks that moved farthest"));
  show_columns(ledger, run, into);
}

/// Every column of the ledger at the end.
function show_columns(ledger: Found | null, run: Run, into: HTMLElement): void {
  const sides = inside(ledger, "columns");
  if (!sides) return;
  const rows: string[][] = [];
  for (const column of run.history.ledger) {
    const value = number(inside(sides, column.side), column.name);
    if (value !== undefined && value !== 0) rows.push([column.name.replaceAll("_", " "), column.side, quantity(value, "J"), column.meaning]);
  }
  const details = element("details");
  details.append(element("summary", "Energy ledger at the end, column by column"));
  const box = element("div", undefined, "scroll");
  box.tabIndex = 0;
  box.setAttribute("role", "region");
  box.setAttribute("aria-label", "Energy ledger at the end");
  box.append(table(["Column", "Side", "Value", "Meaning"], rows, "Columns that are not zero"));
  details.append(box);
  into.append(details);
}

const QUIET = new Set(["transfer"]); // many, and said in the chart of the stages

export function show_events(run: Run, into: HTMLElement, on_time: (time: number) => void): void {
  const kinds = [...new Set(run.events.map((e) => e[1]))];
  const chosen = new Set(kinds.filter((k) => !QUIET.has(k)));
  const list = element("ol", undefined, "events scroll");
  list.tabIndex = 0;
  list.setAttribute("aria-label", "Events and warnings");
  const fill = () => {
    list.replaceChildren(
      ...run.events
        .filter((e) => chosen.has(e[1]))
        .map(([time, kind, text]) => {
          const item = element("li", undefined, kind === "warning" || kind === "not_converged" ? "warning" : "");
          const at = element("button", seconds(time), "link");
          at.type = "button";
          at.title = "Show this instant";
          at.addEventListener("click", () => on_time(time));
          item.append(at, element("span", kind.replaceAll("_", " "), "kind"), element("span", text));
          return item;
        }),
    );
    if (list.childElementCount === 0) list.append(element("li", "none"));
  };
  const boxes = element("fieldset", undefined, "kinds");
  boxes.append(element("legend", "Kinds"));
  for (const kind of kinds) {
    const label = element("label");
    const box = element("input");
    box.type = "checkbox";
    box.checked = chosen.has(kind);
    box.addEventListener("change", () => {
      if (box.checked) chosen.add(kind);
      else chosen.delete(kind);
      fill();
    });
    label.append(box, ` ${kind.replaceAll("_", " ")} (${run.events.filter((e) => e[1] === kind).length})`);
    boxes.append(label);
  }
  fill();
  into.replaceChildren(...(kinds.length > 0 ? [boxes, list] : [element("p", "The run had no events.")]));
}
