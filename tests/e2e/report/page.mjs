// The page of tests/e2e/report/case.toml in headless Chromium: pixels of known blocks at known times, controls, text that
// stays text, no request, no fault of accessibility.
// Usage: CHROMIUM=... MODULES=.../node_modules node page.mjs REPORT THIN
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { test_contacts, test_film, test_theme } from "./steps.mjs";
import { axe, browser, colour, drawn, faults, instant, LEVELS, near, open_page, places, show_frame, until, viridis } from "./browser.mjs";

const [report, thin] = process.argv.slice(2);
const GRAVITY = 10; // of the case [m/s2]
const TITLE = `</script><img src=x onerror="document.title='run'"> falling & resting`;

function open(file, options = {}) {
  const address = pathToFileURL(file).href;
  return open_page(address, (url) => url === address, options);
}

async function test_pixels(page) {
  const pixel = await places(page);
  const middle = (t) => pixel(-6, 7.5 - 0.5 * GRAVITY * t * t);
  const last = Number(await page.getAttribute("#time", "max"));
  const ground = await colour(page, pixel(-10, 3));
  near(ground, [255, 255, 255], 1, "the ground");
  for (const layer of ["original", "monitors", "supports", "outline"]) await page.uncheck(`#layer-${layer}`);
  const end = 0.8;
  for (const index of [0, 4, 11, last]) {
    await show_frame(page, index);
    const t = await instant(page);
    near(await colour(page, middle(t)), viridis((t / end) ** 2), LEVELS, `displacement at ${t} s`);
  }
  near(await colour(page, middle(0)), ground, 1, "where the block has been");
  await page.selectOption("#field", "speed");
  await show_frame(page, 11);
  const t = await instant(page);
  near(await colour(page, middle(t)), viridis(t / end), LEVELS, `speed at ${t} s`);
  // The range of the instant: the fastest block has the colour of the upper end.
  await page.selectOption("#range", "frame");
  await drawn(page);
  near(await colour(page, middle(t)), viridis(1), LEVELS, "speed in the range of the instant");
  await page.selectOption("#range", "run");
  // Methods: the mesh of the NMM gives way to the blocks of the DDA at one time, in two frames.
  await page.selectOption("#field", "method");
  const before = await page.evaluate(() => JSON.parse(document.getElementById("scree-run").textContent).frames.list.findIndex((f) => f.stage === "fall"));
  const seen = [];
  for (const index of [before - 1, before]) {
    await show_frame(page, index);
    seen.push([await instant(page), await colour(page, middle(await instant(page)))]);
  }
  assert.ok(Math.abs(seen[0][0] - seen[1][0]) < 2e-3, `the hand-over takes from ${seen[0][0]} to ${seen[1][0]} s`);
  assert.notDeepEqual(seen[0][1], seen[1][1], "the hand-over does not show");
  // The held base is hatched in grey, whatever the field.
  const [r, g, b] = await colour(page, pixel(-10, -1));
  assert.ok(Math.abs(r - g) < 12 && Math.abs(g - b) < 12, `the base is ${[r, g, b]}`);
  return { pixel, middle };
}

