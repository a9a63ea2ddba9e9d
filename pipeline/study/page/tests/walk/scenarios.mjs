// Somebody who steers the walker in a real browser:
//   node scenarios.mjs FOLDER MODULE [PICTURES]
// FOLDER holds the page, MODULE is live_core.wasm. Prints what was measured as JSON; with PICTURES,
// screenshots are put there.
import { readFile, mkdir } from "node:fs/promises";
import { join, resolve } from "node:path";
import { filesOf, serve } from "../http_server.mjs";
import { openBrowser } from "../questionnaire/participant.mjs";
import { largestAcceleration, largestDistance, largestSlide, median, quantile } from "./walk_measures.mjs";

const [folder, module, pictures] = process.argv.slice(2);
const files = await filesOf(resolve(folder));
files["/live_core.wasm"] = await readFile(module);
const served = await serve(files);
const browser = await openBrowser();
const troubles = [];

async function open(viewport) {
  const page = await browser.newPage({ viewport });
  page.on("console", (message) => { if (message.type() === "error") troubles.push(message.text()); });
  page.on("pageerror", (error) => troubles.push(error.message));
  await page.goto(`${served.base}/index.html`);
  await page.waitForFunction(() => globalThis.mien_walk, null, { timeout: 60000 });
  return page;
}

const picture = async (page, name) => {
  if (!pictures) return;
  await mkdir(pictures, { recursive: true });
  await page.screenshot({ path: join(pictures, `${name}.png`) });
};

const setSlider = (page, name, value) => page.evaluate(([label, to]) => {
  const slider = document.querySelector(`input[aria-label="${label}"]`);
  slider.value = String(to);
  slider.dispatchEvent(new Event("input", { bubbles: true }));
}, [name, value]);

/** Keeps the frames that are shown from now on. */
const record = (page) => page.evaluate(() => {
  globalThis.seen = [];
  let t = 0;
  globalThis.mien_walk.watch((frame, seconds, times) => {
    t += seconds;
    globalThis.seen.push({ t, seconds, ...times, positions: [...frame.positions], rotations: [...frame.rotations],
      planted: [...frame.planted], speed: frame.speed, heading: frame.heading });
  });
});
const recorded = (page) => page.evaluate(() => globalThis.seen);

/** By keys and sliders: forwards, round a curve, sadder, about, and to a stand. */
async function steered() {
  const page = await open({ width: 1280, height: 720 });
  const body = await page.evaluate(() => globalThis.mien_walk.walker.info.body);
  await picture(page, "walk-standing");
  await record(page);
  const wait = (seconds) => page.waitForTimeout(1000 * seconds);
  await page.keyboard.down("ArrowUp");
  await wait(2.5);
  await page.keyboard.down("ArrowLeft");
  await wait(1.5);
  await page.keyboard.up("ArrowLeft");
  await picture(page, "walk-turned");
  await setSlider(page, "normal", 0);
  await setSlider(page, "sad", 1);
  await wait(2);
  await picture(page, "walk-sad");
  await page.keyboard.up("ArrowUp");
  await page.keyboard.down("ArrowRight");
  await wait(1.5);
  await page.keyboard.up("ArrowRight");
  await wait(2.5);
  const seen = await recorded(page);
  const end = seen[seen.length - 1];
  await page.close();
  return {
    frames: seen.length,
    slide_mm: 1000 * largestSlide(seen, body),
    fastest: Math.max(...seen.map((frame) => frame.speed)),
    speed_at_end: end.speed,
    most_heading: Math.max(...seen.map((frame) => frame.heading)),
    heading_at_end: end.heading,
    way_m: Math.hypot(end.positions[0], end.positions[2]),
    frame_ms: { median: 1000 * median(seen.slice(1).map((frame) => frame.seconds)),
      p95: 1000 * quantile(seen.slice(1).map((frame) => frame.seconds), 0.95) },
    walker_ms: { median: median(seen.map((frame) => frame.walker)), p95: quantile(seen.map((frame) => frame.walker), 0.95) },
    drawing_ms: { median: median(seen.map((frame) => frame.drawing)), p95: quantile(seen.map((frame) => frame.drawing), 0.95) },
  };
}

