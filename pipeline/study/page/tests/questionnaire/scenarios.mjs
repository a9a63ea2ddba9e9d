// Participants of an exported questionnaire in a real browser.
//   node scenarios.mjs NAME FOLDER
// prints what came of it as JSON: the files that were saved, and whatever the browser complained of.
import { readFileSync } from "node:fs";
import { basename, join, resolve } from "node:path";
import { createRequire } from "node:module";
import { filesOf, filesOfZip, serve } from "../http_server.mjs";
import { savedAll } from "./pages.mjs";
import { jatosScript } from "./jatos_script.mjs";
import { desktop, opener, phone, withFiles } from "./opened.mjs";
import { openBrowser, take } from "./participant.mjs";
import { countTonesOf, hearTones } from "./tones.mjs";

const [name, given] = process.argv.slice(2);
const folder = resolve(given);
const onDisk = `file://${folder}/index.html`;

const browser = await openBrowser();
const open = opener(browser);

/** A reload in the middle of trial 3, while its film runs. */
async function reload() {
  const opened = await open(`${onDisk}?participant=p002`);
  const seen = [];
  let reloads = 0;
  await take(opened.page, { each: async (sight, number) => {
    if (sight === "trial" && number === 3 && reloads === 0) {
      await opened.page.locator(".play").click();
      await opened.page.waitForTimeout(200);
      reloads += 1;
      await opened.page.reload();
      return true;
    }
    if (sight === "trial") seen.push(number);
    return false;
  } });
  return withFiles(opened, { seen, reloads });
}

async function keys() {
  const opened = await open(`${onDisk}?participant=p001`);
  await opened.page.mouse.move(0, 0);
  await take(opened.page, { by_keys: true });
  return withFiles(opened);
}

/**
 * From a web server that sends one film late and another one broken at first; later a film stops on
 * its way. A blob that is here cannot really stop, so its events are what is made.
 */
async function stall() {
  const asked = {};
  let late = "";
  let lateMs = 0;
  const began = Date.now();
  const server = await serve(await filesOf(folder), async (path, answer) => {
    if (!path.startsWith("/media/")) return false;
    asked[path] = (asked[path] ?? 0) + 1;
    late ||= path;
    if (path === late) {
      await new Promise((done) => setTimeout(done, 2500));
      lateMs = Date.now() - began;
    } else if (asked[path] === 1 && Object.keys(asked).length === 2) {
      answer.writeHead(200, { "Content-Type": "video/mp4" }).end("no video");
      return true;
    }
    return false;
  });
  const opened = await open(`${server.base}/index.html?participant=p003`);
  const { page } = opened;
  let firstTrialMs = 0;
  let again = 0;
  await take(page, { each: async (sight, number) => {
    if (sight === "load") {
      await page.waitForFunction(() => !document.querySelector(".page progress") ||
        document.querySelector(".page .main"));
      const button = page.locator(".page .main");
      if (await page.locator(".page progress").count() && await button.count()) {
        again += 1;
        await button.click();
      }
      await page.waitForFunction(() => !document.querySelector(".page progress") ||
        document.querySelector(".page .main"));
      return true;
    }
    if (sight === "trial") firstTrialMs ||= Date.now() - began;
    if (sight === "trial" && number === 2)
      await page.evaluate(() => {
        const video = document.querySelector("video");
        video.addEventListener("playing", () => setTimeout(() => {
          video.pause();
          video.dispatchEvent(new Event("waiting"));
          setTimeout(() => void video.play(), 500);
        }, 150), { once: true });
      });
    return false;
  } });
  const given = await withFiles(opened, { first_trial_ms: firstTrialMs, late_ms: lateMs, again });
  server.close();
  return given;
}

/** On a phone, in a questionnaire that refuses them. */
async function refusedPhone() {
  const { page, troubles } = await open(onDisk, phone);
  const text = await page.locator("main").innerText();
  return { text, trials: await page.locator(".trial, .button").count(), troubles };
}

const refuse = async (page) => {
  await page.locator(".page .button").nth(1).click();
  await page.waitForFunction(() => !document.querySelector(".page .button:not(.leave)"));
};

/** Whoever does not agree, or only looks, leaves nothing behind and is not listed; who agreed is. */
async function refusal() {
  const { page, troubles } = await open(onDisk);
  const kept = () => page.evaluate(() => [...Object.keys(localStorage), ...Object.keys(sessionStorage), window.name]
    .filter(Boolean));
  const listed = async () => {
    await page.goto(`${onDisk}?experimenter`);
    await page.waitForSelector(".page h2");
    const lines = await page.locator(".page li").allInnerTexts();
    await page.goto(onDisk);
    await page.waitForSelector(".page .buttons .main");
    return lines;
  };
  await page.waitForSelector(".page .buttons .main");
  const told = { looked: await kept(), listed_looked: await listed() };
  await refuse(page);
  Object.assign(told, { text: await page.locator("main").innerText(), refused: await kept(), listed_refused: await listed() });
  await page.locator(".page .buttons .main").click();
  await page.waitForSelector(".withdrawal");
  const agreed = (await kept()).map((key) => key.replace(/.*[/]/, "")).sort();
  return { ...told, agreed, listed_agreed: await listed(), troubles };
}

