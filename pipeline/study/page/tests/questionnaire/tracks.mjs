// Which levels the page chooses:  node tracks.mjs CASES.json
// CASES holds a list of {"procedure", "cases": [{"answers": "110…", "places": […]}]}, which C++ makes
// (tests/pipeline/study/thresholds/track_cases_test.cpp): the place of each trial until the answers are used up or the
// track has ended, and of the trial after the last answer. Prints how many trials were compared.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { bundled } from "../bundled.mjs";

const { Tracks } = await bundled("questionnaire/adaptive/tracks.ts");

/** A session of one track. */
function sessionOf(levels, count) {
  const by_level = levels.map((level) => [`film-${level}`]);
  return { participant: "p001", seed: "1", trials: Array.from({ length: count }, (_, index) =>
    ({ number: index + 1, track: 1, by_level, positive: "yes", media: [], items: [] })) };
}

const recordOf = (trial, answer) => ({ record: `trial-${trial.number}`, session: "a", comment: "", started_at: "",
  level: trial.place, responses: [{ item: "yes_no", value_raw: answer === "1" ? "yes" : "no", rt_ms: 1 }] });

let compared = 0;
for (const { procedure, cases } of JSON.parse(await readFile(process.argv[2], "utf8"))) {
  for (const { answers, places } of cases) {
    const session = sessionOf(procedure.levels, answers.length + 1);
    let tracks = new Tracks(procedure, session, {});
    const records = {};
    const chosen = [];
    for (const [index, planned] of session.trials.entries()) {
      // Halfway the page is loaded again: with the records, or with what a server tells of them.
      if (index === 7) tracks = new Tracks(procedure, session, records);
      if (index === 11) {
        tracks = new Tracks(procedure, session, {}, Object.fromEntries(Object.entries(records).map(([name, record]) =>
          [name, { place: record.level, positive: record.responses[0].value_raw === "yes" }])));
      }
      const trial = tracks.next(planned);
      if (!trial) break;
      assert.deepEqual(trial.media, [`film-${procedure.levels[trial.place]}`]);
      assert.equal(trial.level, procedure.levels[trial.place]);
      chosen.push(trial.place);
      if (index === answers.length) break;
      records[`trial-${trial.number}`] = recordOf(trial, answers[index]);
      tracks.note(records[`trial-${trial.number}`]);
    }
    assert.deepEqual(chosen, places, `${procedure.method}: ${answers}`);
    compared += places.length;
  }
}
console.log(JSON.stringify({ compared }));
