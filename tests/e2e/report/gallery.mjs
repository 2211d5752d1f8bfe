// The page of `scree gallery` in headless Chromium: pictures show, links lead to reports that work, names stay text.
// Usage: CHROMIUM=... MODULES=.../node_modules node gallery.mjs FOLDER
import assert from "node:assert/strict";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { axe, browser, faults, open_page } from "./browser.mjs";

const folder = pathToFileURL(join(process.argv[2], "/")).href;
try {
  for (const colorScheme of ["light", "dark"]) {
    const page = await open_page(`${folder}index.html`, (url) => url.startsWith(folder) || url.startsWith("data:"), { ready: false, colorScheme });
    assert.equal(await page.$$eval("li", (all) => all.length), 4);
    assert.deepEqual(await page.$$eval("img", (all) => all.map((i) => i.complete && i.naturalWidth > 300)), [true, true, true]);
    assert.equal(await page.$$eval("h2 b, script", (all) => all.length), 0, "a title has become an element");
    assert.match(await page.textContent("li:nth-child(1) h2"), /falling & resting/);
    assert.match(await page.textContent("li:nth-child(2)"), /Statusdone.*Blocks3.*Ledger closure/);
    assert.match(await page.textContent("li:nth-child(4) .trouble"), /run\.vtkhdf/);
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => globalThis.axe.run(document));
    assert.deepEqual(violations.filter((v) => ["serious", "critical"].includes(v.impact)).map((v) => v.id), [], "accessibility");
    await page.click("li:nth-child(2) a");
    await page.waitForSelector("body[data-ready=true]", { timeout: 60000 });
    assert.equal(await page.textContent("#title"), "Two blocks on a plane, two stages");
    await page.close();
  }
  assert.deepEqual(faults, []);
  console.log("gallery: fine");
} finally {
  await browser.close();
}
