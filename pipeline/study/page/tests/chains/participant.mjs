// Somebody who takes an experiment with chains in a browser, by mouse, by touch or by keyboard alone.
import { isPast, mark, savedTexts, sight } from "../questionnaire/pages.mjs";

/** How the trials are told apart, which share a page. */
const countOf = (page) => page.evaluate(() => Number(document.querySelector(".chains")?.dataset.count ?? 0));

/** Until a trial can be answered; how manieth of its page it is. */
export async function trialOpened(page, after = 0) {
  await page.waitForFunction((former) => {
    const shown = document.querySelector(".chains");
    return shown && Number(shown.dataset.count ?? 0) > former && !shown.querySelector("[inert]");
  }, after, { timeout: 60000 });
  return countOf(page);
}

/** Until another trial, or another page. */
const isAnswered = (page, count) => page.waitForFunction((former) => {
  const shown = document.querySelector(".chains");
  return shown ? Number(shown.dataset.count) > former && !shown.querySelector("[inert]") : !!document.querySelector(".page");
}, count, { timeout: 60000 });

/** Until a motion that comes of `change` is shown. */
async function withMotion(page, change) {
  const shown = () => page.locator(".figure-view").getAttribute("data-shown");
  const before = await shown();
  await change();
  await page.waitForFunction((former) => document.querySelector(".figure-view").dataset.shown !== former, before,
    { timeout: 20000 });
}

/** The place of the slider, from 0 on the left, that somebody chooses in the trial of that count: away from where it
    stands. */
function placeOf(count, standing) {
  const place = 0.15 + 0.7 * ((0.37 * count) % 1);
  return Math.abs(place - standing) > 0.1 ? place : place + (place > 0.5 ? -0.25 : 0.25);
}

/** What was chosen in each trial of a page: places of sliders, from 0 on the left, or numbers of figures. */
const chosen = new WeakMap();
export const chosenOn = (page) => chosen.get(page) ?? [];
const note = (page, what) => chosen.set(page, [...chosenOn(page), what]);

/** What an attention check asks for, "left" or "right", or the other of somebody careless; undefined of other trials. */
const checkOf = async (page, careless) => {
  const asked = await page.evaluate(() => document.querySelector(".chains").dataset.check);
  return asked && careless ? (asked === "left" ? "right" : "left") : asked;
};

/** Moves the slider to an end, by keys or with the mouse. */
async function slideTo(page, how, side) {
  const slider = page.locator(".slider-control input");
  // From the other end, so that it moves.
  await slider.press(side === "left" ? "End" : "Home");
  await withMotion(page, () => slider.press(side === "left" ? "Home" : "End"));
  note(page, Number(await slider.inputValue()));
  await (how === "touch" ? page.locator(".slider-control .main").tap() : page.locator(".slider-control .main").click());
}

async function slide(page, how, count, careless) {
  const slider = page.locator(".slider-control input");
  const side = await checkOf(page, careless);
  if (side) return slideTo(page, how, side);
  if (how === "keys") {
    await page.waitForFunction(() => document.activeElement?.matches(".slider-control input"));
    const key = Number(await slider.inputValue()) > 0.5 ? "ArrowLeft" : "ArrowRight";
    await withMotion(page, async () => { for (let i = 0; i <= count % 4; i += 1) await page.keyboard.press(key); });
    note(page, Number(await slider.inputValue()));
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => document.activeElement?.matches(".slider-control .main"));
    return page.keyboard.press("Enter");
  }
  const box = await slider.boundingBox();
  const place = placeOf(count, Number(await slider.inputValue()));
  const at = { x: box.x + place * box.width, y: box.y + box.height / 2 };
  await withMotion(page, () => (how === "touch" ? page.touchscreen.tap(at.x, at.y) : page.mouse.click(at.x, at.y)));
  note(page, Number(await slider.inputValue()));
  await (how === "touch" ? page.locator(".slider-control .main").tap() : page.locator(".slider-control .main").click());
}

/** Two of three times the first figure. */
async function choose(page, how, count, careless) {
  await page.waitForTimeout(450);  // sooner, nothing is chosen
  const side = await checkOf(page, careless);
  const number = side ? (side === "left" ? 1 : 2) : count % 3 === 0 ? 2 : 1;
  note(page, number);
  if (how === "keys") return page.keyboard.press(String(number));
  const pick = page.locator(`[data-pick="${number}"]`);
  return how === "touch" ? pick.tap() : pick.click();
}

export async function answer(page, how = "mouse", careless = false) {
  const count = await trialOpened(page);
  const isGibbs = (await page.locator(".slider-control").count()) > 0;
  await (isGibbs ? slide : choose)(page, how, count, careless);
  await isAnswered(page, count);
}

/** Goes on from a page of texts. */
async function goOn(page, how) {
  const before = await mark(page, "chains");
  const main = page.locator(".page .buttons .main");
  if (how === "keys") {
    await main.focus();
    await page.keyboard.press("Enter");
  } else await (how === "touch" ? main.tap() : main.click());
  await isPast(page, "chains", before);
}

/**
 * Takes the experiment that is open to its end. `each(sight, title)` is told of every page and of every trial
 * ("chains"); it may reload, and then returns true. Whoever is `careless` fails attention checks.
 */
export async function take(page, { how = "mouse", careless = false, each = async () => false } = {}) {
  for (let pages = 0; pages < 500; pages += 1) {
    await page.waitForSelector(".page, .chains", { timeout: 60000 });
    const seen = await sight(page, "chains");
    if (seen === "load") {
      await page.waitForFunction(() => !document.querySelector(".page progress"), null, { timeout: 60000 });
      continue;
    }
    if (seen === "chains") await trialOpened(page);
    if (await each(seen, await page.locator("h1").first().textContent())) continue;
    if (seen === "end") return;
    await (seen === "chains" ? answer(page, how, careless) : goOn(page, how));
  }
  throw new Error("the experiment has no end");
}

/** Texts of the files that the page saves. */
export const downloadsOf = (page) => savedTexts(page, ["steps", "participant", "records"]);
