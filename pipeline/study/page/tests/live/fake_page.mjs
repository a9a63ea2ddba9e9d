// Pages with a fake motion core.
import { build } from "esbuild";
import { mkdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { livePage } from "../../src/live_study/live_page.mjs";

const here = dirname(fileURLToPath(import.meta.url));

const withFakeCore = {
  name: "fake core",
  setup(builder) {
    builder.onResolve({ filter: /\/live\/(served|wasm)_core$/ }, ({ importer }) =>
      importer.includes("/src/") ? { path: join(here, "fake_live.ts") } : undefined);
  },
};

/** Writes the page of a kind of experiments, "matching" or "chains", with that experiment. */
export async function fakeLivePage(folder, name, experiment) {
  const page = join(here, "../../src", name);
  await mkdir(folder, { recursive: true });
  await build({
    entryPoints: [{ in: join(page, "main.ts"), out: name }, { in: join(page, `${name}.css`), out: name }],
    outdir: folder, bundle: true, format: "iife", logLevel: "warning", plugins: [withFakeCore],
  });
  await writeFile(join(folder, "index.html"), await livePage(name));
  await writeFile(join(folder, "experiment.js"), `globalThis.mienExperiment = ${JSON.stringify(experiment)};`);
  await writeFile(join(folder, "live_core.js"), 'globalThis.mien_live_files = { module: "", bundle: "" };');
}
