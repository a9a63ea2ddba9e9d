// The rows that the page makes of records:  node rows.mjs FILE.json
// FILE holds {"experiment", "participant", "records"}; the CSV of the answers is printed. The same
// file is what C++ makes its rows of (pipeline/study/questionnaire/service/record.h), and both must agree.
import { readFile } from "node:fs/promises";

import { bundled } from "../bundled.mjs";

const { answersCsv } = await bundled("questionnaire/rows.ts");
const { experiment, participant, records } = JSON.parse(await readFile(process.argv[2], "utf8"));
const session = experiment.sessions.find((one) => one.participant === participant);
process.stdout.write(answersCsv(experiment, session, records));
