// What trials of detection share: one item that has two answers.

import { choicesOf, type Asked, type Choice } from "../answers";
import type { Texts } from "../texts";
import type { Asking, CheckedKind } from "./trial_kind";

/** The item `item` with its two answers from left to right: raw answers and what is shown. */
export function twoChoices(
  item: string, question: (texts: Texts) => string,
  answersOf: (texts: Texts) => [[string, string], [string, string]],
): CheckedKind {
  const choicesFor = (texts: Texts) => answersOf(texts).map(([value, text], index): Choice =>
    ({ value, text, look: index === 0 ? "left-2" : "right-2" }));

  const askOne = ({ texts, answered, experiment }: Asking): Asked =>
    choicesOf(item, experiment.settings.question || question(texts), "", "", choicesFor(texts), String, null, answered);

  return {
    ask(asking) {
      const asked = askOne(asking);
      // What stands above the item says it already.
      asked.root.querySelector("legend")?.classList.add("unseen");
      return [asked];
    },

    question: (_trial, _experiment, texts) => question(texts),

    meaning: (_trial, _response, raw) => ({ value: raw, pole_left: "" }),

    askCheck: askOne,

    checkText({ expected }, _experiment, texts) {
      const asked = answersOf(texts).find(([value]) => value === expected);
      return texts.chooseWord({ word: asked?.[1] ?? expected ?? "" });
    },
  };
}
