// Somebody who takes a questionnaire whose stimuli are turned: node turned.mjs FOLDER [LINK]. FOLDER was exported; LINK is
// that of a participant of the same study on a server. Prints what is drawn of each stimulus at two moments, as JSON.
// MIEN_PICTURES: a folder for screenshots.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { openBrowser, take } from "./participant.mjs";
import { opener } from "./opened.mjs";

const [folder, link] = process.argv.slice(2);
const experiment = JSON.parse(readFileSync(join(folder, "experiment.json"), "utf8"));
const session = experiment.sessions.find(({ participant }) => participant === "p001");

/** What is drawn on the trial's canvas at a time: the people, their joints and surfaces; and the camera. */
const drawnAt = (page, seconds) => page.evaluate((seconds) => {
  const { screen } = document.querySelector("canvas.turned");
  screen.show(seconds);
  const rounded = (place) => place.toArray().map((number) => Math.round(1e5 * number) / 1e5);
  const people = screen.turned.object.children.map((group) => {
    const seen = { places: {}, face: {}, surfaces: 0, balls: 0, colours: [] };
    if (!group.visible) return seen;
    group.traverseVisible((part) => {
      if (part.isSkinnedMesh) {
        seen.surfaces += 1;
        for (const bone of part.skeleton.bones) seen.places[bone.name] = rounded(bone.position);
        for (const [name, target] of Object.entries(part.morphTargetDictionary ?? {}))
          seen.face[name] = part.morphTargetInfluences[target];
      } else if (part.isMesh && part.material.colorWrite) {
        seen.balls += 1;
        seen.places[`ball ${seen.balls}`] = rounded(part.parent.position);
        seen.colours.push(part.material.color.getHexString());
      }
    });
    return seen;
  });
  return { people, camera: rounded(screen.camera.position), seconds: screen.turned.seconds };
}, seconds);

const browser = await openBrowser();
const { page, troubles } = await opener(browser)(link ?? `file://${join(folder, "index.html")}?participant=p001`);
const seen = { stimuli: {}, cameras: {} };
await take(page, {
  each: async (sight, number) => {
    if (sight !== "trial" || !(await page.locator(".stage").count())) return false;
    const [token] = session.trials[number - 1].media;
    await page.waitForFunction(() => document.querySelector("canvas.turned")?.screen.turned, null, { timeout: 60000 });
    const stimulus = experiment.stimuli[token];
    seen.stimuli[stimulus] = [await drawnAt(page, 0), await drawnAt(page, 0.4)];
    const keys = async (...names) => {
      for (const key of names) await page.locator("canvas.turned").dispatchEvent("keydown", { key });
      return (await drawnAt(page, 0)).camera;
    };
    seen.cameras[stimulus] = { turned: await keys("ArrowLeft", "-"), home: await keys("Home") };
    if (process.env.MIEN_PICTURES) {
      await page.locator(".stage").evaluate((stage) => stage.classList.add("open"));
      await page.screenshot({ path: join(process.env.MIEN_PICTURES, `turned-${stimulus}.png`) });
      await page.locator(".stage").evaluate((stage) => stage.classList.remove("open"));
    }
    return false;
  },
});
seen.troubles = troubles;
console.log(JSON.stringify(seen));
await browser.close();
