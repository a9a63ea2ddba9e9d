// A page that is opened in a browser, with what it saves and what the browser complains of.
import { downloadsOf } from "./participant.mjs";

export const desktop = { viewport: { width: 1366, height: 768 } };
export const phone = { viewport: { width: 390, height: 844 }, screen: { width: 390, height: 844 },
  hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

/** Opens pages, each for somebody else. */
export const opener = (browser) => async (url, how = desktop) => {
  const context = await browser.newContext({ acceptDownloads: true, ...how });
  const page = await context.newPage();
  const troubles = [];
  page.on("console", (message) => { if (message.type() === "error") troubles.push(message.text()); });
  page.on("pageerror", (error) => troubles.push(error.message));
  const saved = downloadsOf(page);
  await page.goto(url);
  return { page, troubles, saved };
};

/** Until all three files are there. */
export async function withFiles({ saved, troubles }, more = {}) {
  for (let i = 0; i < 100 && Object.keys(saved).length < 3; i += 1)
    await new Promise((done) => setTimeout(done, 100));
  return { ...saved, troubles, ...more };
}
