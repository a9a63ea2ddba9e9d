// Pages that are reloaded, and films that cannot be played, in a real browser.
//   node attempts.mjs FOLDER
// prints what came of them as JSON; FOLDER holds an exported questionnaire.
import { createHash } from "node:crypto";
import { resolve } from "node:path";
import { filesOf, serve } from "../http_server.mjs";
import { desktop, opener, withFiles } from "./opened.mjs";
import { savedAll } from "./pages.mjs";
import { openBrowser, take } from "./participant.mjs";

const files = await filesOf(resolve(process.argv[2]));
const browser = await openBrowser();
const open = opener(browser);

/** A server of the questionnaire with a change. */
const serverOf = (change, intercept) => {
  const experiment = JSON.parse(files["/experiment.json"]);
  change(experiment);
  return serve({ ...files,
    "/experiment.js": Buffer.from(`globalThis.mienExperiment = ${JSON.stringify(experiment)};`) }, intercept);
};

const answersOpen = (page) => page.waitForFunction(() => !document.querySelector(".answers").inert);
const answer = async (page) => {
  for (const asked of await page.locator("fieldset.asked").all()) await asked.locator("input").first().click({ force: true });
  await page.locator(".answers .main").click();
  await page.waitForFunction(() => !document.querySelector(".badge"));  // practice is over
};

/** The first trial, reloaded while its film plays and again when it has ended. */
async function reloaded(replays) {
  const server = await serverOf((experiment) => { experiment.settings.replays = replays; });
  const opened = await open(`${server.base}/index.html?participant=p001`);
  const { page } = opened;
  const told = {};
  await take(page, { each: async (sight, number) => {
    if (sight !== "trial" || number !== 1 || told.is_left) return false;
    const attempt = told.attempt = (told.attempt ?? 0) + 1;
    await page.waitForFunction(() => !document.querySelector(".play").hidden || !document.querySelector(".answers").inert);
    if (attempt === 1) {
      await page.locator(".play").click();
      await page.waitForTimeout(500);
      await page.reload();
    } else if (attempt === 2) {
      told.is_locked = await page.evaluate(() => document.querySelector(".answers").inert);
      await page.locator(".play").click();
      await answersOpen(page);
      await page.reload();
    } else {
      await answersOpen(page);
      await page.waitForTimeout(1000);  // the film is ready
      told.offered = await page.locator(".play").isVisible();
      told.focus = await page.evaluate(() => document.activeElement.matches("fieldset.asked"));
      told.is_left = true;
      await answer(page);
    }
    return true;
  } });
  server.close();
  return withFiles(opened, told);
}

/** A film that is not there, one that is none, and one that does not begin: by keys, each is left out. */
async function unplayable() {
  const shown = { missing: "", broken: "" };
  const server = await serverOf((experiment) => {
    const [first, second] = [...new Set(experiment.sessions[0].trials.filter(({ practice }) => !practice)
      .flatMap(({ media }) => media))];
    const reference = experiment.sessions[0].trials.find(({ reference: one }) => one)?.reference;
    Object.assign(shown, { missing: experiment.media[first].file, broken: experiment.media[second].file });
    if (reference) for (const trial of experiment.sessions[0].trials) trial.reference = "";
    experiment.media[second].sha256 = createHash("sha256").update("no video").digest("hex");
  }, async (path, answer) => {
    if (path === `/${shown.missing}`) answer.writeHead(404).end();
    else if (path === `/${shown.broken}`) answer.writeHead(200, { "Content-Type": "video/mp4" }).end("no video");
    else return false;
    return true;
  });
  const opened = await open("about:blank", { ...desktop, bypassCSP: true });
  const { page } = opened;
  await page.addInitScript(() => {
    const play = HTMLMediaElement.prototype.play;
    // The film of the first trial, which is for practice, begins and never ends at first; then it never begins.
    let times = 0;
    HTMLMediaElement.prototype.play = function () {
      if (!document.querySelector(".badge")) return play.call(this);
      times += 1;
      if (times <= document.querySelectorAll("video").length) this.dispatchEvent(new Event("playing"));
      return new Promise(() => {});
    };
  });
  await page.goto(`${server.base}/index.html?participant=p001`);
  const faults = [];
  let again = 0;
  const retried = {};
  const pressButton = async (index) => {
    await page.locator(".play-fault .button").nth(index).focus();
    await page.keyboard.press("Enter");
  };
  await take(page, { each: async (sight, number) => {
    if (sight === "load") {
      await page.waitForFunction(() => !document.querySelector(".page progress") || document.querySelector(".page .main"));
      if (!(await page.locator(".page progress").count())) return true;
      const buttons = page.locator(".page > .button");
      if (await buttons.count() === 2) {
        await buttons.nth(1).click();
      } else {
        again += 1;
        await buttons.click();
        await page.waitForFunction(() => document.querySelectorAll(".page > .button").length === 2);
      }
      return true;
    }
    if (sight !== "trial" || !(await page.locator(".stage").count())) return false;
    if (await page.locator(".badge").count()) {
      await page.locator(".play").click();
      await page.waitForFunction(() => document.querySelector(".play").isConnected &&
        /beginning/.test(document.querySelector(".play").textContent), null, { timeout: 15000 });
      const first = await page.locator(".play-fault .button").count();
      await page.locator(".play").click();
      await page.waitForSelector(".play-fault .button", { timeout: 15000 });
      faults.push({ number, first, said: await page.locator(".play-fault").innerText() });
      await pressButton(1);
      await page.waitForFunction((old) => !document.querySelector(".trial-head h1")?.textContent.startsWith(`${old} `), number);
      return true;
    }
    await page.waitForFunction(() => document.querySelector(".play-fault .button") ||
      (document.querySelector(".play") && !document.querySelector(".play").hidden));
    if (!(await page.locator(".play-fault .button").count())) return false;
    faults.push({ number, said: await page.locator(".stage-note").innerText() });
    if (!retried[number]) {
      retried[number] = true;
      await pressButton(0);  // loads the page anew
      await page.waitForFunction(() => !document.querySelector(".play-fault .button"));
      return true;
    }
    if (process.env.MIEN_PICTURES) await page.screenshot({ path: `${process.env.MIEN_PICTURES}/unplayable-${number}.png` });
    await pressButton(1);
    await page.waitForFunction((old) => !document.querySelector(".trial-head h1")?.textContent.startsWith(`${old} `), number);
    return true;
  } });
  server.close();
  return withFiles(opened, { faults, again });
}

try {
  console.log(JSON.stringify({ none: await reloaded("none"), once: await reloaded(1), counted: await reloaded("counted"),
    unplayable: await unplayable() }));
} finally {
  await savedAll();
  await browser.close();
}
