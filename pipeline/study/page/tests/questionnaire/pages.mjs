import { readFile } from "node:fs/promises";

// What is on the page of an experiment, and when another is: `trial` is what it calls its trials.

/** "text", "load", "end", or the experiment's word for a trial. */
export const sight = (page, trial) => page.evaluate((name) => {
  if (document.querySelector(`.${name}`)) return name;
  if (document.querySelector(".page progress")) return "load";
  if (document.querySelector(".page .buttons .main")) return "text";
  return document.querySelector(".page") ? "end" : "nothing";
}, trial);

/** Tells pages apart: a new one has another element. */
export const mark = (page, trial) => page.evaluate((name) => {
  const shown = document.querySelector(`.page, .${name}`);
  if (shown && !shown.dataset.mark) shown.dataset.mark = String(Math.random());
  return shown?.dataset.mark ?? "";
}, trial);

/** Waits for another page than the one of that mark. */
export const isPast = (page, trial, before) => page.waitForFunction(([name, old]) => {
  const shown = document.querySelector(`.page, .${name}`);
  return shown && shown.dataset.mark !== old;
}, [trial, before], { timeout: 60000 });

const reading = new Set();
let isOver = false;

/** Until the files that pages have begun to save are read, or 10 seconds have passed. */
export async function savedAll() {
  let timer;
  const late = new Promise((done) => { timer = setTimeout(done, 10000); });
  await Promise.race([Promise.allSettled([...reading]), late]);
  clearTimeout(timer);
  isOver = true;
}

/** Texts of the files that the page saves, by the names of `kinds` that theirs hold. What the browser has not
 *  read when it is closed is left out: scenarios that want a file wait for it. */
export function savedTexts(page, kinds) {
  const saved = {};
  const read = async (download) => {
    let text = "";
    try {
      // Not createReadStream, whose failure no caller can catch.
      text = await readFile(await download.path(), "utf8");
    } catch (error) {
      // A page may be closed before it is known to be: scenarios that want the file miss it.
      if (isOver || page.isClosed() || /closed|canceled|ENOENT/.test(error.message)) return;
      throw error;
    }
    saved[kinds.find((kind) => download.suggestedFilename().includes(kind))] = text;
  };
  page.on("download", (download) => {
    const own = read(download);
    reading.add(own);
    own.finally(() => reading.delete(own));
  });
  return saved;
}

/**
 * Reloads the page by the function returned, once no request for motions (/live/) has been pending for a
 * moment: a reload would abort it, which the page reports as an error.
 */
export function calmReload(page) {
  const pending = new Set();
  const isMotion = (request) => /\/live\//.test(new URL(request.url()).pathname);
  page.on("request", (request) => { if (isMotion(request)) pending.add(request); });
  for (const ended of ["requestfinished", "requestfailed"]) page.on(ended, (request) => pending.delete(request));
  const pause = 20;
  return async () => {
    let quiet = 0;
    for (let waited = 0; quiet < 100 && waited < 30000; waited += pause) {
      quiet = pending.size === 0 ? quiet + pause : 0;
      await page.waitForTimeout(pause);
    }
    if (pending.size > 0) throw new Error("requests for motions are pending for 30 seconds");
    await page.reload();
  };
}
