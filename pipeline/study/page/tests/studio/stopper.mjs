// Somebody who stops films: node stopper.mjs LINK. Begins a long one and stops it, begins another,
// closes the page in the midst of it, finds it in a new page and stops it there, and has a still made
// after all that. Follows the way to the walker. Prints what was seen as JSON.
import { openStudio } from "./open_studio.mjs";

const [link] = process.argv.slice(2);
const { browser, page, wrong, tab, settled, pictures } = await openStudio(link);
const seen = {};

/** Begins the film that the manifest asks for: long enough to be stopped. */
const begin = async () => {
  await tab("Render");
  await page.getByLabel("Quality").selectOption("final");
  await page.getByRole("button", { name: "Video", exact: true }).click();
  await page.getByRole("button", { name: "Stop", exact: true }).waitFor();
  await page.waitForFunction(() => /: \d+ %$/.test(document.querySelector(".told").textContent));
};

await begin();
seen.going = await page.locator(".told").textContent();
await pictures("rendering");
await page.getByRole("button", { name: "Stop", exact: true }).click();
await page.waitForFunction(() => document.querySelector(".told").textContent === "Stopped.", null, { timeout: 60000 });
seen.bar_is_gone = await page.locator("progress").isHidden();
seen.result = await page.locator(".result > *").count();

await begin();
await page.close();
const again = await browser.contexts()[0].newPage();
again.on("pageerror", (error) => wrong.push(String(error)));
await again.goto(link);
await again.getByRole("tab", { name: "Render", exact: true }).click();
const stop = again.getByRole("button", { name: "Stop", exact: true });
await stop.waitFor({ timeout: 60000 });
seen.found = await again.locator(".told").textContent();
await stop.click();
await again.waitForFunction(() => document.querySelector(".told").textContent === "Stopped.", null, { timeout: 60000 });

await again.getByLabel("Quality").selectOption("draft");
await again.getByRole("button", { name: "Still of this frame" }).click();
await again.locator(".result img").waitFor({ timeout: 120000 });
seen.still = true;

// The way to the walker, or why there is none yet.
const walker = again.locator(".walker");
seen.walker = await walker.textContent();
if (seen.walker === "Walker") {
  const [opened] = await Promise.all([browser.contexts()[0].waitForEvent("page"), walker.click()]);
  await opened.waitForFunction(() => globalThis.mien_walk, null, { timeout: 60000 });
  seen.back = await opened.locator(".to-studio").getAttribute("href");
} else {
  await walker.click();
  seen.why = await again.locator(".refusal p").textContent();
}
seen.wrong = wrong;
console.log(JSON.stringify(seen));
await browser.close();
