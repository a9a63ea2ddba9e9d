// Bundles the pages into a folder: node build.mjs FOLDER. Needs what `npm ci` brings, and nothing else.
import { build } from "esbuild";
import { cp, mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2];
if (!folder) {
  console.error("usage: node build.mjs FOLDER");
  process.exit(2);
}

await rm(folder, { recursive: true, force: true });
await mkdir(folder, { recursive: true });
const result = await build({
  absWorkingDir: here,
  entryPoints: { questionnaire: "src/main.ts", turn_view: "src/turn_view.ts" },
  outdir: folder,
  bundle: true,
  minify: true,
  format: "iife",
  target: ["chrome94", "firefox93", "safari15"],
  charset: "utf8",
  legalComments: "none",
  metafile: true,
  logLevel: "warning",
});
for (const name of ["index.html", "questionnaire.css"])
  await cp(join(here, "src", name), join(folder, name));

// The licence of every package that went in.
const packages = new Set();
for (const input of Object.keys(result.metafile.inputs)) {
  const found = input.match(/.*node_modules\/((?:@[^/]+\/)?[^/]+)\//);
  if (found) packages.add(found[1]);
}
let licences = "questionnaire.js and turn_view.js hold parts of these packages.\n";
for (const name of [...packages].sort()) {
  const place = join(here, "node_modules", name);
  const { version, license, author } = JSON.parse(await readFile(join(place, "package.json"), "utf8"));
  const file = (await readdir(place)).find((entry) => /^licen[cs]e/i.test(entry));
  licences += `\n${"-".repeat(72)}\n${name} ${version} (${license})\n\n`;
  licences += file ? await readFile(join(place, file), "utf8") : `${author?.name ?? author ?? ""}\n`;
}
await writeFile(join(folder, "LICENSES.txt"), licences);