/** The same on JATOS. */
async function jatosRefusal() {
  const { address, close } = await jatosServer();
  const { page, troubles } = await open(address);
  await page.waitForSelector(".page .buttons .main");
  const kept = () => page.evaluate(() => JSON.parse(sessionStorage.jatos ?? "{}"));
  const looked = await kept();
  await refuse(page);
  const refused = await kept();
  close();
  return { looked, refused, troubles };
}

const axe = () => readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Faults of accessibility of a page that was opened with bypassCSP. */
async function faultsOf(page) {
  if (!(await page.evaluate(() => !!window.axe))) await page.evaluate(axe());
  const { violations } = await page.evaluate(() => window.axe.run());
  return violations.map(({ id, impact, nodes }) => ({ fault: `${impact} ${id}`, html: nodes[0].html.slice(0, 120) }));
}

/** Faults of accessibility on every page, on a laptop or as `how` says. */
async function accessibility(how = desktop) {
  const faults = [];
  let checked = 0;
  const { page } = await open(onDisk, { ...how, bypassCSP: true });
  const check = async (where) => {
    checked += 1;
    for (const { fault, html } of await faultsOf(page)) faults.push(`${fault} on ${where}: ${html}`);
  };
  await take(page, { each: async (sight, number) => {
    if (sight === "load") return false;
    await check(`${sight} ${number}`);
    if (sight === "trial" && await page.locator(".grid-stage").count()) {
      await page.waitForFunction(() => !document.querySelector(".play-film:disabled"));
      await page.locator(".play-film").nth(1).click();
      await check(`a film of the grid of trial ${number}`);
      await page.waitForFunction(() => !document.querySelector(".stage.playing"));
      await page.locator(".answers .main").click();
      await check(`what is missing in the grid of trial ${number}`);
    } else if (sight === "trial" && number < 3 && await page.locator(".stage").count()) {
      await page.locator(".play").click();
      await page.waitForFunction(() => !document.querySelector(".answers").inert);
      await check(`answers of trial ${number}`);
    }
    if (sight === "trial" && number === 1) {
      await page.locator(".withdrawal > .button").click();
      await check("withdrawal");
      await page.locator("dialog .main").click();
    }
    return false;
  } });
  return { faults, checked };
}

/** As narrow as a phone, and not refused as one. */
const narrowAccessibility = () => accessibility({ viewport: phone.viewport });

/** A server that shows the study as JATOS unpacks it. */
async function jatosServer() {
  const archive = join(folder, givenStudy());
  const files = await filesOfZip(archive);
  const described = Object.keys(files).find((path) => path.endsWith(".jas"));
  const { dirName } = JSON.parse(files[described]).data;
  files[`/${dirName}/jatos.js`] = Buffer.from(jatosScript);
  const server = await serve(files);
  return { address: `${server.base}/${dirName}/index.html`, close: () => server.close() };
}

/** As JATOS shows it, with a reload on the way. */
async function jatos() {
  const { address, close } = await jatosServer();
  const { page, troubles } = await open(address);
  let reloads = 0;
  await take(page, { each: async (sight, number) => {
    if (sight !== "trial" || number !== 2 || reloads > 0) return false;
    reloads += 1;
    await page.reload();
    return true;
  } });
  const told = await page.evaluate(() => !!JSON.parse(sessionStorage.jatos).ended);
  await page.locator(".leave").click();
  await page.waitForFunction(() => JSON.parse(sessionStorage.jatos).ended);
  const kept = await page.evaluate(() => JSON.parse(sessionStorage.jatos));
  const leaving = await open(address);
  await leaving.page.locator(".page .buttons .main").click();
  await leaving.page.locator(".withdrawal > .button").click();
  await leaving.page.locator("dialog .button").nth(1).click();
  await leaving.page.waitForFunction(() => /have been deleted/.test(document.querySelector("main").innerText));
  const withdrawn = await leaving.page.evaluate(() => JSON.parse(sessionStorage.jatos));
  close();
  return { withdrawn, answers: kept.result, files: Object.keys(kept.files ?? {}).sort(), taken: kept.batch.mien_taken,
    troubles, reloads, ended_before_it_was_read: told };
}

/**
 * From a server that keeps records, in their order and each once, and that breaks off every first
 * try: before it has kept the record, or (of even trials) after. The policy is that of mien study
 * serve.
 */
