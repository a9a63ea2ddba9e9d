// The check that an answer is given as told, in the way in which all trials are answered.

import type { Trial } from "../experiment";
import { bestWorst, bestWorstItem } from "./best_worst";
import { emotion, emotionItem } from "./emotion";
import { pair } from "./pair";
import { rating } from "./rating";
import { sameDifferent } from "./same_different";
import type { CheckedKind, TrialKind } from "./trial_kind";
import { twoInterval } from "./two_interval";
import { yesNo } from "./yes_no";

/** The kinds that have an item of their own. */
const kindsByItem: Record<string, CheckedKind | undefined> = { [emotionItem]: emotion,
  same_different: sameDifferent, yes_no: yesNo, two_interval: twoInterval };

/** The kind of trial that a check looks like. */
function kindOfCheck({ items: [first], expected }: Trial): CheckedKind {
  const own = kindsByItem[first?.item ?? ""];
  if (own) return own;
  if (bestWorstItem.test(first?.item ?? "")) return bestWorst;
  return /^(left|right)(_much)?$/.test(expected ?? "") ? pair : rating;
}

export const attention: TrialKind = {
  isCheck: true,
  ask: (asking) => [kindOfCheck(asking.trial).askCheck(asking)],
  question: (trial, experiment, texts) => kindOfCheck(trial).checkText(trial, experiment, texts),
  meaning: (_trial, _response, raw) => ({ value: raw, pole_left: "" }),
};
