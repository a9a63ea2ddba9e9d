// Participants of a matching experiment in a real browser.
//   node scenarios.mjs NAME FOLDER-OR-ADDRESS [PICTURES]
// prints what came of it as JSON: the files that were saved, and whatever the browser complained of.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { calmReload } from "../questionnaire/pages.mjs";
import { openBrowser } from "../questionnaire/participant.mjs";
import { downloadsOf, take } from "./participant.mjs";

const [name, given, pictures] = process.argv.slice(2);
const address = given.startsWith("http") ? given : `file://${resolve(given)}/index.html`;
const isServed = given.startsWith("http");
const desktop = { viewport: { width: 1366, height: 768 } };
const phone = { viewport: { width: 390, height: 844 }, screen: { width: 390, height: 844 },
  hasTouch: true, isMobile: true };

const browser = await openBrowser();

async function open(how = desktop) {
  const context = await browser.newContext({ acceptDownloads: true, ...how });
  const page = await context.newPage();
  const troubles = [];
  const asked = [];
  const posted = {};
  page.on("console", (message) => { if (message.type() === "error") troubles.push(message.text()); });
  page.on("pageerror", (error) => troubles.push(error.message));
  page.on("request", (request) => {
    if (/^http/.test(request.url())) asked.push(request.url());
    if (/\/records\//.test(request.url())) posted[request.url().split("/").pop()] = request.postDataJSON();
  });
  const saved = downloadsOf(page);
  const reloadPage = calmReload(page);
  await page.goto(address);
  return { page, troubles, saved, asked, posted, reloadPage };
}

/** Until all four files are there; a server has what it was given. */
async function withFiles({ page, saved, troubles, asked, posted }, more = {}) {
  for (let i = 0; !isServed && i < 100 && Object.keys(saved).length < 4; i += 1) await page.waitForTimeout(100);
  return { ...saved, troubles, requests: asked.length, posted, ...more };
}

/** Pictures of every page and step, where a folder for them is given. */
const withPictures = (page, begin) => {
  let shots = 0;
  return async (seen) => {
    if (pictures && seen !== "matching")
      await page.screenshot({ path: join(pictures, `${begin}-${String(shots++).padStart(2, "0")}-${seen}.png`) });
    return false;
  };
};

async function whole() {
  const opened = await open();
  await take(opened.page, { each: withPictures(opened.page, "desktop") });
  return withFiles(opened);
}

async function keys() {
  const opened = await open();
  await take(opened.page, { by_keys: true });
  return withFiles(opened);
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
    await opened.reloadPage();
    return true;
  } });
  return withFiles(opened, { reloads });
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
    await opened.reloadPage();
    return true;
  };
  page.on("request", (request) => { if (/\/live\/make$/.test(request.url())) story.push("make"); });
  const withPicture = withPictures(page, "guesses");
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
  return withFiles(opened, { story, shows, film: name });
}

/** On a phone's screen: what is told there, or the whole of it where phones are served. */
async function onPhone() {
  const opened = await open(phone);
  const text = await opened.page.locator("main").innerText();
  const isTold = (await opened.page.locator(".button").count()) === 0;
  if (!isTold) await take(opened.page, { each: withPictures(opened.page, "phone") });
  return withFiles(opened, { text, is_told: isTold });
}

/** Faults of accessibility on every page and in every step, as wide as a laptop and as a phone. */
async function accessibility() {
  const script = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
  const faults = [];
  let checked = 0;
  for (const how of [desktop, { viewport: phone.viewport }]) {
    const { page } = await open({ ...how, bypassCSP: true });
    await take(page, { each: async (seen, title) => {
      if (!(await page.evaluate(() => !!window.axe))) await page.evaluate(script);
      const { violations } = await page.evaluate(() => window.axe.run());
      checked += 1;
      for (const { id, impact, nodes } of violations)
        faults.push(`${impact} ${id} on ${title} (${seen}): ${nodes[0].html.slice(0, 120)}`);
      return false;
    } });
  }
  return { faults: [...new Set(faults)], checked };
}

const scenarios = { whole, keys, reload, guesses_first: guessesFirst, on_phone: onPhone, accessibility };
try {
  console.log(JSON.stringify(await scenarios[name]()));
} finally {
  await browser.close();
}
