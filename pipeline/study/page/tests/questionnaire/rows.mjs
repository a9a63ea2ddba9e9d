// The rows that the page makes of records:  node rows.mjs FILE.json
// FILE holds {"experiment", "participant", "records"}; the CSV of the answers is printed. The same
// file is what C++ makes its rows of (pipeline/study/questionnaire/service/record.h), and both must agree.
import { build } from "esbuild";
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";

const built = await build({
  entryPoints: [fileURLToPath(new URL("../../src/questionnaire/rows.ts", import.meta.url))],
  bundle: true, write: false, format: "esm", logLevel: "warning",
});
const source = Buffer.from(built.outputFiles[0].contents).toString("base64");
const { answers_csv: answersCsv } = await import(`data:text/javascript;base64,${source}`);
const { experiment, participant, records } = JSON.parse(await readFile(process.argv[2], "utf8"));
const session = experiment.sessions.find((one) => one.participant === participant);
process.stdout.write(answersCsv(experiment, session, records));
