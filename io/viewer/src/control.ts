// Buttons that steer a run that streams, for a page that was opened with the token of `scree view --live --control`.
import { by_id } from "./elements";

export interface Answer {
  command: string;
  result: string; // done, accepted, refused, not available, failed
  reason: string;
}

const KEY = "scree-token";

/// The token behind the '#' of the address, taken out of it and kept for this tab; empty: there is none.
export function token(): string {
  const given = location.hash.match(/^#token=([0-9a-f]{32})$/)?.[1];
  if (given) {
    sessionStorage.setItem(KEY, given);
    history.replaceState(null, "", location.pathname);
  }
  return given ?? sessionStorage.getItem(KEY) ?? "";
}

/// Binds the buttons.   @param give  sends a command
export function bind_control(give: (command: string) => void): void {
  const on = (id: string, act: () => void) => by_id(id).addEventListener("click", act);
  on("run-pause", () => give(by_id("run-pause").dataset.verb ?? "pause"));
  on("run-step", () => give("step 1"));
  on("run-checkpoint", () => give("checkpoint"));
  on("run-stop", () => {
    if (confirm("End this run after its present step? It writes a checkpoint; scree resume goes on from there.")) give("stop");
  });
}

/// @param status  of the run: running, paused, done, ...
export function show_control(status: string): void {
  const paused = status === "paused";
  const button = by_id("run-pause");
  button.dataset.verb = paused ? "resume" : "pause";
  button.textContent = paused ? "Resume run" : "Pause run";
  const over = status !== "running" && !paused;
  for (const id of ["run-pause", "run-step", "run-checkpoint", "run-stop"]) by_id<HTMLButtonElement>(id).disabled = over;
}

export const told = (a: Answer): string => `${a.command}: ${a.result}${a.reason ? `, ${a.reason}` : ""}`;
