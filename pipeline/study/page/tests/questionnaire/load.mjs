// How long the server of a study takes to acknowledge answers while many participants take it at once.
//   node load.mjs OPEN_LINK [PARTICIPANTS] [SECONDS_PER_PAGE]
// Every participant (200) comes by the open link, loads the page and all films in parts, and then gives one page
// after another, each SECONDS_PER_PAGE (8) on average after the one before. Prints how many came to the end, what went
// wrong, and the times from sending an answer to its acknowledgement.
import { Agent, request } from "node:http";

const [link, participants = "200", seconds = "8"] = process.argv.slice(2);
const base = new URL(link);
const times = [];
const troubles = new Map();
let finished = 0, bytes = 0;

const trouble = (what) => troubles.set(what, (troubles.get(what) ?? 0) + 1);
const pause = (ms) => new Promise((done) => setTimeout(done, ms));
// Repeatable: a linear congruential generator.
let seed = 1;
const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;

/** One participant's browser: at most six connections, kept open. */
class Browser {
  agent = new Agent({ keepAlive: true, maxSockets: 6 });
  name = Math.floor(random() * 1e15).toString(16);

  ask(path, { method = "GET", body, headers = {} } = {}) {
    return new Promise((done) => {
      const sent = request({ host: base.hostname, port: base.port, path, method, agent: this.agent,
        headers: { ...(body ? { "Content-Type": "application/json", "Content-Length": Buffer.byteLength(body) } : {}), ...headers } },
      (answer) => {
        const parts = [];
        answer.on("data", (part) => parts.push(part));
        answer.on("end", () => done({ status: answer.statusCode, body: Buffer.concat(parts), headers: answer.headers }));
        answer.on("error", () => done({ status: 0 }));
      });
      sent.on("error", () => done({ status: 0 }));
      sent.end(body);
    });
  }

  /** Until it is acknowledged, as the page does. */
  async give(path, record) {
    const body = JSON.stringify({ session: this.name, comment: "", started_at: new Date().toISOString(), ...record });
    for (let tries = 0; ; tries += 1) {
      const began = performance.now();
      const { status, body: said } = await this.ask(path + record.record, { method: "POST", body });
      times.push(performance.now() - began);
      if (status === 200) return JSON.parse(said);
      trouble(`answer ${status}`);
      if (tries > 200) throw new Error(`${record.record}: ${status} ${said}`);
      await pause(500);
    }
  }

  /** A film in parts, as browsers load it. */
  async film(path) {
    for (let at = 0, length = 1; at < length; ) {
      const { status, body, headers } = await this.ask(path, { headers: { Range: `bytes=${at}-${at + 262143}` } });
      if (status !== 206) {
        trouble(`film ${status}`);
        await pause(500);
        continue;
      }
      bytes += body.length;
      length = Number(headers["content-range"].split("/")[1]);
      at += body.length;
    }
  }
}

const sideOf = (scale) => (scale?.strength ? "left_much" : "left");

/** A marker that wanders while the film plays. */
const traceOf = (seconds) => {
  let at = 50;
  return Array.from({ length: Math.ceil(10 * seconds - 1e-6) + 1 },
    () => (at = Math.min(100, Math.max(0, at + Math.round(9 * random()) - 4)))).join(" ");
};

const valueOf = (experiment, trial, item) => {
  // Places in a set are chosen, not numbers.
  if (trial.expected)
    return /^\d+$/.test(trial.expected) && !/\/(best|worst)$/.test(item) ? Number(trial.expected) : trial.expected;
  const own = { pair: sideOf(experiment.items[item]), same_different: "same", yes_no: "yes",
    two_interval: "first", best_worst: item.endsWith("/best") ? "1" : "2", grid: Math.floor(101 * random()) };
  if (trial.kind in own) return own[trial.kind];
  if (trial.kind === "continuous") return traceOf(experiment.media[trial.media[0]].seconds);
  if (trial.kind === "emotion" && !experiment.items[item]) return Object.keys(experiment.choices)[0];
  if (experiment.items[item].slider) return Math.floor(101 * random());
  return experiment.items[item].words ? "heavy" : 1 + Math.floor(random() * experiment.items[item].points);
};

async function takePart() {
  const browser = new Browser();
  for (const file of ["", "questionnaire.js", "questionnaire.css", "session.json"]) await browser.ask(base.pathname + file);
  const { session } = await browser.give(`${base.pathname}records/`,
    { record: "consent", responses: [{ item: "consent", value_raw: "agreed", rt_ms: 1 }] });
  const own = new URL(session, base).pathname;
  const experiment = JSON.parse((await browser.ask(`${own}session.json`)).body);
  await Promise.all(Object.values(experiment.media).map(({ file }) =>
    browser.film(new URL(file, new URL(own, base)).pathname)));
  const answered = ({ id, answer }) => ({ item: id, rt_ms: 1,
    value_raw: answer === "number" ? 30 : Array.isArray(answer) ? answer[0] : "x" });
  const pages = [];
  if (experiment.screening) pages.push({ record: "screening", viewport_width: 4000, viewport_height: 4000, refresh_hz: 60,
    responses: (experiment.screening.questions ?? []).map(answered) });
  if (experiment.demographics.length) pages.push({ record: "demographics", responses: experiment.demographics.map(answered) });
  for (const trial of experiment.sessions[0].trials)
    pages.push({ record: `trial-${trial.number}`, responses: (trial.items.length ? trial.items : [{ item: "attention" }])
      .map(({ item }) => ({ item, rt_ms: 900, value_raw: valueOf(experiment, trial, item) })) });
  for (const page of [...pages, { record: "ending", responses: [] }]) {
    await pause(2000 * Number(seconds) * random());
    await browser.give(`${own}records/`, page);
  }
  finished += 1;
  browser.agent.destroy();
}

const began = performance.now();
await Promise.all(Array.from({ length: Number(participants) }, async () => {
  await pause(5000 * random());
  await takePart().catch((error) => trouble(error.message));
}));
times.sort((one, other) => one - other);
const at = (share) => times[Math.min(times.length - 1, Math.floor(share * times.length))].toFixed(1);
console.log(`${finished} of ${participants} participants finished in ${((performance.now() - began) / 1000).toFixed(0)} s; ` +
  `${(bytes / 1e6).toFixed(0)} MB of films`);
console.log(`${times.length} answers: median ${at(0.5)} ms, 95 % within ${at(0.95)} ms, 99 % within ${at(0.99)} ms, longest ${at(1)} ms`);
console.log(troubles.size ? [...troubles].map(([what, count]) => `${count} × ${what}`).join("\n") : "nothing went wrong");
