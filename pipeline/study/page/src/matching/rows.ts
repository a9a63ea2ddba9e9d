import { changeColumns, trialColumns } from "../questionnaire/columns";
import { csv } from "../questionnaire/rows";
import type { PageRecord } from "../questionnaire/experiment";
import type { MatchingExperiment, MatchingSession, MatchingTrial } from "./experiment";
import type { MatchingRecord } from "./record";

type Row<Columns extends readonly string[]> = Record<Columns[number], string>;
type Records = Record<string, PageRecord>;
const truth = (is: boolean): string => (is ? "1" : "0");

function matched(session: MatchingSession, records: Records): [MatchingTrial, PageRecord, MatchingRecord][] {
  return session.trials.flatMap((trial) => {
    const record = records[`trial-${trial.number}`];
    return record?.matching ? [[trial, record, record.matching] as [MatchingTrial, PageRecord, MatchingRecord]] : [];
  });
}

/** One row a trial, without practice; `mien study evaluate` reads it. */
export function trialsCsv(experiment: MatchingExperiment, session: MatchingSession, records: Records): string {
  return csv(trialColumns, matched(session, records)
    .filter(([trial]) => !trial.practice)
    .map(([trial, record, match]): Row<typeof trialColumns> => ({
      participant: session.participant, target: trial.target, interface: trial.interface,
      first_guess_d: String(match.first_guess_d), time_s: String(match.time_s), success: truth(match.success),
      simulated: truth(experiment.simulated), trial: String(trial.number), d: String(match.d),
      guess_s: String(match.guess_s), attempt: String(match.attempt), session: record.session,
      design: experiment.design, limit_s: String(experiment.matching.limit_s),
      threshold_m: String(experiment.matching.threshold_m),
    })));
}

/** One row a change, practice included. */
export function changesCsv(experiment: MatchingExperiment, session: MatchingSession, records: Records): string {
  return csv(changeColumns, matched(session, records).flatMap(([trial, , match]) =>
    match.changes.map((change): Row<typeof changeColumns> => ({
      participant: session.participant, trial: String(trial.number), target: trial.target,
      interface: trial.interface, is_practice: truth(trial.practice), attempt: String(match.attempt),
      time_s: String(change.s), step: change.step, action: change.action, slider: change.slider ?? "",
      value: change.value === undefined ? "" : String(change.value),
      d: change.d === undefined ? "" : String(change.d), simulated: truth(experiment.simulated),
    }))));
}
