// Somebody who chooses what the studio finds about a manifest: node chooser.mjs LINK FILE. Puts on a
// mannequin and a character, takes a folder of captures as examples, sets options of a modification and
// saves FILE. Prints what was seen as JSON. MIEN_PICTURES: a folder for screenshots.
import { readFileSync } from "node:fs";
import { openStudio } from "./open_studio.mjs";

const [link, file] = process.argv.slice(2);
const { browser, page, wrong, tab, settled, set, pictures } = await openStudio(link);
const optionsOf = (name) => page.locator(`select[name=${name}] option`).evaluateAll((all) => all.map((one) => one.value));
const seen = {};

/** What the first figure of the stage wears: how many joints its surfaces follow; 0 without any. */
const worn = () => page.evaluate(() => {
  const [figure] = globalThis.studio.stage.view.figures;
  return figure.isDressed() ? figure.skin.joints.length : 0;
});
// Figures: here alone, then in the look.
await page.waitForFunction(() => globalThis.studio.studio.places.folders.length > 0);
seen.figures = await optionsOf("shown-on");
seen.stick = await worn();
await page.locator("select[name=shown-on]").selectOption("mannequin");
await settled();
await page.waitForFunction(() => globalThis.studio.stage.view.figures[0].isDressed(), null, { timeout: 60000 });
seen.mannequin = await worn();
seen.body_joints = await page.evaluate(() => globalThis.studio.studio.made.body.names.length);
await pictures("mannequin");
if (seen.figures.includes("character robot.gltf")) {
  await page.locator("select[name=shown-on]").selectOption("");
  await tab("Look");
  await page.locator("select[name=figure]").selectOption("character robot.gltf");
  await settled();
  await page.waitForFunction(() => globalThis.studio.stage.view.figures[0].isDressed(), null, { timeout: 60000 });
  seen.character = await worn();
  seen.characters_joints = await page.evaluate(() => globalThis.studio.studio.made.figure.joints);
  // The joints are where the server says.
  seen.off = await page.evaluate(async () => {
    const { studio, stage } = globalThis.studio;
    stage.seek(0);
    await stage.drawn();
    const [figure] = stage.view.figures;
    const { positions } = studio.made.poses;
    return Math.max(...figure.skin.joints.map((joint, j) => Math.abs(joint.position.y - positions[3 * j + 1])));
  });
  await pictures("character");
  await page.locator("select[name=against]").selectOption("guess-1");
  await settled();
  await pictures("character-heat");
  await page.locator("select[name=against]").selectOption("");
}

// A folder of captures, some of its files, and what is made of them.
await tab("Motion");
seen.examples = await optionsOf("examples");
await page.locator("select[name=examples]").selectOption("captures");
await settled();
seen.count = await page.evaluate(() => globalThis.studio.studio.choices.examples.length);
await pictures("captures");
await page.locator("input[name=exclude]").fill("tired*");
await page.locator("input[name=exclude]").press("Enter");
await settled();
seen.chosen = await page.evaluate(() => globalThis.studio.studio.choices.examples);
await set("quickness", 0.6);
seen.folder_faults = await page.evaluate(() => globalThis.studio.studio.faults);

// Gains, a pose, and whatever else a step may say.
await tab("Modify");
await page.getByRole("button", { name: "Add a step" }).click();
const add = async (key) => {
  await page.getByLabel("add an option…").selectOption(key);
  await settled();
};
seen.options = await page.getByLabel("add an option…").locator("option").evaluateAll((all) => all.map((one) => one.value));
await add("gains");
await set("middle", 1.7);
await page.getByLabel("add gains of single bands…").selectOption("bands");
await page.getByLabel("gains.bands").fill("0.5, 1, 1.4");
await page.getByLabel("gains.bands").press("Enter");
await add("pose");
await page.getByLabel("posed pose", { exact: true }).selectOption("captures/proud.bvh");
await page.getByLabel("posed pose, frame").fill("4");
await page.getByLabel("posed pose, frame").press("Enter");
await add("limbs");
await page.locator("[data-option=limbs]").getByLabel("feet", { exact: true }).check();
await add("soft_limits");
await page.getByRole("checkbox", { name: "soft_limits", exact: true }).uncheck();
await settled();
await pictures("options");
seen.modify_faults = await page.evaluate(() => globalThis.studio.studio.faults);
seen.modified = await page.evaluate(() => globalThis.studio.studio.made.modified);

await page.keyboard.press("Control+s");
await page.waitForFunction(() => document.querySelector(".state").textContent === "saved"
  || !document.querySelector(".refusal").hidden);
seen.refusal = await page.locator(".refusal p").allTextContents();
seen.saved = readFileSync(file, "utf8");
seen.wrong = wrong;
console.log(JSON.stringify(seen));
await browser.close();