async function served() {
  const policy = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; " +
    "media-src 'self' blob:; connect-src 'self' blob:; base-uri 'none'; form-action 'none'";
  const files = await filesOf(folder);
  const experiment = JSON.parse(files["/experiment.json"]);
  delete experiment.stimuli;
  experiment.sessions = experiment.sessions.slice(0, 1);
  for (const media of Object.values(experiment.media)) media.file = `../../${media.file}`;
  const kept = new Map();
  const tried = new Set();
  const wrong = [];
  const pageOf = { "/s/link/": "index.html", "/s/link/questionnaire.js": "questionnaire.js",
    "/s/link/questionnaire.css": "questionnaire.css" };
  const server = await serve(files, async (path, answer, request) => {
    answer.setHeader("Content-Security-Policy", policy);
    if (path === "/s/link/session.json") {
      answer.setHeader("Content-Type", "application/json");
      answer.end(JSON.stringify({ ...experiment, kept: [...kept.keys()] }));
      return true;
    }
    if (path.startsWith("/s/link/records/")) {
      let body = "";
      for await (const part of request) body += part;
      const record = path.split("/").pop();
      const isFirst = !tried.has(record);
      tried.add(record);
      const keepsFirst = /[02468]$/.test(record);
      if (!isFirst || keepsFirst) {
        if (kept.has(record) && kept.get(record) !== body) wrong.push(`${record} came otherwise`);
        kept.set(record, body);
      }
      if (isFirst) request.socket.destroy();
      else answer.writeHead(200, { "Content-Type": "application/json" }).end(JSON.stringify({ kept: record }));
      return true;
    }
    const file = pageOf[path];
    if (!file) return false;
    const text = String(files[`/${file}`]).replace('name="mien-mode" content="static"', 'name="mien-mode" content="served"');
    answer.setHeader("Content-Type", file.endsWith("html") ? "text/html" : file.endsWith("css") ? "text/css" : "text/javascript");
    answer.end(text);
    return true;
  });
  const opened = await open(`${server.base}/s/link/`);
  let reloads = 0;
  await take(opened.page, { each: async (sight, number) => {
    if (sight !== "trial" || number !== 2 || reloads > 0) return false;
    reloads += 1;
    await opened.page.reload();
    return true;
  } });
  const text = await opened.page.locator("main").innerText();
  server.close();
  // Connections that were cut are told by the browser, and meant.
  const troubles = opened.troubles.filter((one) => !/net::ERR/.test(one));
  return { kept: [...kept.keys()], wrong, troubles, reloads, text, saved: Object.keys(opened.saved) };
}

/**
 * From a real mien study serve; FOLDER is a file: {"first": …, "second": …, "join": …, "status": …},
 * addresses of two participants, of the link of all and of the laboratory's status.
 */
async function laboratory() {
  const { first, second, join: all, status } = JSON.parse(readFileSync(folder, "utf8"));
  const lab = async () => (await (await fetch(status)).json()).participants;
  const text = (page) => page.locator("main").innerText();
  const closed = (page) => page.waitForFunction(() =>
    document.querySelector(".page") && !document.querySelector(".button, .page progress"), null, { timeout: 30000 });
  const told = {};

  // By mouse, with a reload; a second browser comes before and between.
  const early = await open(first);
  await early.page.waitForSelector(".page .buttons .main");
  const mouse = await open(first);
  let reloads = 0;
  await take(mouse.page, { each: async (sight, number) => {
    if (sight !== "trial" || number !== 2 || reloads > 0) return false;
    reloads += 1;
    await early.page.locator(".page .buttons .main").click();
    await closed(early.page);
    told.early = await text(early.page);
    const late = await open(first);
    await closed(late.page);
    told.late = await text(late.page);
    await mouse.page.reload();
    return true;
  } });
  told.mouse = await text(mouse.page);

  const keys = await open(second);
  await take(keys.page, { by_keys: true });
  told.keys = await text(keys.page);

  // Of those who come by the link of all, a phone is sent away, one refuses, and one agrees.
  const before = await lab();
  const sentAway = await open(all, phone);
  await closed(sentAway.page);
  told.phone = await text(sentAway.page);
  const refusing = await open(all);
  await refusing.page.locator(".page .button").nth(1).click();
  await closed(refusing.page);
  told.refusing = await text(refusing.page);
  const between = await lab();
  const joined = await open(all);
  await take(joined.page);
  told.joined = await text(joined.page);
  const after = await lab();
  // The experimenter's page: nobody is missing because people come by the link of all.
  const monitor = await open(status.replace(/status\.json$/, ""));
  await monitor.page.waitForSelector("#participants tr");
  const listed = () => monitor.page.locator("#participants th").allTextContents();
  const monitored = { rows: await listed(), unopened: await monitor.page.locator("#unopened").textContent() };
  await monitor.page.locator("#unopened").click();
  monitored.all = await listed();
  monitored.states = await monitor.page.locator("#participants .state").allTextContents();
  monitored.hide = await monitor.page.locator("#unopened").textContent();
  const troubles = [mouse, keys, sentAway, refusing, joined, monitor].flatMap((one) => one.troubles);
  return { ...told, reloads, troubles, monitored, path: new URL(joined.page.url()).pathname,
    participants: [before.length, between.length, after.length], states: after.map(({ state }) => state) };
}

/**
 * Participants whom Prolific sends to a real mien study serve; FOLDER is a file: {"join": …}. One goes to the
 * end with a reload on the way; others do not agree, have a phone, a small window or the wrong age, withdraw, or
 * are careless. Prolific itself answers here.
 */
