// The page with a fake motion core, for looking at it and trying it: fake_page(FOLDER) writes it there.
import { build } from "esbuild";
import { cp, mkdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const page = join(here, "../../src/matching");

const withFakeCore = {
  name: "fake core",
  setup(builder) {
    builder.onResolve({ filter: /\/live\/(served|wasm)_core$/ }, ({ importer }) =>
      importer.includes("/src/") ? { path: join(here, "fake_live.ts") } : undefined);
  },
};

const trial = (number, target, kind, practice = false) =>
  ({ number, block: practice ? "practice" : kind, kind: "matching", media: [], target, interface: kind, practice });

export const experiment = (more = {}) => ({
  format: "mien-matching-1", study: "try", title: "Make the same walk", language: "en", design: "d1",
  simulated: false, texts: { consent: ["Taking part is voluntary."], instructions: [], ending: ["Thank you."] },
  settings: { phones: "served" },
  matching: {
    limit_s: 300, threshold_m: 0.06, shows_distance: true, target_colour: "#2e8b57", created_colour: "#3465c8",
    sliders: {
      adjectives: { shown: ["quickness", "softness", "happiness", "strength"], offered: ["dryness", "maleness"] },
      features: { shown: ["stride", "arms"], offered: ["bow", "tempo"] },
      weights: { shown: ["normal", "long", "swinging", "bowed", "quick"], offered: [] },
    },
  },
  demographics: [],
  sessions: [{ participant: "p001", seed: "1", trials: [
    trial(1, "target-2", "adjectives", true), trial(2, "target-1", "adjectives"), trial(3, "target-1", "features"),
    trial(4, "target-1", "weights")] }],
  ...more,
});

export async function fakePage(folder, more) {
  await mkdir(folder, { recursive: true });
  await build({
    entryPoints: [{ in: join(page, "main.ts"), out: "matching" }, { in: join(page, "matching.css"), out: "matching" }],
    outdir: folder, bundle: true, format: "iife", logLevel: "warning", plugins: [withFakeCore],
  });
  await cp(join(page, "index.html"), join(folder, "index.html"));
  await writeFile(join(folder, "experiment.js"), `globalThis.mienExperiment = ${JSON.stringify(experiment(more))};`);
  await writeFile(join(folder, "live_core.js"), 'globalThis.mien_live_files = { module: "", bundle: "" };');
}
