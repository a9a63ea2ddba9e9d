// Participants of an experiment with chains in a real browser.
//   node scenarios.mjs NAME FOLDER-OR-ADDRESS [PICTURES]
// prints what came of it as JSON: the files that were saved, and whatever the browser complained of.
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { filesOfZip, serve } from "../http_server.mjs";
import { jatosScript } from "../questionnaire/jatos_script.mjs";
import { openBrowser } from "../questionnaire/participant.mjs";
import { desktop, opener, phone, withFiles } from "./opened.mjs";
import { take } from "./participant.mjs";

const [name, given, pictures] = process.argv.slice(2);
const address = given.startsWith("http") ? given : `file://${resolve(given)}/index.html`;

const browser = await openBrowser();
const open = opener(browser);

/** Pictures of every page and trial, where a folder for them is given. */
const withPictures = (page, begin) => {
  let shots = 0;
  return async (seen) => {
    if (pictures)
      await page.screenshot({ path: join(pictures, `${begin}-${String(shots++).padStart(2, "0")}-${seen}.png`) });
    return false;
  };
};

async function whole() {
  const opened = await open(address);
  await take(opened.page, { each: withPictures(opened.page, "desktop") });
  return withFiles(opened);
}

async function keys() {
  const opened = await open(address);
  await opened.page.mouse.move(0, 0);
  await take(opened.page, { how: "keys" });
  return withFiles(opened);
}

/** By touch on a narrow screen. */
async function touch() {
  const opened = await open(address, phone);
  await take(opened.page, { how: "touch", each: withPictures(opened.page, "phone") });
  return withFiles(opened);
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
  return withFiles(opened);
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

/** On a phone's screen, where phones are refused. */
async function refusedPhone() {
  const { page, troubles } = await open(address, phone);
  return { text: await page.locator("main").innerText(), buttons: await page.locator(".button").count(), troubles };
}

/** Faults of accessibility on every page and in every trial, as wide as a laptop and as a phone. */
async function accessibility() {
  const script = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
  const faults = [];
  let checked = 0;
  for (const how of [desktop, { viewport: phone.viewport }]) {
    const { page } = await open(address, { ...how, bypassCSP: true });
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

const scenarios = { whole, keys, touch, reload, jatos, refused_phone: refusedPhone, accessibility };
try {
  console.log(JSON.stringify(await scenarios[name]()));
} finally {
  await browser.close();
}
