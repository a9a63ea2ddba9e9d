// Adaptive two-interval trials in a real browser:  node adaptive.mjs folder|served FOLDER|LINK
// One participant answers to the end, and reloads the page at the third and at the sixth trial, there after the film
// has begun. In a folder, two of three answers in each track are right. Prints the numbers of the trials that were seen,
// and the saved files of a folder, as JSON.
import { resolve } from "node:path";
import { opener, withFiles } from "./opened.mjs";
import { savedAll } from "./pages.mjs";
import { openBrowser, take } from "./participant.mjs";

const [mode, given] = process.argv.slice(2);
const browser = await openBrowser();
const address = mode === "served" ? given : `file://${resolve(given)}/index.html?participant=p001`;

/** Answers the trial that is open: rightly, or not. */
async function answer(page, number, trial, isRight) {
  await page.locator(".play").click();
  await page.waitForFunction(() => !document.querySelector(".answers").inert, null, { timeout: 30000 });
  const isFirst = (trial.positive === "first") === isRight;
  await page.locator("fieldset.asked input").nth(isFirst ? 0 : 1).click({ force: true });
  await page.locator(".answers .main").click();
  await page.waitForFunction((before) => !document.querySelector(".trial-head h1")?.textContent.includes(` ${before} `),
    number, { timeout: 30000 });
}

try {
  const opened = await opener(browser)(address);
  const { page } = opened;
  const seen = [];
  const reloaded = new Set();
  const counts = {};
  await take(page, { each: async (sight, number) => {
    if (sight !== "trial") return false;
    if ((number === 3 || number === 6) && !reloaded.has(number)) {
      reloaded.add(number);
      if (number === 6) {
        await page.locator(".play").click();
        await page.waitForFunction(() => document.querySelector("video").currentTime > 0.1);
      }
      await page.reload();
      return true;
    }
    seen.push(number);
    if (mode === "served") return false;
    const trial = await page.evaluate((at) =>
      globalThis.mienExperiment.sessions[0].trials.find((one) => one.number === at), number);
    counts[trial.track] = (counts[trial.track] ?? 0) + 1;
    await answer(page, number, trial, counts[trial.track] % 3 !== 0);
    return true;
  } });
  const told = { seen, reloads: reloaded.size };
  console.log(JSON.stringify(mode === "folder" ? await withFiles(opened, told)
    : { ...told, troubles: opened.troubles }));
} finally {
  await savedAll();
  await browser.close();
}
