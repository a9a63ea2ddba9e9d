// Recruitment and screening without a server: what the page decides itself.  node --test recruitment.mjs
import assert from "node:assert/strict";
import { test } from "node:test";

import { bundled } from "../bundled.mjs";

const { completedEnd, destinationOf, keptParameters, parametersOf, personOf } = await bundled("questionnaire/recruitment.ts");
const { screeningFault } = await bundled("questionnaire/screening.ts");
const { hasCountedTones, toneCount } = await bundled("questionnaire/tone_count.ts");

const recruitment = { url_parameters: ["id", "group"], pseudonymise: true, most_failed_checks: 1,
  ends: { completed: { address: "https://done", code: "D" } } };

test("keeps the parameters that are named, in one line, of limited length", () => {
  const given = new URLSearchParams({ id: ` a\n${"b".repeat(300)}`, group: "", other: "x" });
  const kept = parametersOf({ design: "d", recruitment }, given);
  assert.deepEqual(Object.keys(kept), ["id"]);
  assert.equal([...kept.id].length, 200);
  assert.match(kept.id, /^a b+$/);
});

test("hashes the same value of one study alike, and of another study differently", async () => {
  const hash = async (design, id) => (await keptParameters({ design, recruitment }, { id }, false)).id;
  assert.equal(await hash("d", "x"), await hash("d", "x"));
  assert.notEqual(await hash("d", "x"), await hash("d", "y"));
  assert.notEqual(await hash("d", "x"), await hash("e", "x"));
  assert.match(await hash("d", "x"), /^[0-9a-f]{32}$/);
  assert.deepEqual(await keptParameters({ design: "d", recruitment }, { id: "x" }, true), { id: "x" });
});

test("tells people apart by what names them in the link, and shows it to nobody", () => {
  const who = (link) => personOf({ design: "d", recruitment }, new URLSearchParams(link));
  const first = who("PROLIFIC_PID=5f01&SESSION_ID=a&STUDY_ID=s");
  assert.match(first, /^[0-9a-f]{16}$/);
  assert.equal(who("SESSION_ID=b&PROLIFIC_PID=5f01"), first);
  assert.notEqual(who("PROLIFIC_PID=5f02&SESSION_ID=a"), first);
  assert.equal(who(""), "");
  assert.equal(who("other=1&participant=p001"), "");
  assert.notEqual(who("id=1&group=2"), who("id=2&group=2"));
  assert.notEqual(who("SESSION_ID=a"), who("SESSION_ID=b"));
  assert.equal(personOf({ design: "d" }, new URLSearchParams("id=1")), "", "only what the study keeps");
});

const session = { trials: [1, 2, 3].map((number) => ({ number, expected: "5", practice: number === 1 })) };
const recordsWith = (...answers) => Object.fromEntries(answers.map((value, index) =>
  [`trial-${index + 1}`, { responses: [{ item: "a", value_raw: value }] }]));

test("counts failed attention checks outside practice", () => {
  assert.equal(completedEnd(recruitment, session, recordsWith(1, 5, 5)), "completed");
  assert.equal(completedEnd(recruitment, session, recordsWith(1, 1, 5)), "completed");
  assert.equal(completedEnd(recruitment, session, recordsWith(5, 1, 1)), "failed_attention");
});

test("sends whoever failed where those who completed go, unless there is an address of its own", () => {
  assert.equal(destinationOf(recruitment, "failed_attention").code, "D");
  const own = { ...recruitment, ends: { ...recruitment.ends, failed_attention: { address: "https://x", code: "F" } } };
  assert.equal(destinationOf(own, "failed_attention").code, "F");
  assert.equal(destinationOf(recruitment, "refused"), undefined);
});

const screening = { window: [800, 600], refresh_hz: 50, questions: [
  { id: "age", accept: { from: 18, to: 65 } }, { id: "eyes", accept: ["yes"] }, { id: "sex" }] };
const record = (age, eyes, more = {}) => ({ viewport_width: 800, viewport_height: 600, refresh_hz: 60,
  responses: [{ item: "age", value_raw: age }, { item: "eyes", value_raw: eyes }, { item: "sex", value_raw: "f" }],
  ...more });

test("screens by answers, both ends of a range included, by window and by refresh rate", () => {
  assert.equal(screeningFault(screening, record(18, "yes")), "");
  assert.equal(screeningFault(screening, record(65, "yes")), "");
  assert.equal(screeningFault(screening, record(17.5, "yes")), "answer");
  assert.equal(screeningFault(screening, record(66, "yes")), "answer");
  assert.equal(screeningFault(screening, record(30, "no")), "answer");
  assert.equal(screeningFault(screening, record(30, "yes", { viewport_width: 799 })), "window");
  assert.equal(screeningFault(screening, record(30, "yes", { refresh_hz: 49 })), "refresh_hz");
  assert.equal(screeningFault(screening, record(30, "yes", { refresh_hz: null })), "");
  assert.equal(screeningFault(screening, record(30, "yes", { responses: [] })), "answer");
  assert.equal(screeningFault(undefined, undefined), "");
});

// The same numbers as in tests/pipeline/study/questionnaire/service/screening_test.cpp.
test("plays three to seven tones, as many as the server expects", () => {
  assert.deepEqual(["b1", "b2", "3f9c-77"].map((session) => [toneCount(session, 1), toneCount(session, 2)]), [[5, 3], [5, 7], [3, 5]]);
  const counts = Array.from({ length: 500 }, (_, index) => toneCount(`session-${index}`, 1));
  for (const count of [3, 4, 5, 6, 7])
    assert.ok(counts.filter((one) => one === count).length > 60, `${count} tones are seldom`);
  assert.deepEqual([...new Set(counts)].sort(), [3, 4, 5, 6, 7]);
});

test("screens by the count of tones, of which one must be right", () => {
  const first = toneCount("s", 1), second = toneCount("s", 2);
  const given = (...counts) => ({ session: "s", viewport_width: 10, viewport_height: 10, refresh_hz: null,
    responses: counts.map((value, index) => ({ item: `tones_${index + 1}`, value_raw: value })) });
  assert.equal(screeningFault({ sound: true }, given(first)), "");
  assert.equal(screeningFault({ sound: true }, given(first + 1, second)), "");
  assert.equal(screeningFault({ sound: true }, given(first + 1)), "sound");
  assert.equal(screeningFault({ sound: true }, given(first + 1, second + 1)), "sound");
  assert.equal(screeningFault({ sound: true }, given()), "sound");
  assert.equal(screeningFault({}, given()), "");
  assert.ok(!hasCountedTones("other", given(toneCount("other", 1) + 1).responses));
});
