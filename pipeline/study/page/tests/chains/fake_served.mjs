// The page behind a server that fails, hands out steps, and refuses records: node --test fake_served.mjs
import assert from "node:assert/strict";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { opener } from "../live/opened.mjs";
import { openBrowser } from "../questionnaire/participant.mjs";
import { chainExperiment, dimensions, fakePage, sharedExperiment } from "./fake_page.mjs";
import { fakeServer } from "./fake_server.mjs";
import { downloadsOf, take } from "./participant.mjs";

let browser;
let folder;
before(async () => {
  browser = await openBrowser();
  folder = await mkdtemp(join(tmpdir(), "mien-chains-"));
});
after(async () => {
  await browser.close();
  await rm(folder, { recursive: true });
});

/** The page with an experiment behind a server; `each` as `take` has it. */
async function taken(experiment, how, each) {
  await fakePage(folder, experiment);
  const server = await fakeServer(folder, experiment, how);
  const opened = await opener(browser, downloadsOf)(`${server.base}/index.html`);
  try {
    await take(opened.page, { each: (seen, title) => each(opened, seen, title) });
    return { ...server, text: await opened.page.locator("main").innerText() };
  } finally {
    server.close();
    await opened.page.context().close();
  }
}

const numberOf = (name) => Number(name.slice("trial-".length));

/** A step that somebody else's answers have led to. */
const handedOut = (name, asked) => ({ word: asked === 1 ? "sad" : "proud", chain: numberOf(name), step: 7, person: 2,
  point: [0.1 * (numberOf(name) % 9), 0.5, 0.25], dimension: 1, slider: { start: 0.25, reversed: true } });

test("steps come from the server, which may fail, be slow, or have given one to somebody else", async () => {
  const said = [];
  let reloads = 0;
  let waiting = Promise.resolve("");
  const { records, asked, given, sessions } = await taken(sharedExperiment("gibbs"), {
    stepAt: (name, count) => (name === "trial-3" && count === 1 ? { status: 503 }
      : name === "trial-7" && count === 1 ? { status: 503, error: "busy" }
      : handedOut(name, name === "trial-5" || name === "trial-7" ? 1 : count)),
    refuses: (name, count) => (name === "trial-4" && count === 1 ? "taken" : ""),
  }, async ({ page, reload }, seen) => {
    if (seen !== "chains") return false;
    said.push(await page.locator(".chain-status").textContent());
    const place = await page.locator(".progress").textContent();
    if (place === "4 of 12")
      waiting = page.waitForSelector(".waiting").then((note) => note.textContent());
    if (place !== "3 of 12" || reloads) return false;
    reloads += 1;
    await reload();
    return true;
  });
  assert.equal(sessions.size, 1);
  // Practice is planned: nothing is asked for it.
  assert.deepEqual(Object.keys(asked).map(numberOf), [3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14]);
  assert.deepEqual([3, 4, 5, 6, 7].map((number) => asked[`trial-${number}`]), [2, 2, 2, 1, 2]);
  assert.equal(await waiting, "Please wait a moment. Others are still answering, and your next one depends on their answers.");
  assert.equal(given["trial-4"], 2);
  assert.ok(said.includes("Someone else has already completed that one, so here is another. Thank you for your patience."));
  assert.equal(said.filter((one) => /reloaded/.test(one)).length, 1);
  const made = (number) => records[`trial-${number}`].chain;
  assert.equal(made(1).person, 0);
  const { slider, ...shown } = handedOut("trial-6", 1);
  const { value, moves, ...kept } = made(6);
  assert.deepEqual(kept, { ...shown, start: slider.start, reversed: slider.reversed, attempt: 1 });
  assert.ok(moves >= 1);
  assert.ok(Math.abs(value - (0.1 + 0.8 * (Math.round(((value - 0.1) / 0.8) * 1000) / 1000))) < 1e-12);
  assert.equal(made(4).word, "proud");  // what was handed out anew
  assert.equal(made(4).attempt, 2);
  assert.equal(made(5).attempt, 2);
  assert.deepEqual(made(5).point, handedOut("trial-5", 1).point);
  assert.ok(records.ending);
});

