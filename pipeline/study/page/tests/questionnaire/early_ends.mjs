// Participants whose sessions end early, and who load the page again, in each of the ways in which a questionnaire can be
// given: screened out, withdrawn, refused; and what the experimenter sees of them.
//   node early_ends.mjs static|jatos|served FOLDER|LINKS
// prints what they read as JSON. FOLDER holds an exported questionnaire with recruitment, LINKS is {"join", "own"}.
import { readdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { filesOfZip, serve } from "../http_server.mjs";
import { jatosScript } from "./jatos_script.mjs";
import { desktop, opener } from "./opened.mjs";
import { savedAll } from "./pages.mjs";
import { openBrowser, take } from "./participant.mjs";

const [mode, given] = process.argv.slice(2);
const browser = await openBrowser();
const open = opener(browser);

/** JATOS as it shows the study of an archive. */
async function jatosServer(folder) {
  const files = await filesOfZip(join(folder, readdirSync(folder).find((name) => name.endsWith(".jzip"))));
  const { dirName } = JSON.parse(files[Object.keys(files).find((path) => path.endsWith(".jas"))]).data;
  files[`/${dirName}/jatos.js`] = Buffer.from(jatosScript);
  const server = await serve(files);
  return { address: `${server.base}/${dirName}/index.html`, close: () => server.close() };
}

const links = mode === "served" ? JSON.parse(given) : {};
const place = mode === "served" ? { address: links.join, close() {} }
  : mode === "jatos" ? await jatosServer(resolve(given)) : { address: `file://${resolve(given)}/index.html`, close() {} };

const linkOf = (id, session = `${id}-s`) => `${place.address}?PROLIFIC_PID=${id}&STUDY_ID=study&SESSION_ID=${session}`;
const text = (page) => page.locator("main").innerText();
const asksConsent = async (page) => /Taking part is voluntary/.test(await text(page));
const stored = (page) => page.evaluate(() => JSON.stringify(localStorage));

/** What is read at an address, once something is there. */
async function readAt(page, url) {
  if (url) await page.goto(url);
  else await page.reload();
  await page.waitForSelector(".page h1, .trial");
  return text(page);
}

const agree = async (page) => {
  await page.locator(".page .buttons .main").click();
  await page.waitForSelector("#about-years");
};

const answerYears = async (page, years) => {
  await page.locator("#about-years").fill(years);
  await page.locator(".page .buttons .main").click();
  await page.waitForFunction(() => !document.querySelector("#about-years"));
};

/** Is screened out; what is read then, after a reload, and at the same link. */
async function screenedOut({ page }, url) {
  await page.goto(url);
  await agree(page);
  await answerYears(page, "12");
  await page.waitForSelector(".page h1");
  return { first: await text(page), again: await readAt(page), at_link: await readAt(page, url), stored: await stored(page) };
}

/** Withdraws after the screening. */
async function withdrawn({ page }, url) {
  await page.goto(url);
  await agree(page);
  await answerYears(page, "27");
  await page.locator(".withdrawal > .button").click();
  await page.locator("dialog .button").nth(1).click();
  await page.waitForFunction(() => /have been deleted/.test(document.querySelector("main").innerText));
  const told = { first: await text(page), again: await readAt(page), at_link: await readAt(page, url),
    stored: await stored(page) };
  await page.route("https://app.prolific.com/**", (route) => route.fulfill({ contentType: "text/html", body: "<p>Prolific" }));
  await page.locator(".leave").click();
  await page.waitForURL("https://app.prolific.com/**");
  return { ...told, led_to: page.url() };
}

/** A new run of JATOS for the same browser, which has forgotten the run before. */
const newRun = async (page, url) => {
  await page.evaluate(() => sessionStorage.clear());
  return readAt(page, url);
};

/** The file whose name has this part: the page may still be saving others. */
async function saved(page, name, press) {
  const isIt = (download) => download.suggestedFilename().includes(name);
  const [download] = await Promise.all([page.waitForEvent("download", isIt), press()]);
  return readFileSync(await download.path(), "utf8");
}

/** Of a folder: others at the same browser, links without names, and the experimenter's page. */
async function sharedBrowser() {
  const opened = await open("about:blank", desktop);
  const { page } = opened;
  const told = { out: await screenedOut(opened, linkOf("5f01")) };
  told.other_session = await readAt(page, linkOf("5f01", "other"));
  await readAt(page, linkOf("5f02"));
  told.is_other_asked = await asksConsent(page);
  await agree(page);
  await answerYears(page, "30");
  await readAt(page, linkOf("5f01"));
  told.first_still_out = await text(page);
  await page.goto(linkOf("5f02"));
  await take(page);
  told.end = await text(page);
  told.end_buttons = await page.locator(".page .button").allTextContents();
  told.saved_again = await saved(page, "answers_data", () => page.locator(".buttons.column .button").click());
  told.end_again = await readAt(page, linkOf("5f02"));
  // A link that names nobody; the plan may be chosen.
  told.nameless = await screenedOut(opened, place.address);
  await readAt(page, `${place.address}?participant=p003`);
  told.is_plan_asked = await asksConsent(page);
  told.experimenter = await readAt(page, `${place.address}?experimenter`);
  told.list = await saved(page, "ended-early", () => page.getByText("Save this list").click());
  await page.getByText("Start for the next participant").click();
  await page.waitForURL(place.address);
  await page.waitForSelector(".page h1");
  told.is_next_asked = await asksConsent(page);
  told.still_out = await readAt(page, linkOf("5f01"));
  await readAt(page, `${place.address}?experimenter`);
  page.once("dialog", (dialog) => dialog.accept());
  await page.getByText("Forget everything").click();
  await page.waitForURL(place.address);
  await readAt(page, linkOf("5f01"));
  told.is_anew = await asksConsent(page);
  told.troubles = opened.troubles;
  return told;
}

/** Does not agree at a link of their own. */
async function refused() {
  const { page } = await open(links.own);
  await page.locator(".page .button").nth(1).click();
  await page.waitForFunction(() => !/voluntary/.test(document.querySelector("main").innerText));
  return { first: await text(page), again: await readAt(page) };
}

/** Withdraws in one window, and goes on in another. */
async function withdrawnElsewhere() {
  const { page } = await open(linkOf("5f14"));
  await agree(page);
  await page.waitForURL(/\/s\//);
  const other = await page.context().newPage();
  await other.goto(page.url());
  await other.waitForSelector("#about-years");
  await page.locator(".withdrawal > .button").click();
  await page.locator("dialog .button").nth(1).click();
  await page.waitForFunction(() => /have been deleted/.test(document.querySelector("main").innerText));
  await other.locator("#about-years").fill("27");
  await other.locator(".page .buttons .main").click();
  await other.waitForSelector(".leave");
  return { first: await text(page), other: await text(other) };
}

const told = {};
if (mode === "static") told.shared = await sharedBrowser();
if (mode !== "served") {
  const out = await open("about:blank", desktop);
  told.out = await screenedOut(out, linkOf("5f11"));
  if (mode === "jatos") told.out_in_new_run = await newRun(out.page, linkOf("5f11"));
}
const leaving = await open("about:blank", desktop);
told.withdrawn = await withdrawn(leaving, linkOf("5f12"));
if (mode === "jatos") {
  told.withdrawn_in_new_run = await readAt(leaving.page, linkOf("5f12"));
  await newRun(leaving.page, linkOf("5f13"));
  told.is_other_asked = await asksConsent(leaving.page);
  await newRun(leaving.page, place.address);
  told.is_nameless_asked = await asksConsent(leaving.page);
}
if (mode === "served") {
  told.refused = await refused();
  told.elsewhere = await withdrawnElsewhere();
}
place.close();
console.log(JSON.stringify(told));
await savedAll();
await browser.close();
