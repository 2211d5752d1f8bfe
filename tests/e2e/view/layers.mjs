// What the page of a stored run draws over blocks: bolts with their forces, held outlines, supports, water, crosses, contacts.
// Each layer changes pixels where it must, in light and dark; names stay text; no serious fault of accessibility.
// Usage: CHROMIUM=... MODULES=.../node_modules node layers.mjs REPORT [FOLDER for pictures]
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";
import { axe, browser, colour, drawn, faults, open_page, places, show_frame } from "../report/browser.mjs";

const [report, pictures] = process.argv.slice(2);
const address = pathToFileURL(report).href;
const ON = { // of a place [m] that a layer alone paints
  bolts: [3.96, 1.19], // half way of the anchor
  water: [10, 1.2],
  supports: [4, -10],
};

async function test_layers(page) {
  await page.uncheck("#layer-outline");
  await page.uncheck("#layer-original");
  await show_frame(page, 10);
  const pixel = await places(page);
  // The line may lie a pixel beside the place: the nearest few are looked at.
  const painted = async (place) => {
    const [x, y] = pixel(...place);
    const seen = [];
    for (let dy = -4; dy <= 4; ++dy) seen.push(String(await colour(page, [x, y + dy])));
    return seen.join(" ");
  };
  for (const [layer, place] of Object.entries(ON)) {
    assert.equal(await page.isChecked(`#layer-${layer}`), true, `${layer} are not shown at first`);
    const on = await painted(place);
    await page.uncheck(`#layer-${layer}`);
    await drawn(page);
    assert.notEqual(await painted(place), on, `the layer of ${layer} changes nothing at ${place}`);
    await page.check(`#layer-${layer}`);
    await drawn(page);
    assert.equal(await painted(place), on, `the layer of ${layer} does not come back`);
  }
  const key = await page.textContent("#layer-key");
  assert.match(key, /bolt force 0.*5\d(\.\d)? kN\/m \(largest now\)/);
  assert.match(key, /water in all joints/);
  // Contacts: the loose block slides, the held one sticks or slides on its plane; the largest force is that of the ground.
  await page.check("#layer-contacts");
  await page.check("#layer-crosses");
  await page.check("#layer-slip");
  assert.match(await page.textContent("#layer-key"), /sticking \(\d+\).*slipping \([1-9]\d*\).*Longest line: .*N/);
  assert.match(await page.textContent("#layer-key"), /compression.*tension.*Longest arm: .*Pa/);
  await page.click("#contact-next");
  assert.match(await page.textContent("#contact-facts"), /Corner of.*Jointplane, φ = 25.*State.*Normal force/);
}

async function test_names(page) {
  assert.equal(await page.title(), await page.evaluate(() => document.title));
  assert.equal(await page.$$eval("main b, main i, main u, main script", (all) => all.length), 0, "a name has become an element");
  assert.notEqual(await page.title(), "run");
  await page.selectOption("#block", "1");
  assert.match(await page.textContent("#block"), /held <script>/);
  assert.match(await page.textContent("#block-facts"), /rock <b>1<b>/);
}

try {
  for (const colorScheme of ["light", "dark"]) {
    const page = await open_page(address, (url) => url === address, { colorScheme });
    await test_layers(page);
    await test_names(page);
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => globalThis.axe.run(document));
    assert.deepEqual(violations.filter((v) => ["serious", "critical"].includes(v.impact)).map((v) => `${v.id}: ${v.nodes.map((n) => n.html).join(" ")}`), [], "accessibility");
    if (pictures) await page.screenshot({ path: `${pictures}/layers-${colorScheme}.png`, fullPage: true });
    await page.close();
  }
  assert.deepEqual(faults, []);
  console.log("layers: fine");
} finally {
  await browser.close();
}
