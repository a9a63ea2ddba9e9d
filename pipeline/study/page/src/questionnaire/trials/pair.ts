// Which of two stimuli has more of the high end of each scale.

import { choicesOf, type Asked } from "../answers";
import type { Asking, CheckedKind } from "./trial_kind";

function sideOf(id: string, { experiment, texts, answered }: Asking): Asked {
  const item = experiment.items[id];
  return choicesOf(id, item ? texts.more(item.high) : id, "", "",
    [{ value: "left", text: texts.left, look: "left-2" }, { value: "right", text: texts.right, look: "right-2" }],
    String, null, answered);
}

export const pair: CheckedKind = {
  ask(asking) {
    const asked = asking.trial.items.map(({ item }) => sideOf(item, asking));
    // What stands above the one item says it already.
    if (asked.length === 1) asked[0]!.root.querySelector("legend")?.classList.add("unseen");
    return asked;
  },

  question({ items: [only, other] }, experiment, texts) {
    const item = only && !other ? experiment.items[only.item] : undefined;
    return item ? texts.whichIsMore(item.high) : texts.whichOfTwo;
  },

  meaning: ({ media: [left, right] }, response, _raw, _experiment, stimulus) =>
    ({ value: stimulus(response.value_raw === "left" ? left : right), pole_left: "" }),

  askCheck: (asking) => sideOf(asking.trial.items[0]?.item ?? "attention", asking),

  checkText: (trial, _experiment, texts) =>
    texts.chooseWord(trial.expected === "left" ? texts.left : texts.right),
};
