// Viewing distances that are measured with the blind spot, in a real browser.
//   node blind_spot.mjs FOLDER
// prints what came of it as JSON; FOLDER holds an exported questionnaire with display: {blind_spot: true}. The screen
// is calibrated at 400 px for a card.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { bundled } from "../bundled.mjs";
import { desktop, opener, withFiles } from "./opened.mjs";
import { savedAll } from "./pages.mjs";
import { openBrowser, take } from "./participant.mjs";

const { measuredDistance, viewingDistance } = await bundled("questionnaire/viewing_distance.ts");
assert.ok(Math.abs(viewingDistance(12) - 49.983) < 0.001);  // 12 cm / tan 13.5°
assert.equal(measuredDistance([50, 90, 48, 51, 30]), 50);
assert.equal(measuredDistance([50, 52]), 51);
assert.equal(measuredDistance([19, 19, 19]), null);
assert.equal(measuredDistance([20, 20, 20]), 20);
assert.equal(measuredDistance([201]), null);

const folder = resolve(process.argv[2]);
const browser = await openBrowser();
const open = opener(browser);
const pxPerCm = 400 / 8.56;

async function calibrated(participant) {
  const opened = await open(`file://${folder}/index.html?participant=${participant}`, { ...desktop, bypassCSP: true });
  const { page } = opened;
  await page.locator(".page .buttons .main").click();
  await page.locator(".card-width input").fill("400");
  await page.locator(".calibration .main").click();
  await page.waitForSelector(".blind-spot");
  return opened;
}

/** One reading, by keys: the dot disappears for somebody whose eyes are that far away. */
async function read(page, distanceCm) {
  await page.keyboard.press("Space");
  const apart = distanceCm * Math.tan((13.5 * Math.PI) / 180) * pxPerCm;
  await page.waitForFunction((far) => {
    const [sight, dot] = [".sight", ".dot"].map((css) => document.querySelector(css)?.getBoundingClientRect());
    if (!dot || sight.left - dot.left < far) return false;
    document.activeElement.click();  // as Space does, in the same frame
    return true;
  }, apart, { polling: "raf", timeout: 20000 });
}

async function measured() {
  const opened = await calibrated("p001");
  const { page } = opened;
  const told = { picture: [] };
  await page.evaluate(readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8"));
  told.faults = (await page.evaluate(() => window.axe.run({ preload: false }))).violations.map(({ id }) => id);
  for (const distance of [48, 52, 50, 49, 51]) {
    await read(page, distance);
    if (process.env.MIEN_PICTURES && distance === 52)
      await page.screenshot({ path: `${process.env.MIEN_PICTURES}/blind-spot.png` });
  }
  await page.waitForFunction(() => !document.querySelector(".blind-spot"));
  let reloads = 0;
  await take(page, { each: async (sight, number) => {
    if (sight !== "trial" || number !== 2 || reloads > 0) return false;
    reloads += 1;
    await page.reload();  // it is not measured again
    return true;
  } });
  return withFiles(opened, told);
}

/** Somebody who cannot do it, and somebody for whom the dot leaves the page again and again. */
async function unmeasured() {
  const opened = await calibrated("p002");
  await opened.page.keyboard.press("Tab");
  await opened.page.keyboard.press("Enter");
  await opened.page.waitForFunction(() => !document.querySelector(".blind-spot"));
  const narrow = await calibrated("p003");
  await narrow.page.setViewportSize({ width: 360, height: 700 });
  const said = [];
  for (let tries = 0; tries < 3; tries += 1) {
    await narrow.page.keyboard.press("Space");
    await narrow.page.waitForFunction((all) => !document.querySelector(".blind-spot") ||
      (document.querySelector('.wide-field [role="status"]').textContent !== "" &&
       document.querySelectorAll(".blind-spot > div").length === 2 &&
       document.querySelector(".wide-field .main").textContent === all), "Start", { timeout: 20000 });
    said.push(await narrow.page.locator("main").innerText());
  }
  await narrow.page.waitForFunction(() => !document.querySelector(".blind-spot"));
  await take(opened.page);
  return withFiles(opened, { said: said[0] });
}

try {
  console.log(JSON.stringify({ measured: await measured(), unmeasured: await unmeasured() }));
} finally {
  await savedAll();
  await browser.close();
}
