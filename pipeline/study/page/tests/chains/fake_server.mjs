// In the place of mien study serve: hands out the steps of a chain, and keeps what comes.
import { filesOf, serve } from "../http_server.mjs";

const bodyOf = async (request) => {
  let text = "";
  for await (const part of request) text += part;
  return JSON.parse(text);
};

/**
 * Serves the page in a folder with an experiment. `stepAt(trial, asked)` is the step of a trial that is asked for the
 * asked-th time: its JSON, or { status, error }, or null where all chains are complete; `refuses(trial, given)` says why
 * its given-th record is not taken.
 */
export async function fakeServer(folder, experiment, { stepAt = () => null, refuses = () => "" } = {}) {
  const files = await filesOf(folder);
  files["/index.html"] = Buffer.from(String(files["/index.html"]).replace('content="static"', 'content="served"'));
  const records = {};
  const asked = {}, given = {}, sessions = new Set();
  const answers = {
    session: async () => [200, { ...experiment, sessions: [experiment.sessions[0]], kept: Object.keys(records),
      ...(sessions.size ? { browser: [...sessions][0] } : {}) }],
    step: async (name, request) => {
      const { session } = await bodyOf(request);
      sessions.add(session);
      asked[name] = (asked[name] ?? 0) + 1;
      const step = stepAt(name, asked[name], records);
      if (step?.status) return [step.status, { error: step.error }];
      return step ? [200, step] : [409, { error: "finished" }];
    },
    withdrawal: async () => [200, {}],
    records: async (name, request) => {
      const record = await bodyOf(request);
      sessions.add(record.session);
      given[name] = (given[name] ?? 0) + 1;
      const error = refuses(name, given[name], record);
      if (error) return [409, { error }];
      records[name] = record;
      return [200, {}];
    },
  };
  const server = await serve(files, async (path, answer, request) => {
    const [, kind, name = ""] = path.match(/^\/(session|step|records|withdrawal)(?:\.json|\/(.+))?$/) ?? [];
    if (!kind) return false;
    const [status, body] = await answers[kind](name, request);
    answer.writeHead(status, { "Content-Type": "application/json" }).end(JSON.stringify(body));
    return true;
  });
  return { ...server, records, asked, given, sessions };
}
