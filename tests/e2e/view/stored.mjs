// `scree view` of a stored run and of a case in headless Chromium: pixels of known blocks at known times, frames fetched when
// they are shown, nothing asked of anybody else, an end by a signal.
// Usage: CHROMIUM=... MODULES=.../node_modules node stored.mjs SCREE RUN OTHER CASE
import assert from "node:assert/strict";
import { axe, browser, colour, drawn, faults, instant, LEVELS, near, open_page, places, show_frame, until, viridis } from "../report/browser.mjs";
import { end, end_all, own, view } from "./program.mjs";

const [scree, run, other, case_file] = process.argv.slice(2);
const GRAVITY = 10; // of the case [m/s2]
const END = 0.8; // of the run [s]
const TITLE = `</script><img src=x onerror="document.title='run'"> falling & resting`;
const GREY = 12; // of 255, between the channels of a held block

async function test_run() {
  const server = await view(scree, run);
  const asked = [];
  const page = await open_page(server.address, own(server.address));
  page.on("request", (r) => asked.push(new URL(r.url()).pathname));
  assert.equal(await page.title(), TITLE);
  assert.equal(await page.textContent("#title"), TITLE);
  assert.equal(await page.$$eval("img, b, iframe, object", (all) => all.length), 0, "a name of the case has become an element");
  assert.match(await page.textContent("#thinning"), /All 18 stored frames are served/);
  assert.equal(await page.getAttribute("#time", "max"), "17");
  const pixel = await places(page);
  const middle = (t) => pixel(-6, 7.5 - 0.5 * GRAVITY * t * t);
  for (const layer of ["original", "monitors", "supports", "outline"]) await page.uncheck(`#layer-${layer}`);
  for (const index of [4, 11, 17]) {
    await show_frame(page, index);
    const t = await instant(page);
    near(await colour(page, middle(t)), viridis((t / END) ** 2), LEVELS, `displacement at ${t} s`);
  }
  const [r, g, b] = await colour(page, pixel(-10, -1));
  assert.ok(Math.abs(r - g) < GREY && Math.abs(g - b) < GREY, `the base is ${[r, g, b]}`);
  assert.deepEqual(asked, ["/frame/4", "/frame/11", "/mesh/1", "/frame/17"], "what is fetched is what is shown");
  // A click chooses the block where it is now; its history takes every frame.
  const box = await page.locator("#view").boundingBox();
  const [x, y] = middle(END);
  await page.mouse.click(box.x + x, box.y + y);
  assert.equal(await page.$eval("#block", (s) => s.selectedOptions[0].textContent), "falling");
  await page.waitForSelector("#block-chart canvas");
  assert.equal(new Set(asked.filter((a) => a.startsWith("/frame/"))).size, 17, "the first frame was there before");
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document));
  assert.deepEqual(violations.filter((v) => ["serious", "critical"].includes(v.impact)).map((v) => v.id), [], "accessibility");
  // The policy of the page: no script that stands in it, no request to anybody else.
  const blocked = await page.evaluate(async () => {
    const script = document.createElement("script");
    script.textContent = "document.body.dataset.inline = 'ran'";
    document.body.append(script);
    const other = await fetch("http://localhost:1/").then(() => "sent", () => "refused");
    return [document.body.dataset.inline ?? "nothing", other];
  });
  assert.deepEqual(blocked, ["nothing", "refused"]);
  assert.ok(faults.splice(0).every((f) => /Content Security Policy|violates/.test(f) || f.startsWith("request: http://localhost:1/")), "only what the policy blocks");
  assert.equal(await end(server), 0, "exit code after SIGINT");
}

async function test_model() {
  const server = await view(scree, case_file);
  const page = await open_page(server.address, own(server.address));
  assert.match(await page.textContent("#subtitle"), /before its run · 4 blocks, 1 of them held/);
  assert.equal(await page.isVisible("#charts"), false);
  assert.equal(await page.isVisible("#transport"), false);
  const pixel = await places(page);
  for (const layer of ["original", "supports", "outline"]) await page.uncheck(`#layer-${layer}`);
  await page.selectOption("#field", "block");
  await drawn(page);
  near(await colour(page, pixel(-6, 7.5)), [0xdd, 0xcc, 0x77], 1, "the block that will fall, the second one");
  near(await colour(page, pixel(0, 1.5)), [0x44, 0xaa, 0x99], 1, "the block that rests, the third one");
  await until(page, () => document.getElementById("asked").textContent.includes("friction_deg = 30.0"));
  assert.deepEqual(faults, []);
  assert.equal(await end(server, "SIGTERM"), 0, "exit code after SIGTERM");
}

/// Two runs side by side: time, field and view go from one to the other; one range of colours serves both.
async function test_pair() {
  const server = await view(scree, run, "--compare", other);
  const page = await open_page(server.address, own(server.address), { ready: false });
  const frame_of = async (name) => {
    for (const limit = Date.now() + 20000; Date.now() < limit; await page.waitForTimeout(20)) {
      const frame = page.frames().find((f) => f.url().endsWith(`/${name}/`));
      if (frame && (await frame.$("body[data-ready=true]"))) return frame;
    }
    return assert.fail(`the ${name} page is never ready`);
  };
  const [left, right] = [await frame_of("left"), await frame_of("right")];
  const said = async (frame, id) => await frame.textContent(id);
  assert.match(await said(left, "#subtitle"), /^run · /);
  assert.match(await said(right, "#subtitle"), /^other · /);
  await left.locator("#time").fill("11");
  await until(right, () => document.getElementById("instant").textContent.startsWith("t = 0.5"));
  await right.locator("#time").fill("2");
  await until(left, () => document.getElementById("instant").textContent.startsWith("t = 0.1"));
  await right.selectOption("#field", "speed");
  await until(left, () => document.getElementById("field").value === "speed");
  // Gravity is twice as large in the other run: its range of speeds serves both.
  const legend = await said(right, "#legend");
  assert.equal(await said(left, "#legend"), legend);
  assert.match(legend, /14(\.0)?speed/);
  const scale = await said(right, "#scale-text");
  for (let i = 0; i < 6; ++i) await left.click("#zoom-in");
  await until(right, (old) => document.getElementById("scale-text").textContent !== old, scale);
  assert.equal(await said(left, "#scale-text"), await said(right, "#scale-text"));
  await left.click("#fit");
  await until(right, (old) => document.getElementById("scale-text").textContent === old, scale);
  assert.deepEqual(faults, []);
  assert.equal(await end(server), 0);
}

try {
  await test_run();
  await test_pair();
  await test_model();
  console.log("view: fine");
} finally {
  end_all();
  await browser.close();
}
