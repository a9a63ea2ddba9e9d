// Grids in which a film or the reference is missing, or is no film, in a real browser.
//   node grid_faults.mjs FOLDER
// prints what came of them as JSON; FOLDER holds an exported questionnaire whose trials are grids with a reference.
import { createHash } from "node:crypto";
import { join, resolve } from "node:path";
import { filesOf, serve } from "../http_server.mjs";
import { desktop, opener, withFiles } from "./opened.mjs";
import { savedAll } from "./pages.mjs";
import { openBrowser, take } from "./participant.mjs";

const files = await filesOf(resolve(process.argv[2]));
const browser = await openBrowser();
const open = opener(browser);

/** Where `missing` are not found and `broken` are no films: of the token of a film and that of the reference, which is a
 *  film of the grid, too. */
async function withFaults(name, faultsOf) {
  const experiment = JSON.parse(files["/experiment.json"]);
  const { media, reference } = experiment.sessions[0].trials[0];
  const { missing = [], broken = [] } = faultsOf(media.find((token) => token !== reference), reference);
  const isFaulty = [...media, reference].map((token) => [...missing, ...broken].includes(token));
  for (const token of broken) experiment.media[token].sha256 = createHash("sha256").update("no video").digest("hex");
  const isOf = (tokens, path) => tokens.some((token) => path === `/${experiment.media[token].file}`);
  const server = await serve({ ...files,
    "/experiment.js": Buffer.from(`globalThis.mienExperiment = ${JSON.stringify(experiment)};`) },
  async (path, answer) => {
    if (isOf(missing, path)) answer.writeHead(404).end();
    else if (isOf(broken, path)) answer.writeHead(200, { "Content-Type": "video/mp4" }).end("no video");
    else return false;
    return true;
  });
  const opened = await open(`${server.base}/index.html?participant=p001`);
  const { page } = opened;
  const told = { is_faulty: isFaulty };
  await take(page, { each: async (sight) => {
    if (sight === "load") {
      const buttons = page.locator(".page > .button");
      await page.waitForFunction(() => !document.querySelector(".page progress") || document.querySelector(".page .button"));
      if (await buttons.count()) await buttons.last().click();  // again, and then without
      await page.waitForTimeout(200);
      return true;
    }
    if (sight !== "trial" || told.said) return false;
    await page.waitForSelector(".play-fault .button");
    await page.waitForFunction(() => [...document.querySelectorAll("video")].every((video) =>
      video.readyState > 1 || video.error));
    told.said = await page.locator(".failed-films").innerText();
    told.disabled = await page.locator(".play-film").evaluateAll((all) => all.map((one) => one.disabled));
    // The others are shown, and not covered while they play.
    const good = told.disabled.indexOf(false);
    await page.locator(".play-film").nth(good).click();
    await page.waitForSelector(".grid-stage.playing");
    told.is_covered = await page.locator(".play-fault").isVisible();
    await page.waitForFunction((at) => document.querySelectorAll(".seen-mark")[at].textContent, good);
    told.is_offered_again = await page.locator(".play-fault").isVisible();
    await page.locator(".answers .main").click();  // it cannot be completed
    told.note = await page.locator(".answers .note").innerText();
    if (process.env.MIEN_PICTURES) await page.screenshot({ path: join(process.env.MIEN_PICTURES, `grid-${name}.png`) });
    await page.locator(".play-fault .button").nth(1).click();
    await page.waitForFunction(() => !document.querySelector(".grid-stage"));
    return true;
  } });
  server.close();
  return withFiles(opened, told);
}

try {
  console.log(JSON.stringify({
    missing: await withFaults("missing", (film) => ({ missing: [film] })),
    broken: await withFaults("broken", (film) => ({ broken: [film] })),
    both: await withFaults("both", (film, reference) => ({ broken: [film], missing: [reference] })),
  }));
} finally {
  await savedAll();
  await browser.close();
}
