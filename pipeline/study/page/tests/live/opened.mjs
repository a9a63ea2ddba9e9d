// Pages of experiments with live motions that are open in a browser, with what they save and what the browser complains
// of.
import { calmReload } from "../questionnaire/pages.mjs";

export const desktop = { viewport: { width: 1280, height: 800 } };
export const phone = { viewport: { width: 390, height: 844 }, screen: { width: 390, height: 844 },
  hasTouch: true, isMobile: true };

/** A server may answer that it has no step, which browsers call an error. */
const isAnswer = (message) => /\/step\/trial-\d+$/.test(message.location().url);

/** Opens pages, each for somebody else; `downloadsOf` collects what they save. */
export const opener = (browser, downloadsOf) => async (address, how = desktop) => {
  const context = await browser.newContext({ acceptDownloads: true, ...how });
  const page = await context.newPage();
  const troubles = [];
  const asked = [];
  const posted = {};
  page.on("console", (message) => { if (message.type() === "error" && !isAnswer(message)) troubles.push(message.text()); });
  page.on("pageerror", (error) => troubles.push(error.message));
  page.on("request", (request) => {
    if (/^http/.test(request.url())) asked.push(request.url());
    if (/\/records\//.test(request.url())) posted[request.url().split("/").pop()] = request.postDataJSON();
  });
  const saved = downloadsOf(page);
  const reload = calmReload(page);
  await page.goto(address);
  return { page, troubles, saved, asked, posted, reload };
};

/** Until so many files are there; a server has what it was given. */
export async function withFiles({ page, saved, troubles, asked, posted }, count, more = {}) {
  const isServed = page.url().startsWith("http");
  for (let i = 0; !isServed && i < 100 && Object.keys(saved).length < count; i += 1) await page.waitForTimeout(100);
  return { ...saved, troubles, requests: asked.length, posted, ...more };
}
