// Somebody opens the walker's page and walks:  node opened.mjs LINK [PICTURE]
// prints how far the pelvis came within two seconds, metres, and what the browser complained of.
import { openBrowser } from "../questionnaire/participant.mjs";

const [link, picture] = process.argv.slice(2);
const browser = await openBrowser();
const page = await browser.newPage({ viewport: { width: 1366, height: 768 } });
const troubles = [];
page.on("console", (message) => { if (message.type() === "error") troubles.push(message.text()); });
page.on("pageerror", (error) => troubles.push(error.message));
await page.goto(link);
await page.waitForFunction(() => globalThis.mien_walk, null, { timeout: 60000 });
await page.evaluate(() => {
  globalThis.mien_walk.watch((frame) => { globalThis.pelvis = [frame.positions[0], frame.positions[2]]; });
});
const pelvis = async () => {
  await page.waitForFunction(() => globalThis.pelvis);
  return page.evaluate(() => globalThis.pelvis);
};
const from = await pelvis();
await page.locator("canvas").first().focus();
await page.keyboard.down("ArrowUp");
await page.waitForTimeout(2000);
const to = await pelvis();
if (picture) await page.screenshot({ path: picture });
await page.keyboard.up("ArrowUp");
console.log(JSON.stringify({ way: Math.hypot(to[0] - from[0], to[1] - from[1]), troubles }));
await browser.close();
