// How long a moved slider takes until the motion that comes of it is drawn, in headless Chromium.
//   node latency.mjs FOLDER-OR-ADDRESS [SLIDERS] [CHANGES]
// takes an experiment up to a trial of each interface, adds sliders from the list until there are
// SLIDERS (10), moves one after the other CHANGES (25) times, and prints a line an interface:
// milliseconds from the slider's event to the end of the frame that shows the motion, and to the end of
// the one that tells its D.
import { resolve } from "node:path";
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

const latencies = (page) => page.evaluate(async (most) => {
  const readings = document.querySelector(".readings");
  const rows = [...document.querySelectorAll('.sliders input[type="range"]')];
  const isOver = () => document.querySelector(".matching").dataset.step === "over";
  const frame = () => new Promise((drawn) => requestAnimationFrame(() => {
    const channel = new MessageChannel();
    channel.port1.onmessage = drawn;  // once the frame is drawn
    channel.port2.postMessage(0);
  }));
  const changed = (element, attribute) => new Promise((known) => {
    const watch = new MutationObserver(() => { watch.disconnect(); known(true); });
    watch.observe(element, { attributes: true, attributeFilter: [attribute] });
    setTimeout(() => { watch.disconnect(); known(false); }, 5000);  // the trial is over, or nothing answers
  });
  const view = document.querySelector(".figure-view");
  const took = [];
  for (let i = 0; i < most + 2 && !isOver(); i += 1) {
    const slider = rows[i % rows.length];
    slider.value = String(((Number(slider.value) * 100 + 37) % 100) / 100);
    const before = performance.now();
    const until = (element, attribute) => changed(element, attribute)
      .then((known) => known && frame().then(() => performance.now() - before));
    const [told, shown] = [until(readings, "data-d"), until(view, "data-shown")];
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    const times = { shown: await shown, told: await told };
    if (!times.shown || !times.told) break;
    if (i >= 2) took.push(times);  // the first ones still compile
    await new Promise((rested) => setTimeout(rested, 30));
  }
  return { took, sliders: rows.length };
}, Number(changes));

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
for (const [kind, { took, sliders: count }] of measured) {
  const of = (what) => {
    const sorted = took.map((one) => one[what]).sort((a, b) => a - b);
    const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))].toFixed(1);
    return `median ${at(0.5)} ms, 90 % below ${at(0.9)} ms`;
  };
  console.log(`${kind}: ${count} sliders, ${took.length} changes; motion: ${of("shown")}; D: ${of("told")}`);
}
