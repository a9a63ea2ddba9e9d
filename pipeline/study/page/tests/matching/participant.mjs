// Somebody who takes a matching experiment in a browser, by mouse or by keyboard alone, and finds the
// sliders' places as one would: one after the other, up or down, by what the distance says.

import { isPast, mark, savedTexts, sight } from "../questionnaire/pages.mjs";

/** Moves sliders inside the page, each move once its distance is known, until the trial is over. */
const search = (page) => page.evaluate(async () => {
  const pause = (ms) => new Promise((done) => setTimeout(done, ms));
  const matching = document.querySelector(".matching");
  const readings = document.querySelector(".readings");
  const sliders = [...document.querySelectorAll('.sliders input[type="range"]')];
  const isOver = () => matching.dataset.step === "over";
  const look = async (slider, value) => {
    delete readings.dataset.d;
    slider.value = String(value);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    for (let i = 0; i < 4000 && readings.dataset.d === undefined && !isOver(); i += 1) await pause(2);
    return Number(readings.dataset.d ?? 0);
  };
  let best = Number(readings.dataset.d);
  for (let step = 0.24; step > 0.009 && !isOver(); step /= 2) {
    for (let better = true; better && !isOver();) {
      better = false;
      for (const slider of sliders) {
        const from = Number(slider.value);
        for (const by of [step, -step]) {
          const to = Math.round(100 * Math.min(1, Math.max(0, from + by))) / 100;
          if (to === from || isOver()) continue;
          const d = await look(slider, to);
          if (isOver() || d < best - 1e-6) {
            best = d;
            better = true;
            break;
          }
          await look(slider, from);
        }
      }
    }
  }
  return isOver();
});

/** The same by keys: whatever has the focus is used. */
async function searchByKeys(page) {
  const d = () => page.evaluate(() => Number(document.querySelector(".readings").dataset.d ?? "NaN"));
  const isOver = () => page.evaluate(() => document.querySelector(".matching").dataset.step === "over");
  const press = async (key, times) => {
    for (let i = 0; i < times; i += 1) await page.keyboard.press(key);
    await page.waitForTimeout(120);
    return d();
  };
  const count = await page.locator('.sliders input[type="range"]').count();
  let best = await d();
  for (const times of [16, 8, 4, 2, 1]) {
    for (let better = true; better;) {
      better = false;
      for (let i = 0; i < count; i += 1) {
        for (const [there, back] of [["ArrowRight", "ArrowLeft"], ["ArrowLeft", "ArrowRight"]]) {
          const from = await page.evaluate(() => document.activeElement.value);
          const found = await press(there, times);
          if (await isOver()) return true;
          if (found < best - 1e-6) {
            best = found;
            better = true;
            break;
          }
          // Ends of a slider stop some of the steps.
          while (await page.evaluate(() => document.activeElement.value) !== from)
            await page.keyboard.press(back);
        }
        await page.keyboard.press(i + 1 < count ? "Tab" : "Shift");
      }
      for (let i = 1; i < count; i += 1) await page.keyboard.press("Shift+Tab");
    }
  }
  return isOver();
}

const tabTo = async (page, css) => {
  for (let i = 0; i < 80; i += 1) {
    if (await page.evaluate((wanted) => document.activeElement?.matches(wanted), css)) return;
    await page.keyboard.press("Tab");
  }
  throw new Error(`no Tab leads to ${css}`);
};

async function match(page, byKeys, seen) {
  const pressMain = async () => {
    if (!byKeys) return page.locator(".control .main:visible").click();
    await tabTo(page, ".control .main");
    return page.keyboard.press("Enter");
  };
  const step = () => page.evaluate(() => document.querySelector(".matching")?.dataset.step ?? "gone");
  // A guess that was made before is shown without being asked for.
  if (await step() === "guess") {
    await seen("guess");
    await pressMain();
  }
  await page.waitForFunction(
    () => !["guess", "show"].includes(document.querySelector(".matching")?.dataset.step), null, { timeout: 60000 });
  if (await step() === "gone") return;  // that was a guess by itself
  await seen("adjust");
  if (await page.evaluate(() => document.querySelector(".matching").dataset.step === "adjust")) {
    if (byKeys) {
      await tabTo(page, '.sliders input[type="range"]');
      await searchByKeys(page);
    } else await search(page);
  }
  await page.waitForFunction(() => document.querySelector(".matching").dataset.step === "over", null, { timeout: 400000 });
  await seen("over");
  await pressMain();
}

/**
 * Takes the experiment that is open to its end. `each(sight, title)` is told of every page and of every
 * step of a trial ("guess", "adjust", "over"); of pages it may reload, and then returns true.
 */
export async function take(page, { by_keys: byKeys = false, each = async () => false, most = 500 } = {}) {
  for (let pages = 0; pages < most; pages += 1) {
    await page.waitForSelector(".page, .matching", { timeout: 60000 });
    const seen = await sight(page, "matching");
    if (seen === "load") {
      await page.waitForFunction(() => !document.querySelector(".page progress"), null, { timeout: 60000 });
      continue;
    }
    const title = await page.locator("h1").first().textContent();
    if (await each(seen, title)) continue;
    if (seen === "end") return;
    const before = await mark(page, "matching");
    if (seen === "matching") await match(page, byKeys, (step) => each(step, title));
    else if (byKeys) {
      await tabTo(page, ".buttons .main");
      await page.keyboard.press("Enter");
    } else await page.locator(".page .buttons .main").click();
    await isPast(page, "matching", before);
  }
}

/** Texts of the files that the page saves. */
export const downloadsOf = (page) => savedTexts(page, ["trials", "changes", "participant", "records"]);