async function test_controls(page, { pixel, middle }) {
  await page.locator("#time").focus();
  const before = Number(await page.inputValue("#time"));
  await page.keyboard.press("ArrowRight");
  await until(page, (i) => Number(document.getElementById("time").value) === i, before + 1);
  await show_frame(page, 0);
  await page.selectOption("#speed", "1");
  await page.locator("#fit").focus();
  await page.locator("#fit").press("ArrowRight");
  await until(page, () => document.getElementById("time").value === "1");
  await page.click("#play");
  assert.equal(await page.getAttribute("#play", "aria-pressed"), "true");
  await until(page, () => Number(document.getElementById("time").value) >= 5);
  await until(page, () => document.getElementById("play").getAttribute("aria-pressed") === "false"); // ends by itself
  assert.ok((await instant(page)) > 0.799, "playing does not reach the end");
  // Choose a block by a click, where it is now.
  await show_frame(page, 11);
  const box = await page.locator("#view").boundingBox();
  const [x, y] = middle(await instant(page));
  await page.mouse.click(box.x + x, box.y + y);
  assert.equal(await page.$eval("#block", (s) => s.selectedOptions[0].textContent), "falling");
  assert.match(await page.textContent("#block-facts"), /Materialrock.*12\.0 m².*DDA, implicit/);
  await page.waitForSelector("#block-chart canvas");
  const [u, v] = pixel(1, 1.5);
  await page.mouse.click(box.x + u, box.y + v);
  assert.equal(await page.$eval("#block", (s) => s.selectedOptions[0].textContent), "<b>resting");
  assert.match(await page.textContent("#block-facts"), /NMM|DDA/);
  // Contacts: those of the resting block are closed.
  await page.check("#layer-contacts");
  assert.match(await page.textContent("#layer-key"), /sticking \(\d+\)/);
  await page.check("#layer-crosses");
  assert.match(await page.textContent("#layer-key"), /compression.*Longest arm: [\d.]+ kPa/);
  // Zoom keeps the place below the middle; the scale bar follows.
  const scale = await page.textContent("#scale-text");
  for (let i = 0; i < 6; ++i) await page.click("#zoom-in");
  await drawn(page);
  assert.notEqual(await page.textContent("#scale-text"), scale);
  await page.locator("#view").focus();
  await page.keyboard.press("0");
  await drawn(page);
  assert.equal(await page.textContent("#scale-text"), scale);
  // The picture as PNG.
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#save")]);
  const png = readFileSync(await download.path());
  assert.equal(png.subarray(1, 4).toString(), "PNG");
  assert.ok(png.length > 5000, `the PNG has ${png.length} bytes`);
}

async function test_text(page) {
  assert.equal(await page.title(), TITLE);
  assert.equal(await page.textContent("#title"), TITLE);
  assert.equal(await page.$$eval("img, b, iframe, object", (all) => all.length), 0, "a name of the case has become an element");
  const found = await page.textContent("#found");
  assert.match(found, /Statusdone/);
  assert.match(found, /Ledger closure/);
  assert.match(await page.textContent("#asked"), /report\/case\.toml.*onerror/s);
  assert.match(await page.textContent("#events"), /touches nothing/);
  assert.equal(await page.$$eval("#stages span", (all) => all.map((s) => s.textContent).join(" ")), "shake fall");
  assert.ok((await page.$$eval(".u-legend .u-series", (all) => all.length)) > 4, "the charts have no series");
  assert.match(await page.textContent("#thinning"), /All 18 stored frames/);
  assert.match(await page.textContent("#licences"), /three.*MIT/s);
}

async function test_accessibility(page, scheme) {
  await page.evaluate(() => document.querySelectorAll("details").forEach((d) => (d.open = true)));
  await page.evaluate(axe);
  const { violations, passes } = await page.evaluate(() => globalThis.axe.run(document));
  assert.ok(passes.length > 15, `only ${passes.length} rules of accessibility apply`);
  const serious = violations.filter((v) => ["serious", "critical"].includes(v.impact));
  assert.deepEqual(serious.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(" ")).slice(0, 3).join(", ")}`), [], `accessibility, ${scheme}`);
}

try {
  const page = await open(report);
  await test_text(page);
  const where = await test_pixels(page);
  await test_controls(page, where);
  await test_contacts(page, where.pixel);
  await test_film(page);
  await test_theme(page);
  await test_accessibility(page, "light");
  const dark = await open(report, { colorScheme: "dark" });
  near(await colour(dark, [30, 200]), [28, 32, 36], 2, "the dark ground");
  await dark.selectOption("#block", { label: "falling" });
  await dark.waitForSelector("#block-chart canvas");
  await test_accessibility(dark, "dark");
  const few = await open(thin);
  assert.match(await few.textContent("#thinning"), /[45] of the 18 stored frames/);
  assert.deepEqual(faults, []);
  console.log("page: fine");
} finally {
  await browser.close();
}
