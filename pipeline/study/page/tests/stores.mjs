// Where sessions are kept, without a browser: node --test stores.mjs
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { bundled } from "./bundled.mjs";

const { Drawer } = await bundled("questionnaire/store.ts");
const { goOnWhereJoined, storeOf } = await bundled("questionnaire/surroundings.ts");
const { jatosStore } = await bundled("questionnaire/jatos.ts");

/** What a browser keeps, of at most so many characters in all. */
class Storage {
  constructor(most = Infinity) { this.most = most; }
  setItem(key, text) {
    const others = Object.entries(this).filter(([name]) => name.startsWith("mien/") && name !== key);
    if (others.reduce((sum, [, one]) => sum + one.length, text.length) > this.most) throw new Error("full");
    this[key] = text;
  }
  getItem(key) { return this[key] ?? null; }
  removeItem(key) { delete this[key]; }
}

// Nobody has to wait for what is tried again.
const { setTimeout: later } = globalThis;
globalThis.setTimeout = (does, milliseconds) => later(does, Math.min(milliseconds, 1));

beforeEach(() => {
  globalThis.window = { name: "" };
  globalThis.localStorage = new Storage();
});

test("what a full browser cannot keep is read from the window, not what it kept before", () => {
  globalThis.localStorage = new Storage(100);
  const drawer = new Drawer("mien/a");
  for (const length of [10, 90, 200, 300]) {
    drawer.write("x".repeat(length));
    assert.equal(new Drawer("mien/a").read().length, length);
  }
  drawer.write("short again");
  assert.equal(drawer.read(), "short again");
  assert.equal(JSON.stringify(window.name).includes("xxx"), false);
  drawer.clear();
  assert.equal(drawer.read(), null);
});

test("a server that cannot answer for a while does not make a browser forget its session", async () => {
  const experiment = { design: "abc", joining: true };
  const there = {};
  globalThis.location = { replace: (path) => { there.path = path; }, href: "http://here/join/a/", search: "" };
  globalThis.sessionStorage = new Storage();
  const { rememberJoined, joinedSession } = await bundled("questionnaire/recruitment.ts");
  const answers = (...statuses) => {
    globalThis.fetch = async () => {
      const status = statuses.length > 1 ? statuses.shift() : statuses[0];
      if (status === 0) throw new TypeError("no network");
      return { status, ok: status === 200 };
    };
  };
  const person = { PROLIFIC_PID: "abc" };
  rememberJoined(experiment, person, "/s/own/");
  answers(503, 0, 200);
  void goOnWhereJoined(experiment, person);
  for (let tries = 0; tries < 200 && !there.path; tries += 1) await new Promise((done) => later(done, 10));
  assert.equal(there.path, "/s/own/");
  answers(404);
  await goOnWhereJoined(experiment, person);
  assert.equal(joinedSession(experiment, person), undefined);
});

test("nobody new begins where all places are taken", async () => {
  globalThis.location = { href: "http://here/join/a/", pathname: "/join/a/", search: "" };
  const experiment = { design: "abc", sessions: [{ participant: "" }], joining: true, enough: true };
  await assert.rejects(storeOf("served", experiment, {}, {}), (error) => error.why === "enough");
});

/** A JATOS that takes files or not. */
function fakeJatos(takesFiles) {
  const jatos = { studySessionData: {}, files: [], onLoad: (ready) => ready(), urlQueryParameters: { participant: "p001" },
    setStudySessionData: async (data) => { jatos.studySessionData = JSON.parse(JSON.stringify(data)); },
    submitResultData: async () => {},
    uploadResultFile: async (text, name) => {
      if (!takesFiles) throw new Error("no files are taken");
      jatos.files.push(name);
    } };
  return jatos;
}

for (const takesFiles of [true, false])
  test(`a JATOS that takes ${takesFiles ? "" : "no "}files lets everybody see the last page, and is asked once`, async () => {
    globalThis.jatos = fakeJatos(takesFiles);
    const experiment = { design: "abc", sessions: [{ participant: "p001" }] };
    const tables = { results: () => "", files: () => ({ "participants.csv": "a" }) };
    const store = await jatosStore(experiment, tables);
    await store.keep({ record: "consent" }, () => {});
    assert.equal(store.mustFinish(), true);
    const reloaded = await jatosStore(experiment, tables);  // in the middle of it
    assert.equal(reloaded.mustFinish(), true);
    const seen = new Set();
    await reloaded.finish((why) => seen.add(why));
    assert.deepEqual(jatos.files, takesFiles ? ["p001-participants.csv", "p001-records.json"] : []);
    assert.equal(seen.has("failed"), !takesFiles);
    assert.equal((await jatosStore(experiment, tables)).mustFinish(), false);
    assert.deepEqual(Object.keys(jatos.studySessionData.mien.records), ["consent"]);
  });
