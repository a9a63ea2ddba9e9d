import type { Trial } from "../experiment";
import { attention } from "./attention";
import { emotion } from "./emotion";
import { pair } from "./pair";
import { rating } from "./rating";
import type { TrialKind } from "./trial_kind";

/** All kinds of trials, by the names that experiments have for them. */
const trialKinds: Record<string, TrialKind> = { rating, emotion, pair, attention };

/** Throws with words for whoever runs the study. */
export function kindOf({ kind }: Trial): TrialKind {
  const found = trialKinds[kind];
  if (!found) throw new Error(`This page knows no trials of the kind "${kind}"; export the questionnaire again.`);
  return found;
}
