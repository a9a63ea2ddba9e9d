// Participants of an experiment with chains in a real browser.
//   node scenarios.mjs NAME FOLDER-OR-ADDRESS [PICTURES]
// prints what came of it as JSON: the files that were saved, and whatever the browser complained of.
import { readdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { filesOfZip, serve } from "../http_server.mjs";
import { desktop, opener, phone, withFiles } from "../live/opened.mjs";
import { accessibilityOf, picturesIn } from "../live/seen.mjs";
import { jatosScript } from "../questionnaire/jatos_script.mjs";
import { openBrowser } from "../questionnaire/participant.mjs";
import { chosenOn, downloadsOf, take } from "./participant.mjs";

const [name, given, pictures] = process.argv.slice(2);
const address = given.startsWith("http") ? given : `file://${resolve(given)}/index.html`;

const browser = await openBrowser();
const open = opener(browser, downloadsOf);
const allOf = (opened) => withFiles(opened, 3, { chosen: chosenOn(opened.page) });

async function whole() {
  const opened = await open(address);
  await take(opened.page, { each: picturesIn(pictures, opened.page, "desktop") });
  return allOf(opened);
}

async function keys() {
  const opened = await open(address);
  await opened.page.mouse.move(0, 0);
  await take(opened.page, { how: "keys" });
  return allOf(opened);
}

/** By touch on a narrow screen. */
async function touch() {
  const opened = await open(address, phone);
  await take(opened.page, { how: "touch", each: picturesIn(pictures, opened.page, "phone") });
  return allOf(opened);
}

/** Reloads the fourth trial after its slider was moved or, where there is none, as it is shown. */
async function reloadFourth(page, reload, seen, state) {
  state.trials += seen === "chains" ? 1 : 0;
  if (seen !== "chains" || state.trials !== 4) return false;
  const slider = page.locator(".slider-control input");
  if (await slider.count()) await slider.press("ArrowRight");
  await reload();
  return true;
}

async function reload() {
  const opened = await open(address);
  const state = { trials: 0 };
  await take(opened.page, { each: (seen) => reloadFourth(opened.page, opened.reload, seen, state) });
  return allOf(opened);
}

/** As JATOS shows the study that it unpacked, with a reload on the way. */
async function jatos() {
  const folder = resolve(given);
  const files = await filesOfZip(join(folder, readdirSync(folder).find((file) => file.endsWith(".jzip"))));
  const { dirName } = JSON.parse(files[Object.keys(files).find((path) => path.endsWith(".jas"))]).data;
  files[`/${dirName}/jatos.js`] = Buffer.from(jatosScript);
  const server = await serve(files);
  const opened = await open(`${server.base}/${dirName}/index.html`);
  const state = { trials: 0 };
  await take(opened.page, { each: (seen) => reloadFourth(opened.page, opened.reload, seen, state) });
  const kept = await opened.page.evaluate(() => JSON.parse(sessionStorage.jatos));
  server.close();
  return { troubles: opened.troubles, result: kept.result, files: kept.files, taken: kept.batch.mien_taken };
}

/** Somebody who fails attention checks, and then opens the page again; what the last page says both times. */
async function careless() {
  const opened = await open(address);
  await take(opened.page, { careless: true });
  const said = () => opened.page.locator("main").innerText();
  const first = await said();
  await opened.reload();
  await opened.page.waitForSelector("h1");
  return { posted: opened.posted, troubles: opened.troubles, said: first, again: await said() };
}

/** Several people at once, at links separated by commas; a file PICTURES is written once all are at their trials. The
    server may be killed meanwhile. What each of them sent last of every trial. */
async function together() {
  const everybody = await Promise.all(given.split(",").map((link) => open(link)));
  const arrived = new Set();
  const arrive = (one) => async (seen) => {
    if (seen === "chains" && arrived.add(one).size === everybody.length) writeFileSync(pictures, "");
    return false;
  };
  await Promise.all(everybody.map((one) => take(one.page, { each: arrive(one) })));
  const isOfKill = (trouble) => /net::ERR_|Failed to fetch|Failed to load resource/.test(trouble);
  return { posted: everybody.map(({ posted }) => posted),
    troubles: everybody.flatMap(({ troubles }) => troubles).filter((one) => !isOfKill(one)) };
}

/** On a phone's screen, where phones are refused. */
async function refusedPhone() {
  const { page, troubles } = await open(address, phone);
  return { text: await page.locator("main").innerText(), buttons: await page.locator(".button").count(), troubles };
}

/** As wide as a laptop and as a phone. */
const accessibility = () =>
  accessibilityOf([desktop, { viewport: phone.viewport }], (how) => open(address, how), take);

const scenarios = { whole, keys, touch, reload, jatos, refused_phone: refusedPhone, accessibility, careless, together };
try {
  console.log(JSON.stringify(await scenarios[name]()));
} finally {
  await browser.close();
}
