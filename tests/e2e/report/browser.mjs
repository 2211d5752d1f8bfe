// A headless Chromium for tests of pages, and what they look at: places, colours, frames.
// CHROMIUM: the program; MODULES: node_modules of io/viewer.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const require = createRequire(process.env.MODULES + "/");
const { chromium } = require("playwright-core");
export const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

export const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM,
  args: ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"], // WebGL by the processor, as on a machine without a graphics card
});
/// What pages complained of, and requests that they may not make.
export const faults = [];

/// Opens a page and waits until it shows something, unless `ready` is false.
/// @param may_ask  of an address: whether the page may ask for it
export async function open_page(address, may_ask, { ready = true, ...options } = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true, ...options });
  const page = await context.newPage();
  page.on("console", (m) => ["error", "warning"].includes(m.type()) && !/GPU stall|swiftshader/i.test(m.text()) && faults.push(`console: ${m.text()}`));
  page.on("pageerror", (e) => faults.push(`page: ${e.message}`));
  page.on("request", (r) => !may_ask(r.url()) && !r.url().startsWith("blob:") && faults.push(`request: ${r.url()}`));
  page.on("websocket", (w) => !may_ask(w.url()) && faults.push(`socket: ${w.url()}`));
  await page.goto(address);
  if (ready) await page.waitForSelector("body[data-ready=true]", { timeout: 60000 });
  return page;
}

/// The instant that the page shows [s].
export const instant = async (page) => Number((await page.textContent("#instant")).match(/t = ([\d.]+) s/)[1]);

/// Waits until something holds in the page. (waitForFunction evaluates text in the page, which its policy forbids.)
export async function until(page, holds, argument) {
  for (const end = Date.now() + 30000; Date.now() < end; await page.waitForTimeout(30)) if (await page.evaluate(holds, argument)) return;
  assert.fail(`never holds: ${holds}`);
}

/// Two frames of the browser, in which a picture asked for has been drawn.
export const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 50)))));

export async function show_frame(page, index) {
  await page.locator("#time").fill(String(index));
  await until(page, (i) => document.getElementById("time").getAttribute("aria-valuetext").includes(`frame ${i + 1} of`), index);
  await drawn(page);
}

/// Places [m] -> pixels of the canvas, from what the page says of two pixels below the pointer.
export async function places(page) {
  const box = await page.locator("#view").boundingBox();
  const at = async (px, py) => {
    await page.mouse.move(box.x + px, box.y + py);
    const text = (await page.textContent("#pointer")).replaceAll("−", "-");
    const [, x, y] = text.match(/x = (-?[\d.]+) m, y = (-?[\d.]+) m/);
    return [Number(x), Number(y)];
  };
  const [px, qx, py, qy] = [100, box.width - 100, 100, box.height - 100];
  const p = await at(px, py);
  const q = await at(qx, qy);
  return (x, y) => [px + ((x - p[0]) / (q[0] - p[0])) * (qx - px), py + ((y - p[1]) / (q[1] - p[1])) * (qy - py)];
}

/// Red, green, blue of a pixel of the canvas (CSS pixels).
export const colour = (page, [x, y]) =>
  page.evaluate(([x, y]) => {
    const view = document.getElementById("view");
    const copy = document.createElement("canvas");
    copy.width = view.width;
    copy.height = view.height;
    const c = copy.getContext("2d");
    c.drawImage(view, 0, 0);
    return [...c.getImageData(Math.round((x * view.width) / view.clientWidth), Math.round((y * view.height) / view.clientHeight), 1, 1).data].slice(0, 3);
  }, [x, y]);

export const near = (a, b, within, what) => {
  for (let k = 0; k < 3; ++k) assert.ok(Math.abs(a[k] - b[k]) <= within, `${what}: ${a} is not ${b} within ${within}`);
};

/// viridis at ten places, straight between them; written down here a second time.
const VIRIDIS = [[68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142], [38, 130, 142], [31, 158, 137], [53, 183, 121], [110, 206, 88], [181, 222, 43], [253, 231, 37]];
export function viridis(x) {
  const at = Math.min(1, Math.max(0, x)) * 9;
  const i = Math.min(8, Math.floor(at));
  return [0, 1, 2].map((k) => VIRIDIS[i][k] + (at - i) * (VIRIDIS[i + 1][k] - VIRIDIS[i][k]));
}
export const LEVELS = 4; // of 255: a table of 256 colours, and 1 % of time steps
