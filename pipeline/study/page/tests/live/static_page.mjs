// Opens the live core in Chromium as a page from disk does, without any server:
//   node static_page.mjs FOLDER REQUESTS
// FOLDER holds live.js and live_files.js; a page that loads both is written there. REQUESTS is a JSON
// array of requests (src/live/wasm_instance.ts). Prints JSON: { worker, answers, milliseconds }: whether
// there was a worker, what each request was answered (motions by their last frame's joints) and, median of
// 25 changes of one slider, the time from asking for a motion until the next frame that could show it.
import { readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { chromium } from "playwright-core";

const [folder, requests] = process.argv.slice(2);
const policy = "default-src 'none'; script-src 'self' file: 'wasm-unsafe-eval'; worker-src blob:";
await writeFile(join(folder, "page.html"), `<!doctype html><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<script src="live_files.js"></script><script src="live.js"></script>`);

const browser = await chromium.launch({
  executablePath: process.env.MIEN_CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox"],
});
try {
  const page = await browser.newPage();
  const faults = [];
  page.on("pageerror", (error) => faults.push(String(error)));
  page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
  await page.goto(`file://${join(folder, "page.html")}`);
  const found = await page.evaluate(async (asked) => {
    let workers = 0;
    const Plain = globalThis.Worker;
    globalThis.Worker = class extends Plain {
      constructor(...given) {
        super(...given);
        workers += 1;
      }
    };
    const { module, bundle } = globalThis.mien_live_files;
    const core = await globalThis.mien_live.openWasm(module, bundle);
    const answers = [];
    for (const request of asked) {
      try {
        if (request.what === "distance") {
          answers.push({ D: (await core.distance(request.target, request.setting)).D });
          continue;
        }
        const made = request.what === "make" ? await core.make(request.setting) : await core[request.what](request.name);
        answers.push({ frames: made.frames, joints: [...made.positions.slice(-63)] });
      } catch (error) {
        answers.push({ error: error.message });
      }
    }
    const times = {};
    for (const kind of ["adjectives", "features", "weights"]) {
      const sliders = kind === "weights" ? core.info.examples
        : core.info.sliders[kind].slice(0, 10).map((slider) => slider.name);
      const values = sliders.map(() => 0.5);
      const taken = [];
      for (let change = 0; change < 40; ++change) {
        values[change % values.length] = ((change * 7) % 20) / 20;
        const start = performance.now();
        await core.make({ kind, sliders, values });
        const made = performance.now() - start;
        await new Promise(requestAnimationFrame);
        if (change >= 15) taken.push([made, performance.now() - start]);
      }
      const median = (index) => taken.map((pair) => pair[index]).sort((a, b) => a - b)[12];
      times[kind] = { made: median(0), shown: median(1) };
    }
    return { worker: workers > 0, answers, milliseconds: times };
  }, JSON.parse(await readFile(requests, "utf8")));
  console.log(JSON.stringify({ ...found, faults }));
} finally {
  await browser.close();
}
