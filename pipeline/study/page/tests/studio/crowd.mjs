// Somebody who looks at several people in the studio: node crowd.mjs LINK STIMULUS. Selects them, looks at two moments of
// their film, tries to compare a motion with them, and goes back to the first stimulus. Prints what is drawn as JSON.
// MIEN_PICTURES: a folder for screenshots.
import { openStudio } from "./open_studio.mjs";

const [link, stimulus] = process.argv.slice(2);
const { browser, page, wrong, settled, pictures } = await openStudio(link);
const select = (name) => page.locator(".stimulus").filter({ hasText: name }).click();
const seen = {};

const drawnAt = (phase) => page.evaluate(async (phase) => {
  const { stage } = globalThis.studio;
  stage.seek(phase);
  await stage.drawn();
  const view = stage.peopleView;
  const people = view.turned.object.children.map((group) => {
    const one = { places: {}, surfaces: 0, balls: 0, face: {} };
    group.traverseVisible((part) => {
      if (part.isSkinnedMesh) {
        one.surfaces += 1;
        for (const bone of part.skeleton.bones) one.places[bone.name] = bone.position.toArray();
        for (const [name, target] of Object.entries(part.morphTargetDictionary ?? {}))
          one.face[name] = part.morphTargetInfluences[target];
      } else if (part.isMesh && part.material.colorWrite) {
        one.balls += 1;
        one.places[`ball ${one.balls}`] = part.parent.position.toArray();
      }
    });
    return one;
  });
  return { people, camera: view.camera.position.toArray(), seconds: view.turned.seconds };
}, phase);

await select(stimulus);
await page.waitForFunction(() => globalThis.studio.stage.peopleView, null, { timeout: 60000 });
await settled();
seen.begun = await drawnAt(0);
seen.middle = await drawnAt(0.5);
await pictures("people");
seen.canvases = await page.locator(".stage canvas").count();
seen.notes = await page.locator(".findings p").allTextContents();
seen.motion = await page.locator("section[aria-label=Motion] p").first().textContent();
await select("target-1");
await page.waitForFunction(() => !globalThis.studio.stage.peopleView, null, { timeout: 60000 });
await settled();
seen.canvases_then = await page.locator(".stage canvas").count();
await page.locator("select[name=against]").selectOption(stimulus);
await page.locator(".findings .wrong").first().waitFor();
seen.refusal = await page.locator(".findings .wrong").first().textContent();
seen.wrong = wrong.filter((told) => !/422/.test(told));
console.log(JSON.stringify(seen));
await browser.close();
