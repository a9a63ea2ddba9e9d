import { stepColumns } from "../questionnaire/columns";
import type { PageRecord } from "../questionnaire/experiment";
import { csv } from "../questionnaire/rows";
import type { ChainExperiment, ChainSession, ChainTrial } from "./experiment";
import type { ChainRecord } from "./record";
import { passesCheck } from "./steps";

type Row = Record<(typeof stepColumns)[number], string>;

const truth = (is: boolean | undefined): string => (is === undefined ? "" : is ? "1" : "0");
const number = (value: number | undefined): string => (value === undefined ? "" : String(value));
const list = (values: number[] | undefined): string => (values ?? []).map(String).join(" ");

/** One row a step, practice and attention checks included. */
export function stepsCsv(
  experiment: ChainExperiment, session: ChainSession, records: Record<string, PageRecord>): string {
  const rowOf = (trial: ChainTrial, record: PageRecord, made: ChainRecord): Row => ({
    participant: session.participant, session: record.session, design: experiment.design,
    simulated: truth(experiment.simulated), trial: String(trial.number), is_practice: truth(trial.practice),
    is_check: truth(trial.expected !== undefined),
    passed: trial.expected ? truth(passesCheck(made, trial.expected, experiment.chains)) : "",
    attempt: String(made.attempt), word: made.word, chain: String(made.chain), step: String(made.step),
    person: String(made.person), point: list(made.point),
    dimension: made.dimension === undefined ? "" : experiment.chains.dimensions[made.dimension]!.name,
    value: number(made.value), slider_start: number(made.start), is_reversed: truth(made.reversed),
    proposal: list(made.proposal), is_proposal_first: truth(made.proposal_first),
    chose_proposal: truth(made.chose_proposal), moves: String(made.moves), trial_ms: number(record.trial_ms),
    started_at: record.started_at,
  });
  return csv(stepColumns, session.trials.flatMap((trial) => {
    const record = records[`trial-${trial.number}`];
    return record?.chain ? [rowOf(trial, record, record.chain)] : [];
  }));
}
