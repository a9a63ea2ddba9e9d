import type { Answered, Asked } from "../answers";
import type { Experiment, Response, Trial } from "../experiment";
import type { Texts } from "../texts";

/** What a page knows when it asks a trial. */
export interface Asking {
  trial: Trial;
  /** Ids of what is offered, as it stands there. */
  choices: string[];
  experiment: Experiment;
  texts: Texts;
  answered: Answered;
}

/** What a raw answer means, as the table of answers has it. */
export interface Meaning {
  value: string;
  pole_left: "" | "low" | "high";
}

/** How the trials of one kind are asked and understood (pipeline/study/trials/trial_kind.h). */
export interface TrialKind {
  /** An attention check, which stands in for trials of another kind. */
  isCheck?: true;
  /** All that a trial asks, in its order. */
  ask(asking: Asking): Asked[];
  /** What stands above it where the study has no question of its own. */
  question(trial: Trial, experiment: Experiment, texts: Texts): string;
  /** `raw` is the response's raw answer as tables have it; `stimulus` tells what a token stands for. */
  meaning(trial: Trial, response: Response, raw: string, experiment: Experiment,
    stimulus: (token: string | undefined) => string): Meaning;
}

/** What a kind of trial has besides, so that checks can look like it. */
export interface CheckedKind extends TrialKind {
  /** The one item of a check. */
  askCheck(asking: Asking): Asked;
  /** What a check asks for. */
  checkText(trial: Trial, experiment: Experiment, texts: Texts): string;
}
