// Where sessions are kept, without a browser: node --test stores.mjs
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { bundled } from "./bundled.mjs";

const { Drawer, servedStore } = await bundled("questionnaire/store.ts");
const { goOnWhereJoined } = await bundled("questionnaire/surroundings.ts");
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
  window.name = "";  // the tab was closed
  assert.equal(drawer.read().length, 90, "what could be kept");
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
  const notes = [];
  globalThis.document = { getElementById: () => ({ append: (note) => notes.push(note) }),
    createElement: () => ({ setAttribute() {}, append() {} }) };
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
  void goOnWhereJoined(experiment, person, { saveFailed: "it is tried again" });
  for (let tries = 0; tries < 200 && !there.path; tries += 1) await new Promise((done) => later(done, 10));
  assert.equal(there.path, "/s/own/");
  assert.equal(notes[0].textContent, "it is tried again");
  answers(404);
  await goOnWhereJoined(experiment, person, {});
  assert.equal(joinedSession(experiment, person), undefined);
});

test("a page says that it is open, once a minute, until half an hour after the last record or its end", async () => {
  const beats = new Set(), asked = [];
  let now = 0, hidden = false;
  globalThis.setInterval = (does) => { beats.add(does); return does; };
  globalThis.clearInterval = (does) => beats.delete(does);
  globalThis.fetch = async (address, how) => {
    asked.push(how?.method);
    return { ok: true, status: 200, json: async () => ({}) };
  };
  globalThis.document = { get visibilityState() { return hidden ? "hidden" : "visible"; } };
  const { Date: real } = globalThis;
  globalThis.Date = class extends real { static now() { return now; } };
  const minutes = (count) => {
    asked.length = 0;
    for (let minute = 0; minute < count; minute += 1) { now += 60000; for (const beat of beats) beat(); }
    return asked.filter((method) => method === "HEAD").length;
  };
  try {
    const experiment = { design: "abc", sessions: [{ participant: "p001" }], kept: [], browser: "" };
    const store = servedStore(experiment, "/s/a/");
    assert.equal(minutes(10), 10);
    assert.equal(minutes(60), 20, "half an hour");
    await store.keep({ record: "consent" }, () => {});
    assert.equal(minutes(5), 5);
    hidden = true;
    assert.equal(minutes(5), 0);
    hidden = false;
    await store.finish(() => {});
    assert.equal(minutes(5), 0);
    servedStore({ ...experiment, browser: "of somebody else" }, "/s/b/");
    servedStore({ ...experiment, ended: "screened_out" }, "/s/c/");
    assert.equal(minutes(5), 0);
  } finally {
    globalThis.Date = real;
  }
});

/** A JATOS that takes files or not, and that cannot be reached for a while, in the middle of uploads. */
function fakeJatos(takesFiles) {
  let unreachable = 0;
  const reached = () => {
    if (unreachable > 0) {
      unreachable -= 1;
      throw new Error("no network");
    }
  };
  const jatos = { studySessionData: {}, files: [], onLoad: (ready) => ready(),
    urlQueryParameters: { participant: "p001" },
    setStudySessionData: async (data) => {
      reached();
      jatos.studySessionData = JSON.parse(JSON.stringify(data));
    },
    submitResultData: async () => reached(),
    uploadResultFile: async (text, name) => {
      reached();
      if (!takesFiles) throw new Error("no files are taken");
      jatos.files.push(name);
      unreachable = 20;
    } };
  return jatos;
}

for (const takesFiles of [true, false])
  test(`a JATOS that takes ${takesFiles ? "" : "no "}files lets everybody see the last page`, async () => {
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
    assert.ok(seen.has("failed"));
    assert.equal((await jatosStore(experiment, tables)).mustFinish(), false);
    assert.deepEqual(Object.keys(jatos.studySessionData.mien.records), ["consent"]);
  });
