// How long a moved slider takes until the motion that comes of it is drawn, in headless Chromium.
//   node latency.mjs FOLDER-OR-ADDRESS [SLIDERS] [CHANGES]
// takes an experiment up to a trial of each interface, adds sliders from the list until there are
// SLIDERS (10), moves one after the other CHANGES (25) times, and prints a line an interface:
// milliseconds from the slider's event to the end of the frame that shows the motion, and to the end of
// the one that tells its D.
import { resolve } from "node:path";
import { sliderLatencies, summaryOf } from "../live/slider_latency.mjs";
import { openBrowser } from "../questionnaire/participant.mjs";
import { take } from "./participant.mjs";

const [given, sliders = "10", changes = "25"] = process.argv.slice(2);
const address = given.startsWith("http") ? given : `file://${resolve(given)}/index.html`;
const interfaces = 3;
const measured = new Map();

class Enough extends Error {}

async function addSliders(page) {
  for (let i = 0; i < Number(sliders); i += 1) {
    if (await page.locator('.sliders input[type="range"]').count() >= Number(sliders)) return;
    const add = page.locator(".offer button");
    if (await add.count() === 0) return;
    await add.click();
  }
}

const latencies = (page) => sliderLatencies(page, { sliders: '.sliders input[type="range"]',
  over: '.matching[data-step="over"]', most: Number(changes),
  seen: { shown: [".figure-view", "data-shown"], told: [".readings", "data-d"] } });

const browser = await openBrowser();
const page = await (await browser.newContext({ viewport: { width: 1366, height: 768 } })).newPage();
await page.goto(address);
try {
  await take(page, { each: async (seen) => {
    if (seen === "guess") await addSliders(page);
    if (seen !== "adjust") return false;
    const kind = await page.evaluate(() => document.querySelector(".matching").dataset.interface);
    if ((measured.get(kind)?.took.length ?? 0) >= Number(changes)) return false;
    const found = await latencies(page);
    const took = [...(measured.get(kind)?.took ?? []), ...found.took].slice(0, Number(changes));
    measured.set(kind, { took, sliders: found.sliders });
    const done = [...measured.values()].filter((one) => one.took.length >= Number(changes));
    if (done.length === interfaces) throw new Enough();
    return false;
  } });
} catch (error) {
  if (!(error instanceof Enough)) throw error;
}
await browser.close();
for (const [kind, { took, sliders: count }] of measured)
  console.log(`${kind}: ${count} sliders, ${took.length} changes; motion: ${summaryOf(took, "shown")}; D: ${summaryOf(took, "told")}`);
