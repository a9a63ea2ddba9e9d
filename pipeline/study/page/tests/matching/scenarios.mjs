// Participants of a matching experiment in a real browser.
//   node scenarios.mjs NAME FOLDER-OR-ADDRESS [PICTURES]
// prints what came of it as JSON: the files that were saved, and whatever the browser complained of.
import { resolve } from "node:path";
import { opener, phone, withFiles } from "../live/opened.mjs";
import { accessibilityOf, picturesIn } from "../live/seen.mjs";
import { openBrowser } from "../questionnaire/participant.mjs";
import { downloadsOf, take } from "./participant.mjs";

const [name, given, pictures] = process.argv.slice(2);
const address = given.startsWith("http") ? given : `file://${resolve(given)}/index.html`;
const desktop = { viewport: { width: 1366, height: 768 } };

const browser = await openBrowser();

const openFor = opener(browser, downloadsOf);
const open = (how = desktop) => openFor(address, how);
const allOf = (opened, more) => withFiles(opened, 4, more);

async function whole() {
  const opened = await open();
  await take(opened.page, { each: picturesIn(pictures, opened.page, "desktop", "matching") });
  return allOf(opened);
}

async function keys() {
  const opened = await open();
  await take(opened.page, { by_keys: true });
  return allOf(opened);
}

/** A reload in the first trial, while its clock runs. */
async function reload() {
  const opened = await open();
  const { page } = opened;
  let reloads = 0;
  await take(page, { each: async (seen) => {
    if (seen !== "matching" || reloads > 0) return false;
    await page.locator(".control .main:visible").click();
    await page.waitForFunction(() => document.querySelector(".matching").dataset.step !== "guess");
    reloads += 1;
    await opened.reload();
    return true;
  } });
  return allOf(opened, { reloads });
}

/**
 * Guesses before anything is seen of one, with a reload while the second is made and another one while the
 * first match goes on; the examples play beside. What was seen comes in order, with the motions that were asked for.
 */
async function guessesFirst() {
  const opened = await open();
  const { page } = opened;
  const story = [];
  const shows = [];
  const reload = async () => {
    story.push("reload");
    await opened.reload();
    return true;
  };
  page.on("request", (request) => { if (/\/live\/make$/.test(request.url())) story.push("make"); });
  const withPicture = picturesIn(pictures, page, "guesses", "matching");
  const film = () => page.locator(".examples-film .example-name").textContent();
  const look = () => page.evaluate(() => {
    const { step, interface: kind } = document.querySelector(".matching").dataset;
    const readings = document.querySelector(".readings");
    const figures = Number(document.querySelector(".stage > .figure-view").dataset.shown);
    return { step, kind, figures, d: readings.dataset.d ?? null, told: getComputedStyle(readings).visibility };
  });
  const count = (what) => story.filter((one) => one.startsWith(what)).length;
  let name = "";
  await take(page, { each: async (seen) => {
    await withPicture(seen);
    if (seen !== "matching") return false;
    const { step, kind, ...shown } = await look();
    story.push(`${step === "guess" ? "guess" : "match"} ${kind}`);
    if (step === "guess") {
      await page.waitForFunction(() => document.querySelector(".example-name").textContent);
      name = await film();
      await page.locator('.sliders input[type="range"]').first().evaluate((slider) => {
        slider.value = String(Number(slider.value) + 0.03);
        slider.dispatchEvent(new Event("input", { bubbles: true }));
      });
      await page.waitForTimeout(300);  // for what should not come
      shows.push(shown, await look().then(({ figures, d, told }) => ({ figures, d, told })));
      if (count("guess") === 2 && count("reload") === 0) return reload();
    } else if (count("reload") === 1) return reload();
    return false;
  } });
  return allOf(opened, { story, shows, film: name });
}

/** On a phone's screen: what is told there, or the whole of it where phones are served. */
async function onPhone() {
  const opened = await open(phone);
  const text = await opened.page.locator("main").innerText();
  const isTold = (await opened.page.locator(".button").count()) === 0;
  if (!isTold) await take(opened.page, { each: picturesIn(pictures, opened.page, "phone", "matching") });
  return allOf(opened, { text, is_told: isTold });
}

/** As wide as a laptop and as a phone. */
const accessibility = () => accessibilityOf([desktop, { viewport: phone.viewport }], open, take);

const scenarios = { whole, keys, reload, guesses_first: guessesFirst, on_phone: onPhone, accessibility };
try {
  console.log(JSON.stringify(await scenarios[name]()));
} finally {
  await browser.close();
}
