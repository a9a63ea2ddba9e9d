// Screenshots of try_figure.ts into FOLDER: node try_figure.mjs FOLDER
import { build } from "esbuild";
import { mkdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { openBrowser } from "../questionnaire/participant.mjs";

const folder = process.argv[2];
await mkdir(folder, { recursive: true });
await build({
  entryPoints: [join(dirname(fileURLToPath(import.meta.url)), "try_figure.ts")],
  bundle: true, format: "iife", outfile: join(folder, "try.js"), logLevel: "warning",
});
await writeFile(join(folder, "try.html"), '<!doctype html><body><script src="try.js"></script></body>');
const browser = await openBrowser();
const page = await browser.newPage({ viewport: { width: 1366, height: 768 } });
page.on("console", (message) => console.log(message.text()));
page.on("pageerror", (error) => console.log(String(error)));
await page.goto(`file://${join(folder, "try.html")}`);
await page.waitForFunction(() => globalThis.view);
const shot = async (name, ...what) => {
  await page.evaluate(async ([call, given]) => {
    globalThis.view.pause();
    if (call) globalThis.view[call](given);
    globalThis.view.seek(0.3);
    await globalThis.view.drawn();
  }, what);
  await page.screenshot({ path: join(folder, `${name}.png`) });
};
await shot("over");
await shot("beside", "arrange", "beside");
await shot("side", "lookFrom", "side");
await page.setViewportSize({ width: 390, height: 420 });
await shot("phone", "lookFrom", "front");
console.log(await page.evaluate(async () => {
  const view = globalThis.view;
  const from = performance.now();
  for (let i = 0; i < 20; i += 1) await view.drawn();
  return `${((performance.now() - from) / 20).toFixed(1)} ms per frame`;
}));
await browser.close();
