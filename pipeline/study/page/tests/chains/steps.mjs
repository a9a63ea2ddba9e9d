// What follows from a plan and the answers to it, and the table of it: node --test steps.mjs
import assert from "node:assert/strict";
import { test } from "node:test";
import { bundled } from "../bundled.mjs";
import { chainExperiment, dimensions } from "./fake_page.mjs";

const { passesCheck, plannedStep, recordOf } = await bundled("chains/steps.ts");
const { stepsCsv } = await bundled("chains/rows.ts");
const { checkedChains } = await bundled("chains/experiment.ts");

const random = (seed) => () => {
  seed = (seed * 1103515245 + 12345) % 2 ** 31;
  return seed / 2 ** 31;
};

/** The step of one trial of MCMC from a point, with these deviates. */
function proposalFrom(point, normals, deviation, range) {
  const settings = { method: "mcmc", dimensions: point.map((_, d) => ({ name: `d${d}`, ...range })), deviation };
  const trial = { number: 1, practice: false, word: "sad", chain: 1, step: 0, normals, proposal_first: true };
  return plannedStep(settings, { starts: { "sad/1": point }, trials: [trial] }, trial, {}).proposal;
}

/** Answers a session by what `answerOf` says of each step; the records and the steps by the trials' names. */
function answered(experiment, answerOf, until = Infinity) {
  const session = experiment.sessions[0];
  const records = {}, steps = {};
  for (const trial of session.trials.filter(({ number }) => number < until)) {
    const name = `trial-${trial.number}`;
    steps[name] = plannedStep(experiment.chains, session, trial, records);
    records[name] = { chain: recordOf(steps[name], answerOf(steps[name], trial), 1) };
  }
  return { session, records, steps };
}

test("proposals are a point plus deviates of the size of the range, folded into it", () => {
  const near = (found, expected) => found.forEach((one, d) => assert.ok(Math.abs(one - expected[d]) < 1e-12, `${found}`));
  near(proposalFrom([0.5, 0.5], [1, -1], 0.2, { low: 0, high: 1 }), [0.7, 0.3]);
  near(proposalFrom([0.5, 0.5], [1, -1], 0.2, { low: -1, high: 1 }), [0.9, 0.1]);
  near(proposalFrom([0.9, 0.1], [1, -1], 0.2, { low: 0, high: 1 }), [0.9, 0.1]);  // 1.1 and −0.1
  near(proposalFrom([0.5, 0.5], [6, -6], 0.3, { low: 0, high: 1 }), [0.3, 0.7]);  // 2.3 and −1.3
  near(proposalFrom([3], [1], 0.75, { low: 2, high: 4 }), [3.5]);  // 4.5
});

test("any deviate leads into the range, to where a wave of triangles leads", () => {
  const next = random(3);
  for (let i = 0; i < 5000; i += 1) {
    const low = 4 * next() - 2, width = 0.1 + 2 * next(), at = low + width * next(), normal = 12 * next() - 6;
    const [found] = proposalFrom([at], [normal], 0.4, { low, high: low + width });
    const turns = (at + 0.4 * width * normal - low) / width;
    const wave = Math.abs(Math.asin(Math.sin(Math.PI * (turns - 0.5))) / Math.PI + 0.5);
    assert.ok(found >= low - 1e-12 && found <= low + width + 1e-12);
    assert.ok(Math.abs(found - (low + width * wave)) < 1e-9, `${at} ${normal}`);
  }
});

test("an attention check is passed at the end or the side that it asks for", () => {
  const chains = { dimensions: [{ name: "d0", low: 0.2, high: 0.6 }] };
  const slid = (value, reversed, expected) => passesCheck({ dimension: 0, value, reversed }, expected, chains);
  assert.ok(slid(0.2, false, "left"));
  assert.ok(slid(0.219, false, "left"));
  assert.ok(!slid(0.221, false, "left"));
  assert.ok(!slid(0.2, false, "right"));
  assert.ok(slid(0.6, true, "left"));
  assert.ok(slid(0.2, true, "right"));
  for (const first of [true, false])
    for (const chosen of [true, false]) {
      const record = { proposal: [0.3], proposal_first: first, chose_proposal: chosen };
      assert.equal(passesCheck(record, "left", chains), first === chosen);
      assert.equal(passesCheck(record, "right", chains), first !== chosen);
    }
});

test("attention checks begin at their own start, lead nowhere, and are not told to the server", () => {
  const experiment = chainExperiment("gibbs");
  const [session] = experiment.sessions;
  const { length } = session.trials;
  session.starts["check/1"] = [0.11, 0.22, 0.33];
  const check = (number, step) => ({ number, block: "main", kind: "chain", practice: false, media: [], word: "check",
    chain: 1, step, dimension: 1, slider: { start: 0.5, reversed: false }, expected: "right" });
  session.trials.push(check(length + 1, 0), check(length + 2, 1));
  const { records, steps } = answered(experiment, () => ({ value: 0.9, moves: 1 }));
  for (const number of [length + 1, length + 2]) {
    assert.deepEqual(steps[`trial-${number}`].point, [0.11, 0.22, 0.33]);
    assert.equal(steps[`trial-${number}`].expected, "right");
    assert.ok(!("expected" in records[`trial-${number}`].chain));
  }
  const rows = stepsCsv(experiment, session, Object.fromEntries(Object.entries(records).map(([name, record]) =>
    [name, { ...record, record: name, session: "s", started_at: "" }]))).trim().split(/\r?\n/).map((row) => row.split(","));
  const columnOf = (name) => rows[0].indexOf(name);
  assert.deepEqual(rows.slice(1).map((row) => row[columnOf("is_check")]),
    session.trials.map(({ expected }) => (expected ? "1" : "0")));
  assert.ok(rows.slice(1).every((row) => (row[columnOf("passed")] === "") === (row[columnOf("is_check")] === "0")));
});

