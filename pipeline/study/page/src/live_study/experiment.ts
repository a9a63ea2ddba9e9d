import type { Demographic, Planned } from "../questionnaire/experiment";
import type { InLanguages } from "../questionnaire/language";

export interface LiveTrial {
  number: number;
  block: string;
  practice: boolean;
}

export interface LivePlan {
  participant: string;
  seed: string;
  trials: LiveTrial[];
}

/** What experiments have in common whose motions are made while participants watch, as `mien study export` and
    `serve` write them. */
export interface LiveExperiment<Plan extends LivePlan = LivePlan> extends Planned<Plan> {
  study: string;
  title: string;
  language: string;
  languages?: InLanguages["languages"];
  page_texts?: InLanguages["page_texts"];
  simulated: boolean;
  texts: { consent: string[]; instructions: string[]; ending: string[] };
  settings: { phones: "refused" | "served" };
  demographics: Demographic[];
}

/** The records of a session in their order. */
export const recordsOf = (experiment: LiveExperiment, session: LivePlan): string[] => [
  "consent",
  ...(experiment.demographics.length ? ["demographics"] : []),
  ...session.trials.map(({ number }) => `trial-${number}`),
  "ending",
];

/** The place of a trial among those of practice, or among the others, from 1; and how many these are. */
export function placeOf(session: LivePlan, trial: LiveTrial): { number: number; all: number } {
  const alike = session.trials.filter(({ practice }) => practice === trial.practice);
  return { number: alike.indexOf(trial) + 1, all: alike.length };
}
