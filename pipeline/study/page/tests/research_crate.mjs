// Holds a crate against the validator of npm's ro-crate.
//   node research_crate.mjs ro-crate-metadata.json
// prints what it finds as JSON: [{ status, id, message }]. Nothing is fetched: the context of RO-Crate is the one that
// the validator brings; that of workflow runs is taken as empty.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const require = createRequire(import.meta.url);
const own = require("ro-crate/lib/context.json");

const context = (address) => /^https:\/\/w3id\.org\/ro\/crate\/1\.\d\/context$/.test(address) ? own
  : address === "https://w3id.org/ro/terms/workflow-run/context" ? { "@context": {} } : null;
globalThis.fetch = async (address) => {
  const found = context(String(address));
  if (!found) throw new Error(`${address} is not a context that crates of mien name`);
  return { ok: true, json: async () => found, text: async () => JSON.stringify(found) };
};

const { Validator } = require("ro-crate/lib/validator.js");  // takes fetch as it is now
const validator = new Validator();
validator.parseJSON(readFileSync(process.argv[2], "utf8"));
await validator.crate?.resolveContext();
await validator.validate();
console.log(JSON.stringify(validator.results.map(({ status, id, message }) => ({ status, id, message }))));
