// What the tests of a stored run's page and of a served one have in common: contacts, slip, films, light and dark.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { colour, drawn, near, show_frame, until } from "./browser.mjs";

const STICKING = [0, 114, 178];

/// The resting block (4 m x 3 m of 2500 kg/m3 under 10 m/s2) stands on the base by contacts whose normal forces sum up to its weight.
export async function test_contacts(page, pixel) {
  await page.check("#layer-slip");
  assert.match(await page.textContent("#layer-key"), /slip 0/);
  await page.uncheck("#layer-slip");
  await page.selectOption("#block", { label: "<b>resting" });
  await page.locator("#view").press("c");
  const seen = [];
  for (let k = 0; k < 20; ++k) {
    const text = await page.textContent("#contact-facts");
    if (seen.includes(text)) break;
    seen.push(text);
    await page.click("#contact-next");
  }
  assert.ok(seen.length >= 2 && seen.length < 20, `${seen.length} contacts of the resting block`);
  let sum = 0;
  for (const text of seen) {
    assert.match(text, /Corner of(<b>resting|base)Edge of(base|<b>resting)Jointrough, φ = 30\.0°Statesticking/);
    const [, number, prefix] = text.match(/Normal force([\d.]+) (k|M)?N\/m/);
    sum += Number(number) * { k: 1e3, M: 1e6 }[prefix];
  }
  const weight = 4 * 3 * 2500 * 10;
  assert.ok(Math.abs(sum / weight - 1) < 0.02, `the contacts carry ${sum} N of ${weight} N`);
  // A click on a contact that is drawn chooses it; one elsewhere chooses the block.
  await page.check("#layer-contacts");
  await drawn(page);
  const at = seen[0].replaceAll("−", "-").match(/At(-?[\d.]+), (-?[\d.]+) m/).slice(1).map(Number);
  const box = await page.locator("#view").boundingBox();
  const [x, y] = pixel(...at);
  await page.mouse.click(box.x + x + 2, box.y + y - 2);
  assert.equal(await page.textContent("#contact-facts"), seen[0]);
  await page.mouse.click(box.x + pixel(1, 1.5)[0], box.y + pixel(1, 1.5)[1]);
  assert.equal(await page.textContent("#contact-facts"), "");
  await page.uncheck("#layer-contacts");
  // Blocks by the state of their joints: the resting one sticks, the falling one touches nothing.
  for (const layer of ["crosses", "monitors", "outline"]) await page.uncheck(`#layer-${layer}`);
  await page.selectOption("#field", "joint");
  await page.selectOption("#block", "-1");
  await show_frame(page, 4);
  near(await colour(page, pixel(1, 1.5)), STICKING, 2, "the block that rests");
  near(await colour(page, pixel(-6, 7.5)), [196, 198, 200], 2, "the block that falls");
  assert.match(await page.textContent("#legend"), /sticking.*slipping/);
  await page.selectOption("#field", "displacement");
}

/// The element with an id of a WebM file (RFC 8794): its bytes, or null.
function part(bytes, ids) {
  let [at, end] = [0, bytes.length];
  for (const id of ids) {
    let found = false;
    while (at < end && !found) {
      const id_length = Math.clz32(bytes[at]) - 23;
      const name = bytes.subarray(at, at + id_length).toString("hex");
      at += id_length;
      const length = Math.clz32(bytes[at]) - 23;
      let size = BigInt(bytes[at] & (0xff >> length));
      for (let k = 1; k < length; ++k) size = (size << 8n) | BigInt(bytes[at + k]);
      at += length;
      found = name === id;
      if (found) end = Math.min(end, at + Number(size));
      else at += Number(size);
    }
    if (!found) return null;
  }
  return bytes.subarray(at, end);
}

/// A film lasts as long as the run at the speed that is chosen, and has the size of the picture.
export async function test_film(page) {
  await page.selectOption("#speed", "1");
  const [download] = await Promise.all([page.waitForEvent("download", { timeout: 120000 }), page.click("#film")]);
  assert.match(download.suggestedFilename(), /film\.webm$/);
  const film = readFileSync(await download.path());
  const segment = "18538067";
  const duration = part(film, [segment, "1549a966", "4489"]);
  const scale = part(film, [segment, "1549a966", "2ad7b1"]);
  const seconds = (duration.length === 8 ? duration.readDoubleBE() : duration.readFloatBE()) * scale.readUIntBE(0, scale.length) * 1e-9;
  assert.ok(Math.abs(seconds - (0.8 + 1)) < 0.1, `the film takes ${seconds} s`); // the run takes 0.8 s; its end stays for a second
  const width = part(film, [segment, "1654ae6b", "ae", "e0", "b0"]);
  const box = await page.locator("#view").boundingBox();
  assert.ok(Math.abs(width.readUIntBE(0, width.length) - box.width) <= 2, "the film has another width than the picture");
  return film.length;
}

export async function test_theme(page) {
  await page.selectOption("#theme", "dark");
  await drawn(page);
  near(await colour(page, [30, 200]), [28, 32, 36], 2, "the dark ground");
  await until(page, () => /time[\d.]+ s/.test(document.querySelector("#energy-chart .u-legend").textContent)); // the chart keeps its instant
  await page.selectOption("#theme", "light");
  await drawn(page);
  near(await colour(page, [30, 200]), [255, 255, 255], 2, "the light ground");
  await page.selectOption("#theme", "system");
}
