// Whether the floor under a figure moves as far as the figure walks, without jumps: node --test floor.mjs
import assert from "node:assert/strict";
import { build } from "esbuild";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { openBrowser } from "../questionnaire/participant.mjs";

/**
 * What is seen of a figure that walks while its motion changes: of every frame the seconds since the former one, how far
 * the floor moved since then (of squares of half a metre, which all look alike), and how fast the figure walks.
 */
const seen = (page) => page.evaluate(async () => {
  const { view, core } = globalThis;
  view.show(1, null);
  let motion;
  const show = async (values) => {
    motion = await core.make({ kind: "features", sliders: ["stride", "tempo"], values });
    view.show(0, motion);
  };
  await show([0.5, 0.5]);
  await view.drawn();
  const frames = [];
  const place = () => view.ground.position.z;
  let before = [view.phase(), place()];
  const begunAgain = () => frames.filter(({ again }) => again).length;
  // At 60 frames per second, 120 are two seconds, and a cycle takes about one.
  for (let i = 0; i < 120 || (begunAgain() < 3 && i < 1200); i += 1) {
    if (i % 8 === 0) await show([((i * 0.37) % 1), ((i * 0.61) % 1)]);
    const from = view.phase();
    await view.drawn();
    const walked = ((view.phase() - from + 1) % 1) * motion.displacement[2];
    const floor = before[1] - place();
    frames.push({ walked, floor: floor - 0.5 * Math.round((floor - walked) / 0.5), again: view.phase() < from });
    before = [view.phase(), place()];
  }
  return frames;
});

test("the floor moves as far as the figure walks, also where its motion begins again or another follows", async () => {
  const folder = await mkdtemp(join(tmpdir(), "mien-floor-"));
  const browser = await openBrowser();
  try {
    await build({ entryPoints: [join(dirname(fileURLToPath(import.meta.url)), "try_figure.ts")], bundle: true,
      format: "iife", outfile: join(folder, "try.js"), logLevel: "warning" });
    await writeFile(join(folder, "try.html"), '<!doctype html><body><script src="try.js"></script></body>');
    const page = await browser.newPage({ viewport: { width: 480, height: 360 } });
    await page.goto(`file://${join(folder, "try.html")}`);
    await page.waitForFunction(() => globalThis.view);
    const frames = await seen(page);
    assert.ok(frames.filter(({ again }) => again).length >= 3);
    assert.ok(Math.max(...frames.map(({ walked }) => walked)) > 0.01);
    for (const { walked, floor } of frames) assert.ok(Math.abs(floor - walked) < 1e-9, `${floor} for ${walked}`);
  } finally {
    await browser.close();
    await rm(folder, { recursive: true });
  }
});
