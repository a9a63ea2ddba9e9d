// How soon the studio shows a slider's change:  node latency.mjs MIEN [FIGURE] [CHANGES]
// starts MIEN (a program) with 27 examples and 10 parameters, moves sliders in headless Chromium while
// the motion plays, and prints JSON: medians of milliseconds from the input event to the figure on the
// screen and of the server's share of it, and the processor time of a change, user and system, of the
// server and of the browser's processes. FIGURE is "stick" (default), "mannequin" or a character's file.
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { openBrowser } from "../questionnaire/participant.mjs";

const [program, figure = "stick", changes = "60"] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "mien-latency-"));
const look = /\.(glb|gltf|vrm)$/.test(figure) ? `{character: "${resolve(figure)}"}` : figure;
writeFileSync(join(folder, "latency.yaml"), `mien: 1
study: latency
examples: {set: builtin:walks-27, ratings: builtin}
look: {figure: ${look}}
stimuli:
  - id: moved
    adjectives: {quickness: 0.5}
`);

/** The link that a studio tells. */
function openStudio() {
  const studio = spawn(resolve(program), ["studio", "latency.yaml", "--json"], { cwd: folder, stdio: ["ignore", "pipe", "inherit"] });
  return new Promise((resolve, reject) => {
    studio.on("exit", (code) => reject(new Error(`the studio ended with ${code}`)));
    studio.stdout.once("data", (told) => resolve({ studio, link: JSON.parse(String(told)).link }));
  });
}

/** User and system time of a process, milliseconds (proc(5); its ticks are hundredths of a second). */
function processorMs(id) {
  const afterName = readFileSync(`/proc/${id}/stat`, "utf8").split(") ").at(-1).split(" ");
  return 10 * (Number(afterName[11]) + Number(afterName[12]));
}

async function browserMs(session) {
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  return 1000 * processInfo.reduce((sum, one) => sum + one.cpuTime, 0);
}

const median = (numbers) => [...numbers].sort((a, b) => a - b)[Math.floor(numbers.length / 2)];

const { studio, link } = await openStudio();
const browser = await openBrowser();
try {
  const session = await browser.newBrowserCDPSession();
  const page = await (await browser.newContext({ viewport: { width: 1366, height: 768 } })).newPage();
  await page.goto(link);
  await page.waitForFunction(() => globalThis.studio?.studio?.made, null, { timeout: 120000 });
  // Ten adjective pairs, each a little off the mean of the examples.
  const parameters = await page.evaluate(() => {
    const { studio } = globalThis.studio;
    const named = studio.choices.sliders.adjectives.slice(0, 10);
    const adjectives = Object.fromEntries(named.map((one, i) => [one.name, Math.round(100 * one.mean + 3 * (i % 3)) / 100]));
    studio.changeStimulus({ id: "moved", adjectives });
    return named.length;
  });
  await page.waitForFunction(() => {
    const { studio } = globalThis.studio;
    return !studio.isMaking && document.querySelectorAll(".slider input[type=range]").length >= 10;
  });
  await page.waitForTimeout(1500);
  const before = [processorMs(studio.pid), await browserMs(session)];
  const moved = await page.evaluate(async (count) => {
    const { studio } = globalThis.studio;
    const ranges = [...document.querySelectorAll(".slider input[type=range]")].slice(0, 10);
    const seen = [];
    for (let i = 0; i < count; i += 1) {
      const range = ranges[i % ranges.length];
      const made = studio.made;
      const from = performance.now();
      range.value = String(0.35 + 0.3 * ((i * 7) % 10) / 10 + 0.001 * i);
      range.dispatchEvent(new Event("input"));
      while (studio.made === made) await new Promise((resolve) => setTimeout(resolve, 0));
      const told = performance.now();
      await new Promise((resolve) => requestAnimationFrame(resolve));  // after the stage's own
      seen.push({ whole: performance.now() - from, told: told - from, server: 1000 * studio.made.seconds });
    }
    return seen;
  }, Number(changes));
  const after = [processorMs(studio.pid), await browserMs(session)];
  const share = (k) => Number(((after[k] - before[k]) / moved.length).toFixed(1));
  const of = (name) => Number(median(moved.map((one) => one[name])).toFixed(1));
  console.log(JSON.stringify({ examples: 27, parameters, figure, changes: moved.length,
    shown_ms: of("whole"), answered_ms: of("told"), made_ms: of("server"),
    server_processor_ms: share(0), browser_processor_ms: share(1) }));
} finally {
  await browser.close();
  studio.removeAllListeners("exit");
  studio.kill("SIGINT");
  rmSync(folder, { recursive: true, force: true });
}
