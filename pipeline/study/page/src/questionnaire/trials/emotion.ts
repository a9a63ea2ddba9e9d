// Which of a list a stimulus shows. Scales that are asked too are answered as in a rating.

import { choicesOf, scaleOf, type Asked, type Choice } from "../answers";
import { rating } from "./rating";
import type { Asking, CheckedKind } from "./trial_kind";

/** The item that is no scale. */
export const emotionItem = "emotion";

/** Words of which one is chosen. */
function emotionOf({ choices: ids, experiment, texts, answered }: Asking): Asked {
  const choices = ids.map((id, index): Choice => ({ value: id, text: experiment.choices?.[id] ?? id,
    note: index < 9 ? String(index + 1) : undefined, look: "plain" }));
  return choicesOf(emotionItem, texts.whichEmotion, "", "", choices, String, null, answered);
}

export const emotion: CheckedKind = {
  ask: (asking) => asking.trial.items.map(({ item: id, flipped }) => id === emotionItem ? emotionOf(asking)
    : scaleOf(id, asking.experiment.items[id], flipped, asking.texts, asking.answered)),

  question: (_trial, _experiment, texts) => texts.whichEmotion,

  meaning: (trial, response, raw, experiment, stimulus) => response.item === emotionItem
    ? { value: raw, pole_left: "" } : rating.meaning(trial, response, raw, experiment, stimulus),

  askCheck: emotionOf,

  checkText(trial, experiment, texts) {
    const expected = trial.expected ?? "";
    return texts.chooseWord({ word: experiment.choices?.[expected] ?? expected });
  },
};
