// Somebody who counts the tones by which pages test the sound.

/** The numbers of tones that the page of a session plays, as it plays them. */
export async function countTonesOf(page) {
  await page.addInitScript(() => {
    globalThis.tonesPlayed = 0;
    const start = OscillatorNode.prototype.start;
    OscillatorNode.prototype.start = function (...given) {
      globalThis.tonesPlayed += 1;
      return start.apply(this, given);
    };
  });
}

/** Plays the tones by keys alone; returns how many they were. */
export async function hearTones(page) {
  await page.waitForFunction(() => document.querySelector("#tones"));
  await page.evaluate(() => { globalThis.tonesPlayed = 0; });
  const isDisabled = await page.locator("#tones").isDisabled();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.activeElement?.id === "tones", null, { timeout: 20000 });
  return { count: await page.evaluate(() => globalThis.tonesPlayed), isDisabled };
}