async function prolific() {
  const { join: all } = JSON.parse(readFileSync(folder, "utf8"));
  const linkOf = (id) => `${all}?PROLIFIC_PID=${id}&STUDY_ID=study%201&SESSION_ID=${id}-s&other=1`;
  const text = (page) => page.locator("main").innerText();
  const troubles = [];
  const come = async (id, how) => {
    const opened = await open(linkOf(id), how);
    await opened.page.context().route("https://app.prolific.com/**", (route) =>
      route.fulfill({ contentType: "text/html", body: "<p>Prolific" }));
    troubles.push(opened.troubles);
    return opened.page;
  };
  const backOf = async (page) => {
    const said = await text(page);
    await page.locator(".leave").click();
    await page.waitForURL("https://app.prolific.com/**");
    return { said, url: page.url() };
  };
  const page = await come("5f01");
  let session = "";
  let reloads = 0;
  let linkAgain = "";
  await take(page, { each: async (sight, number) => {
    if (sight === "trial" && number === 3 && !linkAgain) {
      await page.goto(linkOf("5f01"));
      await page.waitForURL(/\/s\/[^/]*\/$/);
      linkAgain = new URL(page.url()).pathname;
      return true;
    }
    if (sight !== "trial" || number !== 2 || reloads > 0) return false;
    reloads += 1;
    session = await page.evaluate(async () => (await fetch("session.json")).text());
    await page.reload();
    return true;
  } });
  const own = new URL(page.url());
  await page.reload();  // at the end: debriefed once more, and the way back is still there
  await take(page);
  await page.locator(".page .quiet").click();  // and is not taken by itself
  const completed = await backOf(page);
  const refusing = await come("5f02");
  await refusing.locator(".page .button").nth(1).click();
  await refusing.waitForSelector(".leave");
  const refused = await backOf(refusing);
  const onPhone = await come("5f03", phone);
  await onPhone.waitForSelector(".leave");
  const screenedOut = await backOf(onPhone);
  const young = await come("5f05");
  await take(young, { age: "12" });
  await young.reload();  // still turned away
  await young.waitForSelector(".leave");
  const tooYoung = await backOf(young);

  const small = await come("5f06", { viewport: { width: 900, height: 500 } });
  await small.locator(".page .buttons .main").click();
  await small.waitForFunction(() => /900 × 500/.test(document.querySelector(".page")?.innerText ?? ""));
  const asked = await text(small);
  await small.setViewportSize({ width: 1000, height: 600 });
  await small.waitForSelector(".question");
  await small.setViewportSize({ width: 900, height: 500 });
  await small.reload();
  await small.locator(".page .button").click();  // "I cannot make it larger"
  await small.waitForSelector(".leave");
  const tooSmall = { asked, ...(await backOf(small)) };

  const leaving = await come("5f07");
  const offer = leaving.locator(".withdrawal > .button");
  const offered = await offer.count();
  await take(leaving, { each: async (sight, number) => {
    if (sight !== "trial" || number !== 2) return false;
    await offer.click();
    await leaving.locator("dialog .main").click();  // goes on after all
    await offer.click();
    await leaving.keyboard.press("1");  // answers nothing behind the dialog
    await leaving.locator("dialog .button").nth(1).click();
    await leaving.waitForSelector(".leave");
    return true;
  } });
  const left = leaving.url();
  const remembered = await leaving.evaluate(() => JSON.stringify(localStorage));
  const withdrawn = { remembered, offered, still_offered: await offer.count(), ...(await backOf(leaving)) };
  await leaving.goto(left);
  await leaving.waitForSelector(".page h1");
  withdrawn.again = await text(leaving);

  const careless = await come("5f08");
  await take(careless, { careless: true });
  await careless.locator(".page .quiet").click();
  const failedAttention = await backOf(careless);
  const soon = await come("5f04");
  await take(soon);
  await soon.waitForURL("https://app.prolific.com/**", { timeout: 20000 });  // by itself
  return { completed, refused, screened_out: screenedOut, too_young: tooYoung, too_small: tooSmall, withdrawn,
    failed_attention: failedAttention, session, link_again: linkAgain, search: own.search, path: own.pathname, soon: soon.url(),
    troubles: troubles.flat() };
}

/** Stimuli of a fixed size on a screen with two device pixels per CSS pixel, calibrated at 400 px for a card. */
async function calibrated() {
  const told = {};
  const comeWith = async (viewport) => {
    const opened = await open(`${onDisk}?participant=p001`, { viewport, deviceScaleFactor: 2 });
    const { page } = opened;
    await page.locator(".page .buttons .main").click();
    await page.waitForSelector(".calibration");
    const confirm = async () => ({ is_disabled: await page.locator(".calibration .main").isDisabled(),
      why: await page.locator(".card-first").textContent() });
    told.before = await confirm();
    await page.locator(".card-width input").fill("400");
    told.after = await confirm();
    await page.locator(".card-width button").last().click();
    await page.locator(".card-width button").first().click();
    told.card = await page.locator(".card").evaluate((card) => card.getBoundingClientRect().width);
    told.sit = await page.locator(".calibration").innerText();
    await page.locator(".calibration .main").click();
    return opened;
  };
  const small = await comeWith({ width: 600, height: 400 });
  await small.page.waitForFunction(() => /600 × 400/.test(document.querySelector(".page")?.innerText ?? ""));
  told.asked = await small.page.locator(".page").innerText();
  const opened = await comeWith({ width: 1366, height: 900 });
  const { page } = opened;
  let reloads = 0;
  await take(page, { each: async (sight, number) => {
    if (sight !== "trial" || number !== 2 || reloads > 0) return false;
    told.seen = await page.locator(".screen").evaluateAll((shown) => shown.map((one) => one.getBoundingClientRect().width));
    told.overflows = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
    reloads += 1;
    await page.reload();  // the screen stays calibrated
    return true;
  } });
  return withFiles(opened, told);
}

