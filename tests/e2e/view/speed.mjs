// Frames a second of the page of a large run, in software rendering (SwiftShader), and what one takes of the processors.
// Usage: CHROMIUM=... MODULES=.../node_modules node speed.mjs SCREE RUN LEAST
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { browser, faults, open_page, until } from "../report/browser.mjs";
import { end, end_all, own, view } from "./program.mjs";

const [scree, run, least] = process.argv.slice(2);
const TICK = 0.01; // [s] of /proc

/// Processor time of the browser's processes by their kind [s].
function used() {
  const out = {};
  for (const id of readdirSync("/proc").filter((n) => /^\d+$/.test(n))) {
    try {
      const words = readFileSync(`/proc/${id}/cmdline`, "latin1").split("\0");
      if (!/chrom/.test(words[0])) continue;
      const kind = words.find((w) => w.startsWith("--type="))?.slice(7) ?? "browser";
      const stat = readFileSync(`/proc/${id}/stat`, "latin1").split(") ")[1].split(" ");
      out[kind] = (out[kind] ?? 0) + TICK * (Number(stat[11]) + Number(stat[12]));
    } catch {
      // has ended meanwhile
    }
  }
  return out;
}

try {
  const server = await view(scree, run);
  const page = await open_page(server.address, own(server.address));
  const counts = await page.evaluate(() => ({ blocks: document.getElementById("block").options.length - 1, frames: Number(document.getElementById("time").max) + 1 }));
  console.log(`${counts.blocks} blocks, ${counts.frames} frames`);
  for (const field of ["displacement", "s1"]) {
    await page.selectOption("#field", field);
    await page.selectOption("#speed", "1");
    let best = 0;
    for (let turn = 0; turn < 3; ++turn) {
      await page.locator("#time").fill("0");
      await until(page, () => document.getElementById("time").value === "0");
      await page.evaluate(() => {
        const seen = (window.seen = []);
        window.watch?.disconnect();
        (window.watch = new MutationObserver(() => seen.push(performance.now()))).observe(document.getElementById("instant"), { childList: true });
      });
      const before = used();
      await page.click("#play");
      await until(page, () => document.getElementById("play").getAttribute("aria-pressed") === "false");
      const after = used();
      const seen = await page.evaluate(() => window.seen);
      const rate = (seen.length - 1) / ((seen[seen.length - 1] - seen[0]) / 1000);
      best = Math.max(best, rate);
      const costs = Object.keys(after).map((k) => `${k} ${((1000 * (after[k] - (before[k] ?? 0))) / seen.length).toFixed(1)} ms`).filter((t) => !/ 0\.\d ms/.test(t));
      console.log(`${field}: ${rate.toFixed(1)} frames a second (${seen.length} shown); processor time a frame: ${costs.join(", ")}`);
    }
    assert.ok(best >= Number(least), `${best.toFixed(1)} frames a second, not ${least}`);
  }
  assert.deepEqual(faults, []);
  await end(server);
} finally {
  end_all();
  await browser.close();
}
