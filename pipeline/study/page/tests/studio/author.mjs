// Somebody who works in the studio: node author.mjs LINK FILE. Opens it, changes a stimulus, undoes
// and redoes, compares, saves FILE, and has a still and a video made. Prints what was seen as JSON.
// MIEN_PICTURES: a folder for screenshots.
import { readFileSync, writeFileSync } from "node:fs";
import { openStudio } from "./open_studio.mjs";

const [link, file] = process.argv.slice(2);
const { browser, page, wrong, tab, number, settled, set, pictures } = await openStudio(link);

const text = () => readFileSync(file, "utf8");

const seen = {};
seen.stimuli = await page.locator(".stimulus span:first-child").allTextContents();
seen.sliders = await page.locator(".slider:visible").count();

// A slider, undone and redone by keys.
await set("quickness", 0.9);
await page.locator("h1").click();
await page.keyboard.press("Control+z");
await settled();
seen.undone = await number("quickness").inputValue();
await page.keyboard.press("Control+Shift+z");
await settled();
seen.redone = await number("quickness").inputValue();

// Against another, live.
await page.locator("select[name=against]").selectOption("guess-1");
await settled();
await page.waitForFunction(() => /^D 0\.\d{4} m$/.test(document.querySelector(".distance").textContent));
await pictures("motion");

// Another kind of sliders, and back.
await page.getByRole("button", { name: "weights", exact: true }).click();
await settled();
seen.weights = await page.locator(".slider:visible").count();
await page.keyboard.press("Control+z");
await settled();

// Modified: a recipe and a posture.
await tab("Modify");
await page.getByRole("button", { name: "Add a step" }).click();
await page.getByLabel("Recipe").selectOption("sad");
await settled();
await page.getByLabel("add a posture…").selectOption("head-flexion");
await settled();
await set("strength", 0.8);
seen.modified = await page.evaluate(() => globalThis.studio.studio.made.modified);
await pictures("modify");

// Wrong values are told.
await page.evaluate(() => {
  const { studio } = globalThis.studio;
  studio.changeStimulus({ ...studio.stimulus(), adjectives: { quicknes: 0.5 } });
});
await page.locator(".findings .wrong").filter({ hasText: "quickness" }).waitFor();
await page.locator("h1").click();
await page.keyboard.press("Control+z");
await settled();

await tab("Look");
await page.locator("select[name=figure]").selectOption("mannequin");
await page.locator("select[name=camera]").selectOption("side");
await settled();
await pictures("look");
await tab("YAML");
await page.waitForFunction(() => document.querySelector("pre.whole").textContent.includes("quickness: 0.9"));
seen.lines = await page.locator("pre.lines").textContent();
await pictures("yaml");

// Saved, and not over what somebody else has written.
await page.keyboard.press("Control+s");
await page.waitForFunction(() => document.querySelector(".state").textContent === "saved");
seen.saved = text();
writeFileSync(file, `${seen.saved}# by another hand\n`);
await tab("Motion");
await set("quickness", 0.8);
await page.keyboard.press("Control+s");
await page.getByText("has been changed since it was opened").waitFor();
seen.kept = text().includes("quickness: 0.9");
await pictures("refusal");
await page.getByRole("button", { name: "Overwrite it" }).click();
await page.waitForFunction(() => document.querySelector(".state").textContent === "saved");
seen.over = text();
seen.D = await page.evaluate(() => globalThis.studio.studio.made.distance.D);

// A still and a video of the same.
await tab("Render");
await page.getByLabel("Quality").selectOption("draft");
await page.getByRole("button", { name: "Still of this frame" }).click();
await page.locator(".result img").waitFor({ timeout: 120000 });
seen.still = await page.evaluate(async () => {
  const picture = document.querySelector(".result img");
  await picture.decode();
  return picture.naturalWidth;
});
await pictures("render");
await page.getByRole("button", { name: "Video", exact: true }).click();
await page.locator(".result video").waitFor({ timeout: 400000 });
await page.waitForFunction(() => document.querySelector(".result video").readyState > 0);
seen.video = await page.evaluate(() => document.querySelector(".result video").duration);
seen.told = await page.locator(".told").textContent();

seen.wrong = wrong.filter((told) => !/422|409/.test(told));
console.log(JSON.stringify(seen));
await browser.close();
