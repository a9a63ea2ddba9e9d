// Screenshots of the page with a fake motion core, and what it saves: node try_page.mjs FOLDER
import { join, resolve } from "node:path";
import { openBrowser } from "../questionnaire/participant.mjs";
import { fakePage } from "./fake_page.mjs";
import { downloadsOf, take } from "./participant.mjs";

const folder = resolve(process.argv[2]);
await fakePage(folder);
const browser = await openBrowser();
for (const [size, viewport] of Object.entries({ desktop: { width: 1366, height: 768 }, phone: { width: 390, height: 844 } })) {
  const context = await browser.newContext({ viewport, acceptDownloads: true, ...(size === "phone" ? { hasTouch: true, isMobile: true } : {}) });
  const page = await context.newPage();
  page.on("console", (message) => { if (message.type() === "error") console.log(message.text()); });
  page.on("pageerror", (error) => console.log(String(error)));
  const saved = downloadsOf(page);
  await page.goto(`file://${folder}/index.html`);
  let shots = 0;
  await take(page, { each: async (seen) => {
    if (seen !== "matching") await page.screenshot({ path: join(folder, `${size}-${String(shots++).padStart(2, "0")}-${seen}.png`) });
    return false;
  } });
  for (let i = 0; i < 50 && Object.keys(saved).length < 4; i += 1) await page.waitForTimeout(100);
  console.log(size, Object.keys(saved), saved.trials);
  console.log(saved.changes?.split("\n").length, JSON.parse(saved.records ?? "{}").records?.["trial-2"]?.matching?.success);
}
await browser.close();