test("where all chains are complete, the session ends early", async () => {
  const titles = [];
  const { records, text } = await taken(sharedExperiment("gibbs"), {
    stepAt: (name, count) => (numberOf(name) < 5 ? handedOut(name, count) : null),
  }, async ({ page }, seen, title) => {
    titles.push(title === "That was the last question" ? await page.locator("main").innerText() : title);
    return false;
  });
  assert.match(titles.find((one) => /last question/.test(one)), /Everything has been completed by now/);
  assert.ok(records["trial-4"].chain);
  for (let number = 5; number <= 14; number += 1) {
    assert.equal(records[`trial-${number}`].chain, undefined);
    assert.deepEqual(records[`trial-${number}`].responses, []);
  }
  assert.ok(records.ending);
  assert.match(text, /Thank you/);
});

/** The points of the motions that a step shows, from left to right. */
function pointsShown({ point, dimension, start, proposal, proposal_first: isFirst }) {
  if (dimension === undefined) return isFirst ? [proposal, point] : [point, proposal];
  const { low, high } = dimensions[dimension];
  const share = Math.round(1000 * start) / 1000;
  return [point.map((one, d) => (d === dimension ? low + share * (high - low) : one))];
}

test("own chains outlive a reload behind a server, which sends no records back", async () => {
  for (const method of ["gibbs", "mcmc"]) {
    let reloads = 0;
    const shown = {};
    const { records, asked } = await taken(chainExperiment(method), {}, async ({ page, reload }, seen) => {
      if (seen !== "chains") return false;
      const place = await page.locator(".progress").textContent();
      shown[place] = await page.evaluate((count) => globalThis.mienMade.slice(-count), method === "gibbs" ? 1 : 2);
      if (place !== "5 of 12" || reloads) return false;
      reloads += 1;
      await reload();
      return true;
    });
    assert.deepEqual(asked, {});
    assert.equal(reloads, 1);
    const made = (number) => records[`trial-${number}`].chain;
    assert.equal(made(7).attempt, 2);
    for (let number = 3; number <= 14; number += 1)
      assert.deepEqual(shown[`${number - 2} of 12`].map(({ values }) => values), pointsShown(made(number)));
    // Trials 3, 5 and 7 are steps of one chain.
    for (const [from, to] of [[3, 5], [5, 7]]) {
      const { point, dimension, value, proposal, chose_proposal: isChosen } = made(from);
      const next = method === "gibbs" ? point.map((one, d) => (d === dimension ? value : one)) : isChosen ? proposal : point;
      assert.deepEqual(made(to).point, next);
    }
  }
});

test("whoever withdraws leaves nothing of the chains in the browser", async () => {
  const experiment = chainExperiment("gibbs");
  await fakePage(folder, experiment);
  const server = await fakeServer(folder, experiment);
  const { page } = await opener(browser, downloadsOf)(`${server.base}/index.html`);
  const kept = () => page.evaluate(() => Object.keys(localStorage).filter((key) => /chains|begun/.test(key)).length);
  class Enough extends Error {}
  await assert.rejects(take(page, { each: async (seen) => {
    if (seen === "chains" && (await page.locator(".progress").textContent()) === "2 of 12") throw new Enough();
    return false;
  } }), Enough);
  assert.equal(await kept(), 2);
  await page.locator(".withdrawal > .button").click();
  await page.locator("dialog .button").nth(1).click();
  await page.waitForFunction(() => /have been deleted/.test(document.querySelector("main").innerText));
  assert.equal(await kept(), 0);
  server.close();
  await page.context().close();
});

test("what was answered as the window was closed is sent again, and a step that was taken meanwhile is asked anew", async () => {
  let reloads = 0;
  const { records, given } = await taken(sharedExperiment("gibbs"), {
    stepAt: handedOut,
    refuses: (name, count) => (name === "trial-5" && count === 1 ? "taken" : ""),
  }, async ({ page }, seen) => {
    if (seen !== "chains" || (await page.locator(".progress").textContent()) !== "3 of 12" || reloads) return false;
    reloads += 1;
    // The request is lost on its way, and the window closed.
    await page.route("**/records/trial-5", (route) => route.abort());
    await page.locator(".slider-control input").press("ArrowRight");
    await page.locator(".slider-control .main").click();
    await page.waitForSelector(".waiting");
    assert.match(await page.locator(".waiting").textContent(), /connection was lost/);
    await page.unroute("**/records/trial-5");
    await page.reload();
    return true;
  });
  assert.equal(given["trial-5"], 2);
  assert.equal(records["trial-5"].chain.attempt, 2);
  assert.equal(records["trial-5"].chain.word, "proud");
});