/** The walker alone, at 60 frames a second of its own time, steered at random for a minute. */
async function byItself() {
  const page = await open({ width: 640, height: 480 });
  const { frames, body, ms, opened_ms: openedMs } = await page.evaluate(async () => {
    const opening = performance.now();
    const walker = await globalThis.mien_walk_alone();
    const openedMs = performance.now() - opening;
    let state = 12345;
    const random = () => (state = (1103515245 * state + 12345) % 2147483648) / 2147483648;
    const frames = [];
    let wish = { pace: 0, turn_deg_s: 0, moods: [1] };
    const begun = performance.now();
    for (let i = 0; i < 3600; i += 1) {
      if (i % 45 === 0) {
        const moods = walker.info.moods.map(() => (random() < 0.25 ? random() : 0));
        wish = { pace: random() < 0.25 ? 0 : 1.2 * random(), turn_deg_s: random() < 0.5 ? 0 : 140 * random() - 70, moods };
      }
      const frame = walker.advance(1 / 60, wish);
      frames.push({ positions: [...frame.positions], rotations: [...frame.rotations], planted: [...frame.planted] });
    }
    return { frames, body: walker.info.body, ms: (performance.now() - begun) / 3600, opened_ms: openedMs };
  });
  await page.close();
  return { slide_mm: 1000 * largestSlide(frames, body), acceleration: largestAcceleration(frames, 1 / 60), ms_a_frame: ms, opened_ms: openedMs };
}

/** How soon a mood is seen: two walkers do the same, and one of them becomes sad. */
async function mood() {
  const page = await open({ width: 640, height: 480 });
  const [plain, sadder] = await page.evaluate(async () => {
    const changedAt = 180;
    const walked = async (mood) => {
      const walker = await globalThis.mien_walk_alone();
      const only = (name) => walker.info.moods.map((one) => (one === name ? 1 : 0));
      const frames = [];
      for (let i = 0; i < changedAt + 60; i += 1) {
        const frame = walker.advance(1 / 60, { pace: 1, moods: only(i < changedAt ? "normal" : mood) });
        if (i >= changedAt - 1) frames.push({ positions: [...frame.positions] });
      }
      return frames;
    };
    return [await walked("normal"), await walked("sad")];
  });
  await page.close();
  // From the pelvis, so that what differs is posture and not place.
  const posture = ({ positions }) => ({ positions: positions.map((x, k) => x - positions[k % 3]) });
  const apart = plain.map((frame, i) => largestDistance(posture(frame), posture(sadder[i])));
  const firstMs = (metres) => apart.findIndex((distance) => distance > metres) * 1000 / 60;
  return { before_mm: 1000 * apart[0], one_cm_ms: firstMs(0.01), three_cm_ms: firstMs(0.03) };
}

/** On a phone the controls lie below. */
async function phone() {
  const page = await open({ width: 390, height: 844 });
  await page.waitForTimeout(300);
  await picture(page, "walk-phone");
  const hold = page.locator('button[aria-label="walk"]');
  await record(page);
  await hold.dispatchEvent("pointerdown", { pointerId: 1 });
  await page.waitForTimeout(1500);
  await hold.dispatchEvent("pointerup", { pointerId: 1 });
  const seen = await recorded(page);
  const isWide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
  await page.close();
  return { fastest: Math.max(...seen.map((frame) => frame.speed)), is_wide: isWide };
}

/** With a gamepad's stick to the front right, and its cross to the left. */
async function gamepad() {
  const page = await open({ width: 640, height: 480 });
  await page.evaluate(() => {
    globalThis.pad = { axes: [0, 0], buttons: Array.from({ length: 16 }, () => ({ pressed: false, value: 0 })) };
    navigator.getGamepads = () => [null, globalThis.pad];
  });
  await record(page);
  await page.evaluate(() => { globalThis.pad.axes = [0.1, 0.1]; });  // a stick that is let go
  await page.waitForTimeout(500);
  const rested = Math.max(...(await recorded(page)).map((frame) => frame.speed));
  await page.evaluate(() => { globalThis.pad.axes = [0.6, -1]; });
  await page.waitForTimeout(2000);
  const right = (await recorded(page)).at(-1);
  await page.evaluate(() => { globalThis.pad.axes = [0, 0]; globalThis.pad.buttons[14].pressed = true; });
  await page.waitForTimeout(2000);
  const left = (await recorded(page)).at(-1);
  await page.close();
  return { rested, speed: right.speed, heading: right.heading, back: left.heading - right.heading };
}

const told = { steered: await steered(), by_itself: await byItself(), mood: await mood(), phone: await phone(),
  gamepad: await gamepad(), troubles };
console.log(JSON.stringify(told));
await browser.close();
served.close();
