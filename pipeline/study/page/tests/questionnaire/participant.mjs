// Somebody who takes a questionnaire in a browser, by mouse or by keyboard alone.
import { chromium } from "playwright-core";
import { isPast, mark, savedTexts, sight } from "./pages.mjs";

export async function openBrowser() {
  return chromium.launch({
    executablePath: process.env.MIEN_CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu", "--mute-audio", "--enable-unsafe-swiftshader"],
  });
}

const openAnswers = (page) =>
  page.waitForFunction(() => !document.querySelector(".answers").inert, null, { timeout: 30000 });

/** Checks are answered as they say, or not, by somebody careless. */
const placeOf = (wanted, turn, all, careless = false) => {
  const [first, last] = careless ? [all - 1, 0] : [0, all - 1];
  return /leftmost/.test(wanted) ? first : /rightmost/.test(wanted) ? last : turn % all;
};

/** The place of the answer that a check asks for by its text, of these inputs; −1 if it asks for none. */
const namedPlace = (inputs, wanted) => {
  const word = /choose “(.+)”/.exec(wanted)?.[1];
  return word === undefined ? -1 : inputs.evaluateAll((all, asked) => all.findIndex((input) =>
    (input.getAttribute("aria-label") ?? input.labels[0].innerText) === asked ||
    input.labels[0].innerText === asked), word);
};

/** Plays all films of a grid, and the reference, by their buttons. */
async function playGrid(page, press) {
  for (const [index, play] of (await page.locator(".play-film").all()).entries()) {
    await page.waitForFunction((at) => !document.querySelectorAll(".play-film")[at].disabled, index, { timeout: 30000 });
    await press(play);
    await page.waitForFunction((at) => document.querySelectorAll(".play-film .seen-mark")[at].textContent, index,
      { timeout: 30000 });
  }
}

/** Rates a film while it plays, by mouse or by keys; the focus is then on the button that goes on. */
async function rateWhilePlaying(page, byKeys) {
  await page.waitForSelector(".play:not([hidden])", { timeout: 30000 });
  if (byKeys) await page.keyboard.press("Space");
  else await page.locator(".play").click();
  await page.waitForFunction(() => document.querySelector("video").currentTime > 0.3, null, { timeout: 30000 });
  const box = await page.locator(".marker").boundingBox();
  if (byKeys) await page.keyboard.down("ArrowRight");
  else await page.mouse.click(box.x + 0.7 * box.width, box.y + box.height / 2);
  if (byKeys) await page.waitForTimeout(300);
  if (byKeys) await page.keyboard.up("ArrowRight");
  await page.waitForFunction(() => document.activeElement?.matches(".answers .main"), null, { timeout: 60000 });
}

/** Answers of a trial by clicks: place (index + number of the trial) of each scale. */
async function answerByMouse(page, number, careless) {
  if (await page.locator(".grid-stage").count()) {
    await playGrid(page, (play) => play.click());
  } else if (await page.locator(".marker").count()) {
    await rateWhilePlaying(page, false);
    return page.locator(".answers .main").click();
  } else if (await page.locator(".stage").count()) {
    await page.locator(".play").click();
    await openAnswers(page);
  }
  const wanted = await page.locator(".question-text").textContent();
  const asked = page.locator("fieldset.asked");
  for (let i = 0; i < (await asked.count()); i += 1) {
    const inputs = asked.nth(i).locator("input");
    const named = await namedPlace(inputs, wanted);
    const place = named >= 0 ? named : placeOf(wanted, i + number, await inputs.count(), careless);
    await inputs.nth(place).click({ force: true });
  }
  for (const slider of await page.locator('.asked input[type="range"]').all()) {
    const box = await slider.boundingBox();
    const share = /rightmost|to the right/.test(wanted) ? 0.999 : /leftmost|to the left/.test(wanted) ? 0.001 : 0.7;
    await slider.click({ position: { x: box.width * share, y: box.height / 2 } });
  }
  for (const words of await page.locator(".asked.words textarea, .asked.words input").all()) await words.fill("slow, heavy");
  if (await page.locator("#comment").count()) await page.locator("#comment").fill(`comment, "${number}"`);
  await page.locator(".answers .main").click();
}

