// Programs that a test starts, and the address that `scree view` prints.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";

const started = new Set();

/// A program that goes on; `text` is what it has printed so far.
export function start(command, ...words) {
  const child = spawn(command, words, { stdio: ["ignore", "pipe", "pipe"] });
  const program = { child, text: "", code: null };
  started.add(program);
  child.stdout.on("data", (d) => (program.text += d));
  child.stderr.on("data", (d) => (program.text += d));
  child.on("exit", (code, signal) => {
    program.code = code ?? signal;
    started.delete(program);
  });
  return program;
}

export const pause = (ms) => new Promise((done) => setTimeout(done, ms));

/// Waits until something holds, 20 s at most.
export async function wait(holds, what) {
  for (const end = Date.now() + 20000; Date.now() < end; await pause(20)) if (holds()) return;
  assert.fail(`never: ${what}`);
}

/// `scree view` with its address.
export async function view(scree, ...words) {
  const program = start(scree, "view", ...words);
  await wait(() => program.text.includes("http://") || program.code !== null, `view ${words.join(" ")} prints an address`);
  const address = program.text.match(/http:\/\/127\.0\.0\.1:\d+\//)?.[0];
  assert.ok(address, `view ${words.join(" ")} says "${program.text}"`);
  return Object.assign(program, { address });
}

/// Ends a program and gives its exit code.
export async function end(program, signal = "SIGINT") {
  program.child.kill(signal);
  await wait(() => program.code !== null, "a program ends after a signal");
  return program.code;
}

export function end_all() {
  for (const program of started) program.child.kill("SIGKILL");
}

/// A page of this server may ask this server alone.
export const own = (address) => (url) => url.startsWith(address) || url.startsWith(address.replace("http:", "ws:")) || url === "data:,";
