// Which of a set of stimuli is best, and which is worst, with respect to each scale.

import { choicesOf, type Asked, type Choice } from "../answers";
import type { Experiment } from "../experiment";
import type { Asking, CheckedKind } from "./trial_kind";

/** What an item asks (pipeline/manifest/ratings/answers/best_worst_item.h). */
export const bestWorstItem = /^(.+)\/(best|worst)$/;

/** As many stimuli as the smallest set has: checks show none. */
const leastSet = 3;

const wordOf = (item: string, { items }: Experiment): string => {
  const scale = bestWorstItem.exec(item)?.[1] ?? item;
  return items[scale]?.high ?? scale;
};

function placeOf(item: string, { trial, experiment, texts }: Asking, answered: Asking["answered"]): Asked {
  const isBest = item.endsWith("/best");
  const word = wordOf(item, experiment);
  const title = isBest ? texts.mostOfAll({ word }) : texts.leastOfAll({ word });
  const choices = Array.from({ length: trial.media.length || leastSet }, (_, index): Choice =>
    ({ value: String(index + 1), text: String(index + 1), meaning: `${title}: ${index + 1}`,
      look: isBest ? "right-2" : "left-2" }));
  return choicesOf(item, title, "", "", choices, String, null, answered);
}

const inputsOf = ({ root }: Asked): HTMLInputElement[] => [...root.querySelectorAll("input")];

/** What is best cannot be worst, too. */
function exclude(one: Asked, other: Asked): void {
  const chosen = inputsOf(one).find((input) => input.checked)?.value;
  for (const input of inputsOf(other)) input.disabled = input.value === chosen;
}

export const bestWorst: CheckedKind = {
  ask(asking) {
    const all: Asked[] = [];
    const answered: Asking["answered"] = (asked, isKey) => {
      for (let first = 0; first + 1 < all.length; first += 2) {
        exclude(all[first]!, all[first + 1]!);
        exclude(all[first + 1]!, all[first]!);
      }
      asking.answered(asked, isKey);
    };
    all.push(...asking.trial.items.map(({ item }) => placeOf(item, asking, answered)));
    for (const { root } of all) root.classList.add("place");
    return all;
  },

  question({ items }, experiment, texts) {
    return items.length > 2 ? texts.bestAndWorstEach : texts.bestAndWorst({ word: wordOf(items[0]?.item ?? "", experiment) });
  },

  meaning: ({ media }, _response, raw, _experiment, stimulus) =>
    ({ value: stimulus(media[Number(raw) - 1]), pole_left: "" }),

  askCheck: (asking) => placeOf(asking.trial.items[0]?.item ?? "", asking, asking.answered),

  checkText: ({ expected }, _experiment, texts) => texts.chooseWord({ word: expected ?? "" }),
};
