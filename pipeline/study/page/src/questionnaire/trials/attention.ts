// The check that an answer is given as told, in the way in which all trials are answered.

import type { Trial } from "../experiment";
import { emotion, emotionItem } from "./emotion";
import { pair } from "./pair";
import { rating } from "./rating";
import type { CheckedKind, TrialKind } from "./trial_kind";

/** The kind of trial that a check looks like. */
function kindOfCheck({ items: [first], expected }: Trial): CheckedKind {
  if (first?.item === emotionItem) return emotion;
  return /^(left|right)(_much)?$/.test(expected ?? "") ? pair : rating;
}

export const attention: TrialKind = {
  isCheck: true,
  ask: (asking) => [kindOfCheck(asking.trial).askCheck(asking)],
  question: (trial, experiment, texts) => kindOfCheck(trial).checkText(trial, experiment, texts),
  meaning: (_trial, _response, raw) => ({ value: raw, pole_left: "" }),
};
