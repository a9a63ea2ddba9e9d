// Which of two stimuli has more of the high end of each scale.

import { choicesOf, type Asked, type Choice } from "../answers";
import type { Experiment } from "../experiment";
import type { Texts } from "../texts";
import type { Asking, CheckedKind } from "./trial_kind";

/** What the two stimuli are called: by their sides, or by their order. */
export const pairNames = ({ settings }: Pick<Experiment, "settings">, texts: Texts): [string, string] =>
  settings.pairs === "in_turn" ? [texts.first, texts.second] : [texts.left, texts.right];

/** All that may be answered to an item, from left to right. */
function sidesOf({ experiment, texts }: Pick<Asking, "experiment" | "texts">, id: string): Choice[] {
  const { ties, strength } = experiment.items[id] ?? {};
  const [left, right] = pairNames(experiment, texts);
  const tie: Choice[] = ties ? [{ value: "tie", text: texts.noDifference, look: "middle" }] : [];
  if (!strength)
    return [{ value: "left", text: left, look: "left-2" }, ...tie, { value: "right", text: right, look: "right-2" }];
  const side = (value: string, name: string, much: boolean, look: string): Choice =>
    ({ value: `${value}_${much ? "much" : "slightly"}`, text: name, note: much ? texts.muchMore : texts.slightlyMore,
      meaning: `${name}, ${much ? texts.muchMore : texts.slightlyMore}`, look });
  return [side("left", left, true, "left-3"), side("left", left, false, "left-1"), ...tie,
    side("right", right, false, "right-1"), side("right", right, true, "right-3")];
}

function sideOf(id: string, asking: Asking): Asked {
  const { experiment, texts, answered } = asking;
  const item = experiment.items[id];
  const asked = choicesOf(id, item ? texts.more({ word: item.high }) : id, "", "", sidesOf(asking, id), String, null,
    answered);
  if (experiment.settings.pairs !== "in_turn") asked.root.classList.add("sides");
  return asked;
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
    return item ? texts.whichIsMore({ word: item.high }) : texts.whichOfTwo;
  },

  meaning: ({ media: [left, right] }, { value_raw: raw }, _raw, _experiment, stimulus) =>
    ({ value: raw === "tie" ? "tie" : stimulus(String(raw).startsWith("left") ? left : right), pole_left: "" }),

  askCheck: (asking) => sideOf(asking.trial.items[0]?.item ?? "attention", asking),

  checkText({ items: [first], expected }, experiment, texts) {
    const asked = sidesOf({ experiment, texts }, first?.item ?? "").find(({ value }) => value === expected);
    return texts.chooseWord({ word: asked?.meaning ?? asked?.text ?? expected ?? "" });
  },
};
