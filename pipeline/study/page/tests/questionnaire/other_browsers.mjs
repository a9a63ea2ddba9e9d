// Takes an exported questionnaire in a browser other than Chromium, by real clicks, with a reload on the way.
//   node other_browsers.mjs firefox|webkit FOLDER PACKAGES PROGRAM
// prints the answers and what the browser is as JSON. PACKAGES holds node_modules with puppeteer-core, which drives
// Firefox by WebDriver BiDi, and selenium-webdriver, which drives WebKitGTK's MiniBrowser by WebKitWebDriver; PROGRAM is
// the browser.
import { spawn } from "node:child_process";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { bundled } from "../bundled.mjs";
import { filesOf, serve } from "../http_server.mjs";

const [name, folder, packages, program] = process.argv.slice(2);
const required = createRequire(join(resolve(packages), "package.json"));
const { answersCsv, participantsCsv } = await bundled("questionnaire/rows.ts");
const pause = (ms) => new Promise((done) => setTimeout(done, ms));

/** `run` evaluates the body of a function in the page. */
async function firefox() {
  const puppeteer = required("puppeteer-core");
  const browser = await puppeteer.launch({ browser: "firefox", executablePath: program, headless: true,
    args: ["--no-remote"] });
  const page = await browser.newPage();
  await page.setViewport({ width: 1366, height: 768 });
  return {
    open: (url) => page.goto(url),
    run: (body) => page.evaluate(`(() => { ${body} })()`),
    click: (css) => page.click(css),
    type: (css, text) => page.type(css, text),
    hold: async (key, ms) => {
      await page.keyboard.down(key);
      await pause(ms);
      await page.keyboard.up(key);
    },
    reload: () => page.reload(),
    close: () => browser.close(),
  };
}

async function webkit() {
  const { Builder, By, Key } = required("selenium-webdriver");
  const port = 20000 + (process.pid % 20000);
  // The browser's own sandbox needs rights that containers do not give.
  const driver = spawn("xvfb-run", ["-a", "-s", "-screen 0 1500x1000x24", "WebKitWebDriver", `--port=${port}`],
    { stdio: "ignore", detached: true, env: { ...process.env, WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: "1" } });
  const options = { browserName: "MiniBrowser", "webkitgtk:browserOptions":
    { binary: program, args: ["--automation"] } };
  let browser;
  for (let tries = 0; !browser; tries += 1) {
    await pause(500);
    try {
      browser = await new Builder().usingServer(`http://127.0.0.1:${port}`).withCapabilities(options).build();
    } catch (error) {
      if (tries === 40) throw error;
    }
  }
  await browser.manage().window().setRect({ width: 1366, height: 900, x: 0, y: 0 });
  const at = (css) => browser.findElement(By.css(css));
  return {
    open: (url) => browser.get(url),
    run: (body) => browser.executeScript(body),
    click: async (css) => (await at(css)).click(),
    type: async (css, text) => (await at(css)).sendKeys(text),
    hold: async (_key, ms) => {
      await browser.actions({ async: true }).keyDown(Key.ARROW_RIGHT).pause(ms).keyUp(Key.ARROW_RIGHT).perform();
    },
    reload: () => browser.navigate().refresh(),
    close: async () => {
      await browser.quit();
      try {
        process.kill(-driver.pid);
      } catch { /* it has ended */ }
    },
  };
}

const browser = await { firefox, webkit }[name]();

async function until(condition) {
  for (let tries = 0; tries < 600; tries += 1) {
    if (await browser.run(`return !!(${condition})`)) return;
    await pause(100);
  }
  throw new Error(`${condition}: not within a minute; the page: ${await browser.run("return document.body.innerText")}`);
}

const marked = "document.querySelector('.page, .trial')?.dataset.mark";

/** Holds an arrow key while the film plays; where it stops and begins anew, once more. */
async function rateWhilePlaying() {
  const isOver = "document.activeElement?.matches('.answers .main')";
  while (!(await browser.run(`return !!(${isOver})`))) {
    await until(`document.querySelector('.stage.playing video')?.currentTime > 0.6 || !document.querySelector('.play').hidden || ${isOver}`);
    if (await browser.run("return !document.querySelector('.play').hidden")) await browser.click(".play");
    else await browser.hold("ArrowRight", 400);
    await until(`!document.querySelector('.play').hidden || ${isOver} || document.querySelector('.stage.playing video')?.currentTime < 0.6`);
  }
}

async function take() {
  let reloads = 0;
  for (let pages = 0; pages < 60; pages += 1) {
    await until("document.querySelector('.page, .trial')");
    await browser.run("document.querySelector('.page, .trial').dataset.mark = 'seen'");
    const sight = await browser.run(`return document.querySelector('.trial') ? 'trial'
      : document.querySelector('.page progress') ? 'load' : document.querySelector('.buttons.column') ? 'end' : 'text'`);
    if (sight === "end") return reloads;
    if (sight === "text") {
      if (await browser.run("return !!document.querySelector('#about-age')")) await browser.type("#about-age", "27");
      await browser.click(".page .buttons .main");
    } else if (sight === "trial") {
      if (await browser.run("return !!document.querySelector('.stage')")) {
        await until("!document.querySelector('.play').hidden");
        await browser.click(".play");
        if (await browser.run("return document.querySelector('.trial-head h1').textContent.startsWith('2 ')") && !reloads) {
          await until("document.querySelector('.stage.playing')");
          await pause(300);
          reloads += 1;
          await browser.reload();
          continue;
        }
        if (await browser.run("return !!document.querySelector('.marker')")) {
          await rateWhilePlaying();
          await browser.click(".answers .main");
          await until(`${marked} !== 'seen'`);
          continue;
        }
        // On a busy machine, WebKit may stop playing and not tell it.
        await until(`(() => {
          const play = document.querySelector('.play');
          const isLocked = document.querySelector('.answers').inert;
          if (isLocked && !play.hidden && !document.querySelector('.stage.playing')) play.click();
          return !isLocked;
        })()`);
      }
      await browser.run(`const wanted = document.querySelector('.question-text').textContent;
        for (const asked of document.querySelectorAll('fieldset.asked')) {
          const inputs = [...asked.querySelectorAll('input')];
          inputs[/leftmost/.test(wanted) ? 0 : /rightmost/.test(wanted) ? inputs.length - 1 : 1].click();
        }`);
      await browser.click(".answers .main");
    }
    await until(`${marked} !== 'seen'`);
  }
  throw new Error("the questionnaire has no end");
}

const server = await serve(await filesOf(resolve(folder)));
try {
  await browser.open(`${server.base}/index.html?participant=p002`);
  const reloads = await take();
  const agent = await browser.run("return navigator.userAgent");
  const kept = JSON.parse(await browser.run(
    "return Object.entries(localStorage).find(([key]) => key.endsWith('/session'))[1]"));
  const experiment = JSON.parse((await filesOf(resolve(folder)))["/experiment.json"]);
  const session = experiment.sessions.find(({ participant }) => participant === kept.participant);
  console.log(JSON.stringify({ agent, reloads, answers: answersCsv(experiment, session, kept.records),
    participant: participantsCsv(experiment, session, kept.records) }));
} finally {
  server.close();
  await browser.close();
}