test("a chain of Gibbs sampling changes the coordinate that was free, and no other chain", () => {
  const experiment = chainExperiment("gibbs");
  const { session, records, steps } = answered(experiment, (_, { number }) => ({ value: number / 100, moves: 1 }));
  assert.deepEqual(steps["trial-3"].point, session.starts["sad/1"]);
  const [x, y, z] = session.starts["sad/1"];
  assert.deepEqual(steps["trial-5"].point, [0.03, y, z]);
  assert.deepEqual(steps["trial-7"].point, [0.03, 0.05, z]);
  assert.deepEqual(steps["trial-8"].point, [0.04, 0.06, session.starts["sad/2"][2]]);
  assert.deepEqual(steps["trial-9"].point, session.starts["proud/1"]);
  assert.notDeepEqual(x, 0.03);
  // Practice is of the same word and chain, and begins elsewhere.
  assert.deepEqual(steps["trial-1"].point, session.starts["practice/1"]);
  assert.deepEqual(steps["trial-2"].point, [0.01, ...session.starts["practice/1"].slice(1)]);
  // The plan says what is free, and where the slider stands.
  const trial = session.trials[4];
  assert.equal(steps["trial-5"].dimension, 1);
  assert.deepEqual(records["trial-5"].chain, { word: "sad", chain: 1, step: 1, person: 0, point: [0.03, y, z], dimension: 1,
    start: trial.slider.start, reversed: trial.slider.reversed, value: 0.05, moves: 1, attempt: 1 });
});

test("a chain of MCMC moves to the proposals that were chosen", () => {
  const experiment = chainExperiment("mcmc");
  const { session, steps, records } = answered(experiment, (_, { number }) => ({ chose_proposal: number % 4 !== 3, moves: 0 }));
  assert.deepEqual(steps["trial-3"].point, session.starts["sad/1"]);
  assert.deepEqual(steps["trial-5"].point, session.starts["sad/1"]);  // trial 3 kept the point
  assert.deepEqual(steps["trial-7"].point, steps["trial-5"].proposal);
  assert.deepEqual(steps["trial-6"].point, steps["trial-4"].proposal);
  for (const { proposal } of Object.values(steps))
    proposal.forEach((one, d) => assert.ok(one >= dimensions[d].low && one <= dimensions[d].high));
  assert.deepEqual(records["trial-4"].chain, { word: "sad", chain: 2, step: 0, person: 0, point: session.starts["sad/2"],
    proposal: steps["trial-4"].proposal, proposal_first: false, chose_proposal: true, moves: 0, attempt: 1 });
});

test("a reload finds every chain where it was, whatever the order of the records", () => {
  for (const method of ["gibbs", "mcmc"]) {
    const experiment = chainExperiment(method);
    const next = random(5);
    const { session, steps, records } = answered(experiment,
      () => (method === "gibbs" ? { value: next(), moves: 2 } : { chose_proposal: next() < 0.5, moves: 0 }));
    const turned = Object.fromEntries(Object.entries(JSON.parse(JSON.stringify(records))).reverse());
    for (const trial of session.trials)
      assert.deepEqual(plannedStep(experiment.chains, session, trial, turned), steps[`trial-${trial.number}`]);
  }
});

test("steps are rows, with what does not apply left empty", () => {
  const rows = (method, answerOf) => {
    const experiment = chainExperiment(method, { simulated: true });
    const { session, records } = answered(experiment, answerOf, 6);
    for (const [name, record] of Object.entries(records))
      Object.assign(record, { record: name, session: "ab12", started_at: "2026-11-29T10:00:00.000Z", trial_ms: 1234 });
    delete records["trial-4"];
    records["trial-12"] = { record: "trial-12", session: "ab12", responses: [] };  // left out, as all chains were complete
    return stepsCsv(experiment, session, records).trim().split("\n").slice(1);
  };
  const gibbs = rows("gibbs", (_, { number }) => ({ value: number / 100, moves: number }));
  assert.equal(gibbs.length, 4);
  assert.equal(gibbs[1], "p001,ab12,c1,1,2,1,0,,1,sad,1,1,0,0.01 0.38 0.4,arms,0.02,0.75,1,,,,2,1234,2026-11-29T10:00:00.000Z");
  const mcmc = rows("mcmc", () => ({ chose_proposal: false, moves: 0 }));
  assert.match(mcmc[3], /^p001,ab12,c1,1,5,0,0,,1,sad,1,1,0,0\.5 0\.62 0\.64\d*,,,,,0\.\d+ 0\.\d+ 0\.\d+,1,0,0,1234,/);
});

test("other languages replace the words alone", () => {
  const german = { title: "Wörter", chains: { words: { sad: "traurig" } } };
  const checked = checkedChains(chainExperiment("gibbs", { languages: { en: {}, de: german } }));
  assert.deepEqual(checked.languages.de.chains.words, { sad: "traurig" });
  assert.deepEqual(checked.languages.de.chains.dimensions, dimensions);
  assert.equal(checked.languages.en.chains.words.sad, "sad");
  assert.throws(() => checkedChains({ format: "mien-matching-1" }), /export it again/);
});
