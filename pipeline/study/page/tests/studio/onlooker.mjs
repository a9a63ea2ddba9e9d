// Somebody who looks at figures in the studio: node onlooker.mjs LINK FIGURE…. Chooses each figure for the page, looks at
// two moments of the motion, and prints what is drawn as JSON: of a stick figure its hands, of a character its face.
// MIEN_PICTURES: a folder for screenshots.
import { openStudio } from "./open_studio.mjs";

const [link, ...figures] = process.argv.slice(2);
const { browser, page, wrong, settled, pictures } = await openStudio(link);
const seen = {};

/** Shows the first figure of the stage at a phase, in the round after so many others. */
const at = (phase, rounds = 0) => page.evaluate(async ([phase, rounds]) => {
  const { stage } = globalThis.studio;
  stage.seek(phase);
  await stage.drawn();
  stage.view.figures[0].pose(phase, rounds);
}, [phase, rounds]);

/** The joints of hands that are drawn, with where they are and how thick; and how far they are from where the server has
    them. */
const hands = () => page.evaluate(() => {
  const [figure] = globalThis.studio.stage.view.figures;
  const { positions } = globalThis.studio.studio.made.poses ?? {};
  const radiusOf = ({ geometry }) => {
    geometry.computeBoundingBox();
    return geometry.boundingBox.max.y;
  };
  return {
    fingers: figure.fingers.filter(({ group }) => group.visible).map(({ name }) => name),
    palms: figure.palms.filter(({ group }) => group.visible).map(({ name }) => name),
    whole: figure.body.filter(({ name, group }) => name.endsWith("Wrist") && group.visible).map(({ name }) => name),
    radii: Object.fromEntries(figure.fingers.map(({ name, veil }) => [name, radiusOf(veil)])),
    off: positions ? Math.max(...figure.fingers.map(({ group }, f) => Math.abs(
      group.position.y - positions[3 * (figure.body.length + f) + 1]))) : null,
    palm_off: Math.max(...figure.palms.map(({ group, joint }) =>
      group.position.distanceTo(figure.body[joint].group.position))),
  };
});

/** The weights of morph targets that are drawn, by name. */
const face = () => page.evaluate(() => {
  const { skin } = globalThis.studio.stage.view.figures[0];
  return Object.assign({}, ...skin.surfaces.filter(({ morphTargetDictionary }) => morphTargetDictionary).map((surface) =>
    Object.fromEntries(Object.entries(surface.morphTargetDictionary).map(([name, target]) =>
      [name, surface.morphTargetInfluences[target]]))));
});

for (const figure of figures) {
  await page.locator("select[name=shown-on]").selectOption(figure);
  await settled();
  if (figure === "stick") {
    await at(0);
    seen.hands = await hands();
    await pictures("stick");
    continue;
  }
  await page.waitForFunction(() => globalThis.studio.stage.view.figures[0].isDressed(), null, { timeout: 60000 });
  await at(0.25);
  seen.quarter = await face();
  await pictures("quarter");
  await at(0.5, 1);
  seen.half_later = await face();
  seen.cycle_s = await page.evaluate(() => {
    const { frames, fps } = globalThis.studio.studio.made.motion;
    return frames / fps;
  });
}
seen.wrong = wrong;
console.log(JSON.stringify(seen));
await browser.close();
