// Films that are rated while they play, in a real browser.
//   node continuous.mjs SCENARIO FOLDER
// prints what came of it as JSON; FOLDER holds an exported questionnaire of continuous trials.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { desktop, opener, withFiles } from "./opened.mjs";
import { savedAll } from "./pages.mjs";
import { openBrowser, take } from "./participant.mjs";

const [name, folder] = process.argv.slice(2);
const onDisk = `file://${resolve(folder)}/index.html`;
const browser = await openBrowser();
const open = opener(browser);

const filmAt = (page, seconds) => page.waitForFunction((time) =>
  document.querySelector("video")?.currentTime >= time, seconds, { timeout: 60000 });
const isOver = (page) => page.waitForFunction(() => document.activeElement?.matches(".answers .main"), null,
  { timeout: 60000 });
const isNext = (page, place) => page.waitForFunction((before) =>
  document.querySelector(".trial-head h1")?.textContent !== before, place);
const placeOf = (page) => page.locator(".trial-head h1").textContent();

/** Notes at which time of the film keys and buttons are pressed and let go. */
const watchInput = (page) => page.evaluate(() => {
  window.noted = {};
  for (const name of ["keydown", "keyup", "pointerdown", "pointerup"])
    document.addEventListener(name, ({ key, repeat }) => {
      if (!repeat && key !== " ") window.noted[name] = document.querySelector("video")?.currentTime;
    }, true);
});
const noted = (page) => page.evaluate(() => window.noted);

/** Goes to the first trial, whose film is ready. */
async function atTrial(page) {
  await take(page, { each: async (sight) => sight === "trial" && Promise.reject(new Error("there")) })
    .catch((error) => { if (error.message !== "there") throw error; });
  await page.waitForSelector(".play:not([hidden])");
}

/** The first trial by keys alone: an arrow key is held for half a second; before the film it is tried. */
async function byKeys() {
  const opened = await open(`${onDisk}?participant=p001`);
  const { page } = opened;
  await atTrial(page);
  const told = { focus: await page.evaluate(() => document.activeElement.className) };
  await page.keyboard.down("ArrowLeft");
  await page.waitForTimeout(200);
  await page.keyboard.up("ArrowLeft");
  told.tried = Number(await page.locator(".marker").inputValue());
  // Nothing is there to go on with yet.
  const noteOf = () => page.locator(".answers .note").textContent();
  await page.keyboard.press("Enter");
  told.entered = await noteOf();
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("Enter");
  told.entered_nowhere = await noteOf();
  const goOn = page.locator(".answers .main");
  const state = async () => ({ is_disabled: await goOn.getAttribute("aria-disabled") === "true",
    note: await noteOf() });
  await goOn.click({ force: true });
  told.note = await noteOf();
  await watchInput(page);
  await page.keyboard.press("Space");
  await filmAt(page, 0.1);
  told.begins_at = Number(await page.locator(".marker").inputValue());
  told.playing = await state();
  await goOn.click({ force: true });
  told.pressed = await state();
  await filmAt(page, 1.2);
  await page.keyboard.down("ArrowRight");
  await filmAt(page, 1.7);
  await page.keyboard.up("ArrowRight");
  Object.assign(told, await noted(page));
  await isOver(page);
  told.over = await state();
  told.is_movable = await page.locator(".marker").isEnabled();
  told.can_replay = await page.locator(".play").isVisible();
  const place = await placeOf(page);
  await page.keyboard.press("Enter");
  await isNext(page, place);
  await take(page, { by_keys: true });
  return withFiles(opened, told);
}

/** The first trial by mouse: the marker is pressed and drawn to 80 % of its way; a film that stops has no further
    samples. */
async function byMouse() {
  const opened = await open(`${onDisk}?participant=p001`);
  const { page } = opened;
  await atTrial(page);
  await watchInput(page);
  await page.locator(".play").click();
  await filmAt(page, 0.6);
  await page.evaluate(() => {
    const video = document.querySelector("video");
    video.pause();
    setTimeout(() => void video.play(), 1500);
  });
  await filmAt(page, 1.2);
  const box = await page.locator(".marker").boundingBox();
  const x = (share) => box.x + 13 + share * (box.width - 26);  // the knob is 26 px wide
  await page.mouse.move(x(0.5), box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(x(0.8), box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  const told = await noted(page);
  await isOver(page);
  await page.keyboard.press("Enter");
  await take(page);
  return withFiles(opened, told);
}

/** Reloaded while the film plays, and again when it is over: each time it is rated anew. */
async function reloaded() {
  const opened = await open(`${onDisk}?participant=p001`);
  const { page } = opened;
  await atTrial(page);
  await page.keyboard.press("Space");
  await filmAt(page, 0.5);
  await page.keyboard.down("ArrowRight");
  await filmAt(page, 0.8);
  await page.reload();
  await atTrial(page);
  await page.keyboard.press("Space");
  await isOver(page);
  await page.reload();
  await atTrial(page);
  await take(page);
  return withFiles(opened);
}

/** Faults of accessibility before, during and after a film; and how the marker moves where one writes to the left. */
async function looked() {
  const { page } = await open(`${onDisk}?participant=p001`, { ...desktop, bypassCSP: true });
  await atTrial(page);
  await page.evaluate(readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8"));
  const faults = async () => (await page.evaluate(() => window.axe.run())).violations.map(({ id, nodes }) =>
    `${id}: ${nodes[0].html.slice(0, 120)}`);
  const told = { before: await faults() };
  await page.keyboard.press("Space");
  await filmAt(page, 0.2);
  told.during = await faults();
  await isOver(page);
  told.after = await faults();
  const other = (await open(`${onDisk}?participant=p002`)).page;
  await atTrial(other);
  await other.evaluate(() => { document.documentElement.dir = "rtl"; });
  const box = await other.locator(".marker").boundingBox();
  await other.mouse.click(box.x + 0.9 * box.width, box.y + box.height / 2);
  told.right_end = Number(await other.locator(".marker").inputValue());
  await other.keyboard.down("ArrowLeft");
  await other.waitForTimeout(400);
  await other.keyboard.up("ArrowLeft");
  told.moved_left = Number(await other.locator(".marker").inputValue());
  return told;
}

/** All that the pages between trials say, in their order, with those of the last page; reloaded at the fourth trial. */
async function twoScales() {
  const opened = await open(`${onDisk}?participant=p001`);
  const said = [];
  let reloads = 0;
  await take(opened.page, { each: async (sight, number) => {
    if (sight === "trial" && number === 4 && reloads === 0) {
      reloads += 1;
      await opened.page.reload();
      return true;
    }
    if (sight === "trial") {
      const poles = await opened.page.locator(".pole").allTextContents();
      said.push([`trial ${number}`, ...poles]);
    } else if (sight !== "load") {
      said.push((await opened.page.locator(".page").innerText()).split(/\n+/));
    }
    return false;
  } });
  return withFiles(opened, { said });
}

try {
  const scenarios = { keys: byKeys, mouse: byMouse, reloaded, looked, two_scales: twoScales };
  console.log(JSON.stringify(await scenarios[name]()));
} finally {
  await savedAll();
  await browser.close();
}
