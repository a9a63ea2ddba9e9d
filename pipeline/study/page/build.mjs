// Bundles the pages, each into a folder of its own in FOLDER: node build.mjs FOLDER. Needs what `npm ci`
// brings, and nothing else.
import { build } from "esbuild";
import { cp, mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { livePage } from "./src/live_study/live_page.mjs";
import { noScriptText, writeTexts } from "./texts.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2];
if (!folder) {
  console.error("usage: node build.mjs FOLDER");
  process.exit(2);
}

/** What each page is made of: scripts and styles with what starts them, and files that go in as they are. Those with
    live motions (isLive) share their index.html. */
const pages = {
  live: { scripts: { live: "global.ts" }, files: [] },
  matching: { scripts: { matching: "main.ts" }, styles: { matching: "matching.css" }, files: [], isLive: true },
  chains: { scripts: { chains: "main.ts" }, styles: { chains: "chains.css" }, files: [], isLive: true },
  questionnaire: {
    scripts: { questionnaire: "main.ts", turn_view: "turn_view.ts" },
    files: ["index.html", "questionnaire.css"],
  },
  lab: { scripts: { lab: "main.ts" }, files: ["index.html", "lab.css"] },
  regress: { scripts: { regress: "main.ts" }, files: [] },
  walk: { scripts: { walk: "main.ts" }, styles: { walk: "walk.css" }, files: ["index.html"] },
  studio: { scripts: { studio: "main.ts" }, files: ["index.html", "studio.css"] },
};

/** Of a package that names it and does not bring its text. */
const mitLicence = (author) => `Copyright (c) ${author ?? "the authors"}

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

/** The licence of every package that went into scripts; "" where none did. */
async function licencesOf(scripts, inputs) {
  const packages = new Set();
  for (const input of inputs) {
    const found = input.match(/.*node_modules\/((?:@[^/]+\/)?[^/]+)\//);
    if (found) packages.add(found[1]);
  }
  if (packages.size === 0) return "";
  const names = Object.keys(scripts).map((script) => `${script}.js`);
  let licences = names.length > 1
    ? `${names.join(" and ")} hold parts of these packages.\n`
    : `${names[0]} holds parts of these packages.\n`;
  for (const name of [...packages].sort()) {
    const place = join(here, "node_modules", name);
    const { version, license, author } = JSON.parse(await readFile(join(place, "package.json"), "utf8"));
    const file = (await readdir(place)).find((entry) => /^licen[cs]e/i.test(entry));
    licences += `\n${"-".repeat(72)}\n${name} ${version} (${license})\n\n`;
    if (!file && license !== "MIT") throw new Error(`${name} comes without its licence`);
    licences += file ? await readFile(join(place, file), "utf8") : mitLicence(author?.name ?? author);
  }
  return licences;
}

await writeTexts(here);
const noScript = await noScriptText(here);
for (const [name, { scripts, styles = {}, files, isLive = false }] of Object.entries(pages)) {
  const source = join(here, "src", name);
  const out = join(folder, name);
  await rm(out, { recursive: true, force: true });
  await mkdir(out, { recursive: true });
  const result = await build({
    absWorkingDir: here,
    entryPoints: [...Object.entries(scripts), ...Object.entries(styles)].map(
      ([outName, start]) => ({ in: join(source, start), out: outName })),
    outdir: out,
    bundle: true,
    minify: true,
    format: "iife",
    target: ["chrome94", "firefox93", "safari15"],
    charset: "utf8",
    legalComments: "none",
    metafile: true,
    logLevel: "warning",
  });
  for (const file of files) await cp(join(source, file), join(out, file));
  if (isLive || files.includes("index.html")) {
    const page = isLive ? await livePage(name) : await readFile(join(source, "index.html"), "utf8");
    await writeFile(join(out, "index.html"), page.replace("<!-- no script -->", noScript));
  }
  const licences = await licencesOf(scripts, Object.keys(result.metafile.inputs));
  if (licences) await writeFile(join(out, "LICENSES.txt"), licences);
}
