// `scree view --live` in headless Chromium, inside a network namespace: a page that waits, a replay that streams, a late page,
// a stage whose mesh is another, a run that begins anew, a server that is gone for a while. Times are printed.
// Usage: CHROMIUM=... MODULES=.../node_modules node live.mjs SCREE RUN CASE SCRATCH MARKS
//   RUN: stored run of tests/e2e/report/case.toml; CASE: a case of two stages; MARKS: stored run of marks.toml
import assert from "node:assert/strict";
import { browser, colour, drawn, faults, instant, near, open_page, places, until } from "../report/browser.mjs";
import { end, end_all, own, pause, start, view, wait } from "./program.mjs";

const [scree, run, case_file, scratch, marks] = process.argv.slice(2);
const GRAVITY = 10; // of the run [m/s2]
const SPEED = 0.04; // of the replay: simulated seconds a second
const SWITCH = 0.3; // the DDA begins [s]
const MOST = 2000; // [ms] in which a picture must be there
const FALLING = [0xdd, 0xcc, 0x77]; // the second block, coloured by block
const RESTING = [0x44, 0xaa, 0x99]; // the third

const instant_of = (page) => page.textContent("#instant");
const stage_of = async (page) => (await instant_of(page)).split(", ")[1];

/// The falling block is where it must be at the instant that the page shows.
async function test_pixels(page) {
  await until(page, () => Number(document.getElementById("time").max) >= 2);
  await page.click("#follow"); // the newest
  await page.locator("#time").press("ArrowLeft"); // and then one that stays
  await page.uncheck("#layer-outline");
  await page.uncheck("#layer-monitors");
  await page.selectOption("#field", "block");
  await drawn(page);
  assert.equal(await page.getAttribute("#follow", "aria-pressed"), "false");
  const pixel = await places(page);
  const t = await instant(page);
  near(await colour(page, pixel(-6, 7.5 - 0.5 * GRAVITY * t * t)), FALLING, 1, `the falling block at ${t} s`);
  near(await colour(page, pixel(-6, 9.3)), [255, 255, 255], 1, "above it");
  near(await colour(page, pixel(0, 1.5)), RESTING, 1, "the block that rests");
  await page.selectOption("#field", "speed");
  assert.match(await page.textContent("#legend"), /speed \[/);
  // The replay carries speed, and nobody can ask it for the integrator: what is not there is grey, and said.
  await page.selectOption("#field", "integrator");
  assert.match(await page.textContent("#legend"), /integrator.*not in this frame/);
  assert.match(await page.textContent("#note"), /The stream carries speed.*--control/);
  await drawn(page);
  near(await colour(page, pixel(0, 1.5)), [0xe7, 0xe6, 0xe3], 1, "a field that is not there");
  await page.selectOption("#field", "speed");
  await page.click("#follow");
}

/// A page that comes late: from the moment in which it connects, the quickest of three, as other programs may take the
/// processors meanwhile. To load a page takes what it takes.
async function late_page(server) {
  const times = [];
  let page = null;
  while (times.length < 3 && !(Math.min(...times) < MOST)) {
    await page?.close();
    const opened = Date.now();
    page = await open_page(server.address, own(server.address), { ready: false });
    const connected = await page.evaluate(() => performance.timeOrigin + performance.getEntriesByType("navigation")[0].domInteractive);
    await page.waitForSelector("body[data-ready=true]", { timeout: 20000 });
    const ready = Date.now();
    times.push(ready - Math.max(opened, connected));
    console.log(`late page: picture after ${Math.round(times[times.length - 1])} ms; with the loading of the page ${ready - opened} ms`);
  }
  assert.ok(Math.min(...times) < MOST, "a late page waits too long");
  return page;
}

async function test_replay(server) {
  const early = await open_page(server.address, own(server.address), { ready: false });
  await until(early, () => document.getElementById("subtitle").textContent.startsWith("Nothing is heard of any run on udpm://"));
  const begin = Date.now();
  const replay = start(scree, "replay", run, "--speed", String(SPEED));
  await early.waitForSelector("body[data-ready=true]", { timeout: 10000 });
  console.log(`replay: first picture after ${Date.now() - begin} ms, the start of the program included`);
  assert.equal(await early.textContent("#title"), `</script><img src=x onerror="document.title='run'"> falling & resting`);
  assert.equal(await early.$$eval("img, b, iframe, object", (all) => all.length), 0);
  await early.evaluate(() => {
    const instant = document.getElementById("instant");
    new MutationObserver((_, observer) => {
      if (!instant.textContent.endsWith(", fall")) return;
      document.body.dataset.switched = String(Date.now());
      observer.disconnect();
    }).observe(instant, { childList: true, characterData: true, subtree: true });
  });
  await test_pixels(early);

  const late = await late_page(server);

  // The mesh of the NMM gives way to the blocks of the DDA.
  await wait_for_stage(early, "fall");
  const behind = Number(await early.getAttribute("body", "data-switched")) - begin - (1000 * SWITCH) / SPEED;
  console.log(`stage switch: shown ${behind} ms after its time, the start of the program included`);
  assert.ok(behind < MOST, "the stage switch shows too late");
  await early.selectOption("#block", "1");
  assert.match(await early.textContent("#block-facts"), /MethodDDA/);
  assert.match(await early.textContent("#block-facts"), /Area12\.0 m²/);
  assert.equal(await stage_of(late), "fall");
  await test_pixels(late);
  await until(late, () => document.querySelectorAll("#monitor-chart .u-series").length > 1);
  await until(late, () => document.querySelectorAll("#energy-chart .u-series").length > 1);
  assert.match(await late.textContent("#subtitle"), /running .* 4 blocks/);
  await wait(() => replay.code !== null, "the replay ends");
  assert.equal(replay.code, 0, replay.text);
  await until(early, () => document.getElementById("subtitle").textContent.startsWith("done"));
  assert.ok(Math.abs((await instant(early)) - 0.8) < 1e-9, "the last frame is not the newest");
  assert.deepEqual(faults, []);
  await late.close();
  return early;
}

async function wait_for_stage(page, name) {
  for (const limit = Date.now() + 20000; Date.now() < limit; await pause(10)) if ((await stage_of(page).catch(() => "")) === name) return;
  assert.fail(`stage ${name} never shows`);
}

/// A run takes the place of the replay: the page begins anew by itself. Its server goes away and comes back.
async function test_run(server, page) {
  const begin = Date.now();
  const live = start(scree, "run", case_file, "--live", "--quiet", "--out", `${scratch}/live`, "--set", "stage.runout.duration=1000");
  for (const limit = Date.now() + 10000; Date.now() < limit; await pause(10)) {
    const title = await page.textContent("#title").catch(() => "");
    if (title === "Two blocks on a plane, two stages" && (await page.getAttribute("body", "data-ready").catch(() => null)) === "true") break;
  }
  console.log(`another run: its picture after ${Date.now() - begin} ms, the start of the program included`);
  await wait_for_stage(page, "runout");
  await page.selectOption("#block", "1");
  assert.match(await page.textContent("#block-facts"), /MethodDDA/);
  assert.deepEqual(faults, []);

  const port = new URL(server.address).port;
  assert.equal(await end(server), 0);
  await until(page, () => /connection to scree view lost/.test(document.getElementById("subtitle").textContent));
  const before = await instant(page);
  const again = await view(scree, "--live", "--port", port);
  const back = Date.now();
  await until(page, (t) => Number(document.getElementById("instant").textContent.match(/t = ([\d.]+) s/)[1]) > t, before);
  console.log(`connection lost: a newer picture ${Date.now() - back} ms after the server is back`);
  assert.ok(Date.now() - back < MOST + 500, "the page is not back in time");
  assert.ok(faults.every((f) => /WebSocket connection to/.test(f)), faults.join("\n")); // the browser says so itself
  faults.length = 0;
  await end(live);
  await until(page, () => document.getElementById("subtitle").textContent.startsWith("interrupted"));
  return again;
}

/// What a stream brings beside frames: names, bolts, supports, water, contacts with their states, stress crosses.
async function test_marks() {
  const server = await view(scree, "--live");
  const page = await open_page(server.address, own(server.address), { ready: false });
  const replay = start(scree, "replay", marks, "--speed", "0.2");
  await page.waitForSelector("body[data-ready=true]", { timeout: 10000 });
  assert.match(await page.textContent("#block"), /held <script>document\.title=0<script>.*loose/);
  assert.equal(await page.$$eval("main b, main i, main u, main script", (all) => all.length), 0, "a name has become an element");
  for (const layer of ["supports", "water", "bolts", "contacts", "crosses", "slip"]) await page.check(`#layer-${layer}`);
  await until(page, () => /sticking \(\d+\).*slipping \([1-9]/.test(document.getElementById("layer-key").textContent));
  const key = await page.textContent("#layer-key");
  assert.match(key, /bolt force 0.*kN\/m \(largest now\)/);
  assert.match(key, /water in all joints/);
  assert.match(key, /compression.*tension.*Longest arm: .*Pa/);
  await page.selectOption("#block", "2");
  await page.click("#contact-next");
  assert.match(await page.textContent("#contact-facts"), /Corner of.*Edge of.*Jointplane, φ = 25.*State.*Normal force/);
  await page.selectOption("#block", "1");
  await page.selectOption("#field", "joint");
  await until(page, () => !document.getElementById("legend").textContent.includes("not in this frame"));
  await page.selectOption("#field", "s3");
  assert.match(await page.textContent("#block-facts"), /Mean σ₁, σ₃.*Pa.*Closed contacts[1-9]/);
  // Each layer paints where it must.
  await page.click("#back");
  for (const layer of ["outline", "original", "contacts", "crosses", "slip"]) await page.uncheck(`#layer-${layer}`);
  await drawn(page);
  const pixel = await places(page);
  for (const [layer, [x, y]] of [["bolts", [3.96, 1.19]], ["water", [10, 1.2]], ["supports", [4, -10]]]) {
    const look = async () => {
      const seen = [];
      for (let dy = -4; dy <= 4; ++dy) seen.push(String(await colour(page, [pixel(x, y)[0], pixel(x, y)[1] + dy])));
      return seen.join(" ");
    };
    const on = await look();
    await page.uncheck(`#layer-${layer}`);
    await drawn(page);
    assert.notEqual(await look(), on, `the layer of ${layer} changes nothing`);
    await page.check(`#layer-${layer}`);
  }
  if (process.env.SCREE_PICTURES) {
    for (const layer of ["outline", "contacts", "crosses"]) await page.check(`#layer-${layer}`);
    await drawn(page);
    await page.screenshot({ path: `${process.env.SCREE_PICTURES}/live.png` });
  }
  await wait(() => replay.code !== null, "the replay ends");
  assert.deepEqual(faults, []);
  await page.close();
  assert.equal(await end(server), 0);
}

/// A page that has the token steers the run; one without it does not, whatever it sends.
async function test_control() {
  const live = start(scree, "run", case_file, "--live", "--control", "--quiet", "--out", `${scratch}/steered`, "--set", "stage.runout.duration=1000", "--set", "output.every=0.01");
  const server = await view(scree, "--live", "--control");
  const token = server.text.match(/#token=([0-9a-f]{32})\n/)?.[1];
  assert.ok(token, `view --control says "${server.text}"`);
  const watcher = await open_page(server.address, own(server.address));
  const page = await open_page(`${server.address}#token=${token}`, own(server.address));
  assert.equal(page.url(), server.address, "the token stays in the address bar");
  assert.equal(await watcher.isVisible("#control-box"), false);
  await until(page, () => document.getElementById("control-box").offsetHeight > 0);
  // What the stream carries is what the page asks for.
  for (const [field, label] of [["s3", /σ₃/], ["joint", /joint state/], ["integrator", /time integrator/]]) {
    const begin = Date.now();
    await page.selectOption("#field", field);
    await until(page, (f) => document.getElementById("note").textContent.startsWith(`field ${f}: done`), field);
    await until(page, () => !document.getElementById("legend").textContent.includes("not in this frame"));
    console.log(`field ${field}: shown after ${Date.now() - begin} ms`);
    assert.match(await page.textContent("#legend"), label);
  }
  // A run that computes names its blocks and shows its contacts, although it stores none.
  await page.check("#layer-contacts");
  await until(page, () => /sticking \(\d+\)|slipping \([1-9]/.test(document.getElementById("layer-key").textContent));
  assert.match(await page.textContent("#block"), /slope.*lower.*upper/);
  // Paused, the run stands still; a step is a step.
  await page.click("#run-pause");
  await until(page, () => /paused/.test(document.getElementById("subtitle").textContent));
  const steps = async () => Number((await page.textContent("#found")).match(/Steps([\d ]+)Step cuts/)[1].replaceAll(" ", ""));
  await pause(1500); // what people read comes once a second
  const before = await steps();
  await page.click("#run-step");
  await until(page, () => document.getElementById("note").textContent.startsWith("step 1: done"));
  await until(page, (n) => Number(document.getElementById("found").textContent.match(/Steps([\d ]+)Step cuts/)[1].replaceAll(" ", "")) === n, before + 1);
  // Without the token nothing happens, and the connection ends.
  for (const text of ["resume", `${"0".repeat(32)} resume`, `${token.slice(1)} resume`, `${token} format`]) {
    const code = await watcher.evaluate((text) => new Promise((done) => {
      const socket = new WebSocket(new URL("live", location.href.replace("http", "ws")));
      socket.onopen = () => socket.send(text);
      socket.onclose = (e) => done(e.code);
    }), text);
    assert.equal(code, 1008, text);
  }
  await page.click("#run-checkpoint");
  await until(page, () => /^checkpoint: done, checkpoint/.test(document.getElementById("note").textContent));
  assert.equal(await steps(), before + 1, "a paused run goes on");
  await page.click("#run-pause");
  await until(page, () => /running/.test(document.getElementById("subtitle").textContent));
  page.on("dialog", (d) => d.accept());
  await page.click("#run-stop");
  await wait(() => live.code !== null, "the run ends");
  assert.equal(live.code, 130, live.text);
  await until(page, () => document.getElementById("run-pause").disabled);
  assert.deepEqual(faults, []);
  await watcher.close();
  await page.close();
  assert.equal(await end(server), 0);
}

try {
  const server = await view(scree, "--live");
  const page = await test_replay(server);
  const again = await test_run(server, page);
  assert.equal(await end(again), 0);
  await page.close();
  await test_control();
  await test_marks();
  console.log("view --live: fine");
} finally {
  end_all();
  await browser.close();
}
