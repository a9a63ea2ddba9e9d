// Participants whom Prolific sends, in each of the ways in which a questionnaire can be given: link, consent, screening,
// trials with sound, and the way back with a code. One reloads the page, one withdraws, and one is screened out.
//   node round_trip.mjs static|jatos|served FOLDER|LINK
// prints what came of them as JSON. Prolific itself is replaced.
import { join, resolve } from "node:path";
import { filesOfZip, serve } from "../http_server.mjs";
import { jatosScript } from "./jatos_script.mjs";
import { opener, desktop, withFiles } from "./opened.mjs";
import { savedAll } from "./pages.mjs";
import { openBrowser, take } from "./participant.mjs";
import { countTonesOf, hearTones } from "./tones.mjs";

const [mode, given] = process.argv.slice(2);
const browser = await openBrowser();
const open = opener(browser);

/** JATOS as it shows the study of an archive. */
async function jatosServer(folder) {
  const archive = (await import("node:fs")).readdirSync(folder).find((name) => name.endsWith(".jzip"));
  const files = await filesOfZip(join(folder, archive));
  const { dirName } = JSON.parse(files[Object.keys(files).find((path) => path.endsWith(".jas"))]).data;
  files[`/${dirName}/jatos.js`] = Buffer.from(jatosScript);
  const server = await serve(files);
  return { address: `${server.base}/${dirName}/index.html`, close: () => server.close() };
}

const place = mode === "served" ? { address: given, close() {} }
  : mode === "jatos" ? await jatosServer(resolve(given)) : { address: `file://${resolve(given)}/index.html`, close() {} };
const onProlific = "https://app.prolific.com/**";

/** Whoever opens the link, agrees, and counts the tones. */
async function come(id) {
  const opened = await open("about:blank", desktop);
  const { page } = opened;
  await page.context().route(onProlific, (route) => route.fulfill({ contentType: "text/html", body: "<p>Prolific" }));
  await countTonesOf(page);
  await page.goto(`${place.address}?PROLIFIC_PID=${id}&STUDY_ID=study&SESSION_ID=${id}-s`);
  await page.locator(".page .buttons .main").click();
  const { count } = await hearTones(page);
  await page.keyboard.type(String(count));
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => !document.querySelector("#tones"));
  return { ...opened, tones: count };
}

const stateOf = (page) => page.evaluate(() => ({ session: sessionStorage.jatos && JSON.parse(sessionStorage.jatos),
  local: JSON.stringify(localStorage) }));

/** The way back: what the last page says, and where it leads. What the page had stored by then. */
async function back({ page }) {
  await page.waitForSelector(".leave");
  const said = await page.locator("main").innerText();
  const state = await stateOf(page);
  await page.locator(".leave").click();
  await page.waitForURL(onProlific);
  return { said, url: page.url(), ...state };
}

const one = await come("5f01");
let reloads = 0;
const heard = [];
await take(one.page, { each: async (sight, number) => {
  if (sight !== "trial") return false;
  heard.push(...await one.page.locator("video").evaluateAll((all) => all.map((video) => !video.muted)));
  if (number !== 2 || reloads > 0) return false;
  await one.page.locator(".play").click();
  await one.page.waitForFunction(() => document.querySelector("video").currentTime > 0.3);
  reloads += 1;
  await one.page.reload();
  return true;
} });
const files = mode === "static" ? await withFiles(one) : {};
const completed = { ...files, ...(await back(one)), heard, reloads, tones: one.tones };

const leaving = await come("5f02");
await take(leaving.page, { each: async (sight, number) => {
  if (sight !== "trial" || number !== 2) return false;
  await leaving.page.locator(".withdrawal > .button").click();
  await leaving.page.locator("dialog .button").nth(1).click();
  await leaving.page.waitForSelector(".leave");
  return true;
} });
const withdrawn = await back(leaving);

const young = await come("5f03");
await take(young.page, { age: "12" });
const screenedOut = await back(young);

place.close();
console.log(JSON.stringify({ completed, withdrawn, screened_out: screenedOut,
  troubles: [one, leaving, young].flatMap(({ troubles }) => troubles) }));
await savedAll();
await browser.close();