/** Pairs that are shown one after the other, with ties and strength; which frame of the first trial was seen when. */
async function pairs() {
  const opened = await open(`${onDisk}?participant=p001`);
  const { page } = opened;
  let frames = null;
  await take(page, { each: async (sight, number) => {
    if (sight !== "trial" || number !== 1 || frames) return false;
    frames = await page.evaluate(async () => {
      const seen = [];
      const began = performance.now();
      document.querySelector(".play").click();
      while (document.querySelector(".answers").inert && performance.now() - began < 20000) {
        const shown = [...document.querySelectorAll(".frame")].map((frame) =>
          getComputedStyle(frame.querySelector(".screen")).visibility === "visible" ? "1" : "0").join("");
        if (seen[seen.length - 1]?.shown !== shown) seen.push({ shown, at: performance.now() - began });
        await new Promise((next) => requestAnimationFrame(next));
      }
      return seen;
    });
    await page.reload();  // as if nothing had been seen
    return true;
  } });
  return withFiles(opened, { frames });
}

/**
 * Films with sound after a test of it: who counts wrong first and right then goes on, whoever is wrong twice does
 * not. In the first trial with sound, the volume is changed while the film plays.
 */
async function heard() {
  const script = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
  const begin = async (participant) => {
    const opened = await open("about:blank", { ...desktop, bypassCSP: true });
    await countTonesOf(opened.page);
    await opened.page.goto(`${onDisk}?participant=${participant}`);
    await opened.page.locator(".page .buttons .main").click();
    return opened;
  };
  const answer = async (page, number) => {
    await page.keyboard.type(String(number));
    await page.keyboard.press("Enter");
  };
  const deaf = await begin("p002");
  const first = await hearTones(deaf.page);
  await answer(deaf.page, first.count + 1);
  await deaf.page.waitForFunction(() => /once more/.test(document.querySelector("main").innerText));
  await answer(deaf.page, (await hearTones(deaf.page)).count + 1);
  await deaf.page.waitForFunction(() => !document.querySelector("#tones"));
  const turnedAway = await deaf.page.locator("main").innerText();

  const opened = await begin("p001");
  const { page } = opened;
  await page.waitForFunction(() => document.querySelector("#tones"));
  await page.evaluate(script);
  const { violations } = await page.evaluate(() => window.axe.run({ preload: false }));  // no style by a request
  const wrong = await hearTones(page);
  await answer(page, "x");
  const refused = await page.locator("#tones-wrong").innerText();
  await page.locator("#tones").fill("");
  await answer(page, wrong.count + 1);
  await page.waitForFunction(() => /once more/.test(document.querySelector("main").innerText));
  const right = await hearTones(page);
  await answer(page, right.count);
  await page.waitForFunction(() => !document.querySelector("#tones"));
  const muted = [];
  await take(page, { each: async (sight) => {
    if (sight !== "trial" || !(await page.locator("video").count())) return false;
    muted.push(...await page.locator("video").evaluateAll((all) => all.map((video) => video.muted)));
    if (muted.filter((one) => !one).length === 1)
      await page.evaluate(() => document.querySelector("video").addEventListener("playing", ({ target }) => {
        target.volume = 0.5;
        setTimeout(() => { target.muted = true; }, 100);
      }, { once: true }));
    return false;
  } });
  return withFiles(opened, { turned_away: turnedAway, counts: [first.count, wrong.count, right.count], refused,
    is_disabled: wrong.isDisabled, muted, violations: violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`),
    deaf: deaf.troubles });
}

/** What keys do on the page of consent and among answers; what a phone is told of them. */
async function singleKeys() {
  const { page, troubles } = await open(`${onDisk}?participant=p001`);
  await page.waitForSelector(".page .buttons .main");
  await page.keyboard.press("Enter");
  const shown = await page.evaluate(() => document.activeElement.matches(".page .main"));
  const isThere = await page.locator(".page .button").count();
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelectorAll(".page .button").length === 1);
  const desktopText = await page.locator("main").innerText();
  let replayed = null;
  let chosen = null;
  let back = null;
  let byDigit = null;
  let entered = {};
  const afterReload = async () => {
    await page.waitForFunction(() => !document.querySelector(".answers").inert);
    const valueOf = (place) => page.locator("fieldset.asked").nth(place).locator("input:checked").getAttribute("value");
    await page.keyboard.press("ArrowLeft");
    entered.by_arrow = [await valueOf(0)];
    await page.keyboard.press("ArrowRight");
    entered.by_arrow.push(await valueOf(0));
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press("2");
    byDigit = await valueOf(1);
    await page.reload();
    return true;
  };
  await take(page, { each: async (sight, number) => {
    if (sight !== "trial" || number !== 1 || byDigit !== null) return false;
    if (replayed !== null) return afterReload();
    await page.locator(".play").click();
    await page.waitForFunction(() => !document.querySelector(".answers").inert);
    const isAtGroup = () => page.evaluate(() => document.activeElement.matches("fieldset.asked"));
    const countChosen = () => page.locator("fieldset.asked input:checked").count();
    await page.waitForFunction(() => document.activeElement.matches("fieldset.asked"));
    await page.keyboard.press("Space");
    replayed = await page.locator(".stage.playing").count();
    chosen = await countChosen();
    await page.waitForFunction(() => !document.querySelector(".stage.playing"));
    back = await isAtGroup();
    // Enter chooses nothing, at the question or at an answer, and says what is missing.
    await page.keyboard.press("Enter");
    entered = { note: await page.locator(".answers .note").textContent(), is_at_group: await isAtGroup() };
    await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    entered.chosen = await countChosen();
    // Space chooses the answer that the participant went to; the page is loaded again before the last step.
    await page.keyboard.press("Tab");
    await page.keyboard.press("Space");
    entered.by_space = await countChosen();
    await page.keyboard.press("Space");
    entered.replayed = await page.locator(".stage.playing").count();
    await page.reload();
    return true;
  } });
  const touched = await open(`${onDisk}?participant=p001`, { ...phone, screen: { width: 800, height: 1200 } });
  await touched.page.locator(".page .buttons .main").click();
  await touched.page.waitForFunction(() => document.querySelectorAll(".page .button").length === 1);
  return { shown, is_there: isThere, replayed, chosen, back, entered, by_digit: byDigit,
    desktop_text: desktopText,
    touched_text: await touched.page.locator("main").innerText(), troubles };
}

/** How large a stimulus is, and the stage that it is on. */
async function stageSize() {
  const { page, troubles } = await open(`${onDisk}?participant=p001`);
  await takeToTrial(page);
  const widthOf = (css) => page.locator(css).first().evaluate((one) => one.getBoundingClientRect().width);
  return { screen: await widthOf(".screen"), stage: await widthOf(".stage"), troubles };
}

/** The page of thanks is loaded again. */
async function thanksAgain() {
  const opened = await open(`${onDisk}?participant=p002`);
  let saved = 0;
  opened.page.on("download", () => { saved += 1; });
  await take(opened.page);
  await withFiles(opened);
  await opened.page.waitForTimeout(500);
  const first = saved;
  await opened.page.reload();
  await opened.page.waitForSelector(".buttons.column");
  await opened.page.waitForTimeout(1500);
  const reloaded = saved;
  delete opened.saved.answers;
  await opened.page.locator(".buttons.column .button").first().click();
  for (let i = 0; i < 100 && !opened.saved.answers; i += 1) await opened.page.waitForTimeout(100);
  return { first, reloaded, asked: saved, troubles: opened.troubles };
}

/**
 * How pages look that ask much: free words beside a reference, on a laptop; seven points in
 * Japanese, on a phone. Of the folder's questionnaire, with other scales.
 */
async function crowded() {
  const files = await filesOf(folder);
  const changed = (change) => {
    const experiment = JSON.parse(files["/experiment.json"]);
    change(experiment);
    for (const session of experiment.sessions)
      session.trials = session.trials.filter(({ kind }) => kind === "rating").slice(0, 1)
        .map((trial) => ({ ...trial, number: 1, items: trial.items.slice(0, 3) }));
    return { ...files, "/experiment.js":
      Buffer.from(`globalThis.mienExperiment = ${JSON.stringify(experiment)};`) };
  };
  const firstTrial = async (server, how) => {
    const { page } = await open(`${server.base}/index.html?participant=p001`, how);
    await takeToTrial(page);
    return page;
  };
  const words = await serve(changed(({ items }) => {
    for (const item of Object.values(items)) item.words = true;
  }));
  const laptop = await firstTrial(words, desktop);
  const foot = await laptop.locator(".answers .main").boundingBox();
  const suggesting = await serve(changed(({ items }) => {
    for (const item of Object.values(items)) Object.assign(item, { words: true, suggest: ["happy", "heavy", "sad"] });
  }));
  const typed = await firstTrial(suggesting, { ...desktop, bypassCSP: true });
  const field = typed.locator(".asked.words input").first();
  await field.focus();
  await typed.keyboard.type("weary");
  const suggested = await field.evaluate((input) => ({ value: input.value, label: input.labels[0]?.textContent,
    words: [...input.list.options].map((option) => option.value) }));
  suggested.faults = await faultsOf(typed);
  const japanese = await serve(changed((experiment) => {
    experiment.language = "ja";
    experiment.settings.phones = "served";
    for (const item of Object.values(experiment.items)) item.points = 7;
  }));
  const small = await firstTrial(japanese, phone);
  const sizes = await small.evaluate(() => {
    const of = (css, told) => [...document.querySelectorAll(css)].map(told);
    return {
      letters: Math.min(...of(".choice-note", (one) => parseFloat(getComputedStyle(one).fontSize))),
      captions: of("figcaption", (one) => Math.round(one.getBoundingClientRect().height)),
      numbers: [...new Set(of("fieldset:first-of-type .choice-text", (one) => Math.round(one.getBoundingClientRect().top)))].length,
      wide: document.documentElement.scrollWidth,
    };
  });
  if (process.env.MIEN_PICTURES) {
    await laptop.screenshot({ path: join(process.env.MIEN_PICTURES, "words.png") });
    await typed.screenshot({ path: join(process.env.MIEN_PICTURES, "suggestions.png") });
    await small.screenshot({ path: join(process.env.MIEN_PICTURES, "japanese.png"), fullPage: true });
  }
  words.close();
  suggesting.close();
  japanese.close();
  return { foot: Math.round(foot.y + foot.height), suggested, ...sizes };
}

/** Words below seven points of a scale that are broken, where the language does not break them, by language and width. */
async function points() {
  const files = await filesOf(folder);
  const broken = {};
  for (const language of ["ar", "de", "en", "es", "fi", "fr"]) {
    const experiment = JSON.parse(files["/experiment.json"]);
    experiment.language = language;
    experiment.settings.phones = "served";
    for (const item of Object.values(experiment.items)) item.points = 7;
    for (const session of experiment.sessions)
      session.trials = session.trials.filter(({ kind }) => kind === "rating").slice(0, 1)
        .map((trial) => ({ ...trial, reference: "", number: 1, items: trial.items.slice(0, 3) }));
    const server = await serve({ ...files,
      "/experiment.js": Buffer.from(`globalThis.mienExperiment = ${JSON.stringify(experiment)};`) });
    const { page } = await open(`${server.base}/index.html?participant=p001`, { viewport: { width: 1024, height: 700 } });
    await takeToTrial(page);
    for (const [width, height] of [[1280, 800], [1024, 700], [390, 844]]) {
      await page.setViewportSize({ width, height });
      broken[`${language} ${width}`] = await page.evaluate(() => [...document.querySelectorAll(".choice-note")].flatMap((note) => {
        const range = document.createRange();
        // Behind a soft hyphen that is shown, a letter has the place of the hyphen first, and its own last.
        const lineOf = (at) => {
          range.setStart(note.firstChild, at);
          range.setEnd(note.firstChild, at + 1);
          return Math.round([...range.getClientRects()].at(-1)?.top ?? NaN);
        };
        return [...note.textContent.matchAll(/[^\s\u00ad]+/gu)].filter(({ index, 0: word }) =>
          lineOf(index) !== lineOf(index + word.length - 1)).map(([word]) => word);
      }));
    }
    server.close();
  }
  return broken;
}

/** Until the answers of a first trial are open. */
async function takeToTrial(page) {
  let isThere = false;
  await take(page, { each: async (sight) => {
    if (sight === "trial") isThere = true;
    if (isThere) throw "there";
    return false;
  } }).catch((why) => { if (why !== "there") throw why; });
  if (await page.locator(".grid-stage").count()) return;
  await page.locator(".play").click();
  await page.waitForFunction(() => !document.querySelector(".answers").inert, null, { timeout: 30000 });
}

/** A page in the language that the browser prefers, and one that is written from right to left. */
async function languages() {
  const arabic = { "sad-happy": ["حزين", "سعيد"] };
  const files = await filesOf(folder);
  const inLanguages = (slider) => {
    const experiment = JSON.parse(files["/experiment.json"]);
    const items = structuredClone(experiment.items);
    for (const [id, [low, high]] of Object.entries(arabic)) Object.assign(items[id], { low, high });
    for (const item of Object.values(items)) item.slider = slider;
    const demographics = structuredClone(experiment.demographics);
    Object.assign(demographics.find(({ id }) => id === "hand"), { answer: ["اليسرى", "اليمنى"], values: ["left", "right"] });
    experiment.languages = { en: {}, de: { title: "Wie geht diese Person?" }, ar: { title: "كيف", items, demographics } };
    return serve({ ...files, "/experiment.js":
      Buffer.from(`globalThis.mienExperiment = ${JSON.stringify(experiment)};`) });
  };
  const server = await inLanguages(false), sliding = await inLanguages(true);
  const start = (from, locale) => open(`${from.base}/index.html?participant=p001`, { ...desktop, locale });
  const chosen = {};
  for (const locale of ["de-AT", "fr-FR", "ar-EG", "en-GB"]) {
    const { page } = await start(server, locale);
    await page.waitForSelector(".page .main");
    chosen[locale] = await page.evaluate(() => [document.documentElement.lang, document.documentElement.dir,
      document.title, document.querySelector(".main").textContent]);
  }
  const points = (await start(server, "ar-EG")).page;
  await takeToTrial(points);
  const inputs = points.locator("fieldset.asked").first().locator("input");
  await points.locator("fieldset.asked").first().focus();
  for (let step = 0; step < 3; step += 1) await points.keyboard.press("ArrowLeft");
  const checked = await inputs.evaluateAll((all) => all.findIndex((input) => input.checked));
  await points.keyboard.press("ArrowRight");
  const back = await inputs.evaluateAll((all) => all.findIndex((input) => input.checked));
  const places = await inputs.evaluateAll((all) => all.map((input) => input.getBoundingClientRect().left));
  const poles = await points.locator("fieldset.asked").first().locator(".pole").evaluateAll((all) =>
    all.map((pole) => [pole.textContent, Math.round(pole.getBoundingClientRect().left)]));
  const faults = await faultsOf(points);
  const slides = (await start(sliding, "ar-EG")).page;
  await takeToTrial(slides);
  const slider = slides.locator('.asked input[type="range"]').first();
  await slider.focus();
  await slides.keyboard.press("ArrowLeft");
  const moved = Number(await slider.inputValue());
  const box = await slider.boundingBox();
  await slider.click({ position: { x: box.width * 0.9, y: box.height / 2 } });
  const clicked = Number(await slider.inputValue());
  const whole = await start(server, "ar-EG");
  await take(whole.page, { age: "٢٧" });
  const saved = await withFiles(whole);
  server.close();
  sliding.close();
  return { chosen, checked, back, places, poles, faults, moved, clicked, ...saved };
}

/** A set whose second stimulus is chosen as best and then, by the same key, as worst. */
async function set() {
  const { page, troubles } = await open(`${onDisk}?participant=p001`);
  await takeToTrial(page);
  const state = () => page.evaluate(() => [...document.querySelectorAll("fieldset.asked")].map((one) =>
    [...one.querySelectorAll("input")].map((input) => input.checked ? "chosen" : input.disabled ? "barred" : "free")));
  await page.keyboard.press("2");
  await page.keyboard.press("2");
  const barred = await state();
  await page.keyboard.press("3");
  return { barred, chosen: await state(), troubles };
}

/** A grid with a reference, answered little by little: what the page says is missing, and what is seen. */
async function grid() {
  const { page, troubles } = await open(`${onDisk}?participant=p001`);
  await takeToTrial(page);
  await page.waitForFunction(() => !document.querySelector(".play-film:disabled"));
  const next = page.locator(".answers .main");
  const films = page.locator(".play-film");
  const seen = (at) => page.waitForFunction((index) =>
    document.querySelectorAll(".play-film .seen-mark")[index].textContent, at);
  const notes = [];
  const say = async () => {
    await next.click();
    notes.push(await page.locator(".answers .note").textContent());
  };
  const shown = () => page.evaluate(() => [...document.querySelectorAll(".grid-stage video")]
    .map((one) => getComputedStyle(one).visibility === "visible" && !!one.offsetWidth));
  const covered = await shown();
  await say();
  await films.nth(0).click();
  await seen(0);
  await say();
  // One film, slowed down so that it lasts, is stopped by another; only one is to be seen.
  const speed = (rate) => page.evaluate((now) => {
    document.querySelectorAll(".grid-stage video")[1].playbackRate = now;
  }, rate);
  await speed(0.1);
  await films.nth(1).click();
  await films.nth(2).click();
  const during = await shown();
  await seen(2);
  const isStopped = !(await films.nth(1).locator(".seen-mark").textContent());
  await speed(1);
  await say();
  const slider = page.locator(".grid-slider input");
  await slider.nth(2).focus();
  await page.keyboard.press("End");
  await page.keyboard.press("Space");  // plays the film of the row
  await seen(3);
  await say();
  await films.nth(1).click();
  await seen(1);
  await slider.nth(0).press("Home");
  await slider.nth(1).press("ArrowLeft");
  const values = await page.locator(".grid-value").allTextContents();
  await next.click();
  await page.waitForFunction(() => !document.querySelector(".grid-stage"));
  // A film that never begins, played by its number: the trial can be left out.
  const other = (await open(`${onDisk}?participant=p002`)).page;
  await takeToTrial(other);
  await other.waitForFunction(() => !document.querySelector(".play-film:disabled"));
  await other.evaluate(() => { HTMLMediaElement.prototype.play = () => new Promise(() => {}); });
  for (let stops = 0; stops < 2; stops += 1) {
    await other.keyboard.press("2");
    await other.waitForSelector(".grid-stage.playing");
    await other.waitForFunction(() => /stopped/.test(document.querySelector(".stage-note").textContent), null,
      { timeout: 15000 });
  }
  const place = await other.locator(".trial-head h1").textContent();
  await other.locator(".play-fault .button").nth(1).click();
  await other.waitForFunction((before) => document.querySelector(".trial-head h1")?.textContent !== before, place);
  return { covered, notes, during, isStopped, values, troubles };
}

const givenStudy = () => `${JSON.parse(readFileSync(join(folder, "experiment.json"), "utf8")).study}.jzip`;

const scenarios = { reload, keys, stall, refused_phone: refusedPhone, refusal, jatos_refusal: jatosRefusal,
  accessibility, narrow_accessibility: narrowAccessibility, jatos,
  served, laboratory, prolific, pairs, calibrated, single_keys: singleKeys, stage_size: stageSize,
  thanks_again: thanksAgain, crowded, heard, languages, points, set, grid };
if (!scenarios[name]) {
  console.error(`usage: ${basename(process.argv[1])} ${Object.keys(scenarios).join("|")} FOLDER`);
  process.exit(2);
}
try {
  console.log(JSON.stringify(await scenarios[name]()));
} finally {
  await savedAll();
  await browser.close();
}
