// What scenarios of experiments with live motions see of every page and trial.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

/** Makes a picture of everything that is seen, but for what is called `leftOut`, where there is a folder for them. */
export function picturesIn(folder, page, begin, leftOut = "") {
  let shots = 0;
  return async (seen) => {
    if (folder && seen !== leftOut)
      await page.screenshot({ path: join(folder, `${begin}-${String(shots++).padStart(2, "0")}-${seen}.png`) });
    return false;
  };
}

/** Faults of accessibility on every page and in every trial, and how many were looked at: `open` opens a page as each of
    `hows` says, and `take` takes it to its end. */
export async function accessibilityOf(hows, open, take) {
  const script = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
  const faults = [];
  let checked = 0;
  for (const how of hows) {
    const { page } = await open({ ...how, bypassCSP: true });
    await take(page, { each: async (seen, title) => {
      if (!(await page.evaluate(() => !!window.axe))) await page.evaluate(script);
      const { violations } = await page.evaluate(() => window.axe.run());
      checked += 1;
      for (const { id, impact, nodes } of violations)
        faults.push(`${impact} ${id} on ${title} (${seen}): ${nodes[0].html.slice(0, 120)}`);
      return false;
    } });
  }
  return { faults: [...new Set(faults)], checked };
}