/** A grid by keys: Enter goes to what is missing, a button that plays or a slider. */
async function answerGridByKeys(page) {
  await page.waitForFunction(() => document.activeElement?.matches(".play-film"), null, { timeout: 30000 });
  await playGrid(page, async (play) => {
    await play.focus();
    await page.keyboard.press("Space");
  });
  for (let i = 0; i < (await page.locator(".grid-row[data-place]").count()); i += 1) {
    await page.locator(".answers .main").focus();
    await page.keyboard.press("Enter");  // says what is missing, and goes there
    await page.waitForFunction((at) => document.activeElement?.closest(".grid-row")?.dataset.place === String(at), i + 1);
    for (let step = 0; step <= i; step += 1) await page.keyboard.press("ArrowRight");
  }
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.activeElement?.matches(".answers .main"));
  await page.keyboard.press("Enter");
}

/** The same without a mouse: whatever has the focus is used. */
async function answerByKeys(page, number) {
  if (await page.locator(".grid-stage").count()) return answerGridByKeys(page);
  if (await page.locator(".marker").count()) {
    await rateWhilePlaying(page, true);
    return page.keyboard.press("Enter");
  }
  const focus = (what) => page.waitForFunction((css) => document.activeElement?.matches(css), what, { timeout: 30000 });
  if (await page.locator(".stage").count()) {
    await focus(".play");
    await page.keyboard.press("Space");
    await openAnswers(page);
  }
  const wanted = await page.locator(".question-text").textContent();
  const asked = await page.locator("fieldset.asked").count();
  for (let i = 0; i < asked; i += 1) {
    await focus("fieldset.asked, fieldset.asked input");
    const all = await page.evaluate(() =>
      document.activeElement.closest("fieldset").querySelectorAll("input").length);
    const named = await namedPlace(page.locator("fieldset.asked").nth(i).locator("input"), wanted);
    const place = named >= 0 ? named : placeOf(wanted, i + number, all);
    if (i % 2 === 0 || all > 9) {
      await page.keyboard.press(String(place + 1));
    } else {
      for (let step = 0; step <= place; step += 1) await page.keyboard.press("ArrowRight");
      await page.keyboard.press("Enter");
    }
  }
  for (let i = 0; i < (await page.locator('.asked input[type="range"]').count()); i += 1) {
    await focus('input[type="range"]');
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("Tab");
  }
  if (await page.locator(".asked.words").count()) await page.keyboard.type("slow, heavy");
  for (let i = 0; i < 4 && !(await page.evaluate(() => document.activeElement.matches(".answers .main"))); i += 1)
    await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
}

async function passText(page, byKeys, age) {
  const number = page.locator('.question input[inputmode="decimal"]');
  const choice = page.locator(".question .line input").first();
  if (await page.locator(".card-width").count()) await page.locator(".card-width input").press("ArrowRight");
  if (byKeys && await number.count()) {
    await page.keyboard.type("31");
    await page.keyboard.press("Tab");
    await page.keyboard.press("2");
  } else if (!byKeys) {
    if (await number.count()) await number.fill(age);
    if (await choice.count()) await choice.check();
  }
  if (!byKeys) return page.locator(".page .buttons .main").click();
  for (let i = 0; i < 8 && !(await page.evaluate(() => document.activeElement.matches(".main"))); i += 1)
    await page.keyboard.press("Tab");
  return page.keyboard.press("Enter");
}

/**
 * Takes the questionnaire that is open to its end. `each(sight, number)` is told of every page
 * before it is answered; it may reload, and then returns true. Whoever is careless fails the attention checks.
 */
export async function take(
  page, { by_keys: byKeys = false, careless = false, age = "27", each = async () => false } = {}) {
  for (let pages = 0; pages < 500; pages += 1) {
    await page.waitForSelector(".page, .trial", { timeout: 30000 });
    const seen = await sight(page, "trial");
    const number = seen === "trial"
      ? Number((await page.locator(".trial-head h1").textContent()).match(/\d+/)[0]) : 0;
    if (await each(seen, number)) continue;
    if (seen === "end") return;
    const before = await mark(page, "trial");
    if (seen === "text") await passText(page, byKeys, age);
    if (seen === "trial") await (byKeys ? answerByKeys : answerByMouse)(page, number, careless);
    await isPast(page, "trial", before);
  }
  throw new Error("the questionnaire has no end");
}

/** Texts of the files that the page saves. */
export const downloadsOf = (page) => savedTexts(page, ["answers", "participant", "records"]);
