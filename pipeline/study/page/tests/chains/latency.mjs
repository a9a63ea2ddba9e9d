// How long the slider of a step of Gibbs sampling takes until the motion that comes of it is drawn, in headless Chromium.
//   node latency.mjs FOLDER-OR-ADDRESS [CHANGES]
// moves the slider of each of the first three trials CHANGES (25) times, and prints a line a trial: milliseconds from
// the slider's event to the end of the frame that shows the motion.
import { resolve } from "node:path";
import { desktop, opener } from "../live/opened.mjs";
import { sliderLatencies, summaryOf } from "../live/slider_latency.mjs";
import { openBrowser } from "../questionnaire/participant.mjs";
import { downloadsOf, take } from "./participant.mjs";

const [given, changes = "25"] = process.argv.slice(2);
const address = given.startsWith("http") ? given : `file://${resolve(given)}/index.html`;

class Enough extends Error {}

const browser = await openBrowser();
const { page } = await opener(browser, downloadsOf)(address, desktop);
let trials = 0;
try {
  await take(page, { each: async (seen) => {
    if (seen !== "chains") return false;
    const { took } = await sliderLatencies(page, { sliders: ".slider-control input", over: ".chains [inert]",
      most: Number(changes), seen: { shown: [".figure-view", "data-shown"] } });
    console.log(`trial ${trials += 1}: ${took.length} changes; motion: ${summaryOf(took, "shown")}`);
    if (trials === 3) throw new Enough();
    return false;
  } });
} catch (error) {
  if (!(error instanceof Enough)) throw error;
} finally {
  await browser.close();
}
