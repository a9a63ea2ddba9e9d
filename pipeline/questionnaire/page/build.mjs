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

/** Of a package that names it and does not bring its text. */
const mit_licence = (author) => `Copyright (c) ${author ?? "the authors"}

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and
associated documentation files (the "Software"), to deal in the Software without restriction,
including without limitation the rights to use, copy, modify, merge, publish, distribute, sublicense,
and/or sell copies of the Software, and to permit persons to whom the Software is furnished to do so,
subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial
portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT
LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN
NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY,
WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE
SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
`;

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
  if (!file && license !== "MIT") throw new Error(`${name} comes without its licence`);
  licences += file ? await readFile(join(place, file), "utf8") : mit_licence(author?.name ?? author);
}
await writeFile(join(folder, "LICENSES.txt"), licences);
