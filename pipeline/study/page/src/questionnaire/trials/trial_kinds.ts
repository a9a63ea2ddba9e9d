import type { Trial } from "../experiment";
import { attention } from "./attention";
import { bestWorst } from "./best_worst";
import { continuous } from "./continuous";
import { emotion } from "./emotion";
import { grid } from "./grid";
import { pair } from "./pair";
import { rating } from "./rating";
import { sameDifferent } from "./same_different";
import type { TrialKind } from "./trial_kind";
import { twoInterval } from "./two_interval";
import { yesNo } from "./yes_no";

/** All kinds of trials, by the names that experiments have for them. */
const trialKinds: Record<string, TrialKind> = { rating, emotion, pair, same_different: sameDifferent,
  yes_no: yesNo, two_interval: twoInterval, best_worst: bestWorst, grid, continuous, attention };

/** Throws with words for whoever runs the study. */
export function kindOf({ kind }: Trial): TrialKind {
  const found = trialKinds[kind];
  if (!found) throw new Error(`This page knows no trials of the kind "${kind}"; export the questionnaire again.`);
  return found;
}
