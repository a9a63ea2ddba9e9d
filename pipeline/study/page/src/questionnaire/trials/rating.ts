// A stimulus, on scales: points, a slider, or words.

import { choicesOf, lookOf, scaleOf, wordsOf, type Choice } from "../answers";
import type { Item } from "../experiment";
import type { CheckedKind } from "./trial_kind";

/** A raw answer in the scale's own range, its high pole being the most. */
function valueOf(item: Item, flipped: boolean, raw: number): number {
  const share = item.slider ? raw / 100 : (raw - 1) / (item.points - 1);
  const value = item.least + (flipped ? 1 - share : share) * (item.most - item.least);
  return Number(value.toFixed(6)) + 0;
}

export const rating: CheckedKind = {
  ask: ({ trial, experiment, texts, answered }) => trial.items.map(({ item: id, flipped }) =>
    scaleOf(id, experiment.items[id], flipped, texts, answered)),

  question: (_trial, _experiment, texts) => texts.rate,

  meaning(trial, response, raw, experiment) {
    const item = experiment.items[response.item];
    if (!item || item.words) return { value: raw, pole_left: "" };
    const asked = trial.items.find(({ item: id }) => id === response.item);
    const isNumber = asked && typeof response.value_raw === "number";
    return { value: isNumber ? String(valueOf(item, asked.flipped, Number(response.value_raw))) : raw,
      pole_left: asked?.flipped ? "high" : "low" };
  },

  askCheck({ trial, experiment, texts, answered }) {
    const { item: id, flipped } = trial.items[0] ?? { item: "attention", flipped: false };
    const item = experiment.items[id];
    if (item?.words) return wordsOf(id, texts.attention, answered);
    if (item) return scaleOf(id, { ...item, default: null }, flipped, texts, answered);
    const choices = [1, 2, 3, 4, 5].map((place): Choice => ({ value: String(place), text: String(place),
      look: lookOf(place, 5) }));
    return choicesOf(id, texts.attention, "", "", choices, Number, null, answered);
  },

  checkText(trial, experiment, texts) {
    const item = experiment.items[trial.items[0]?.item ?? ""];
    const expected = trial.expected ?? "";
    if (item?.words) return texts.writeWord({ word: expected });
    const place = Number(expected);
    if (item?.slider)
      return place === 0 ? texts.putLeft : place === 100 ? texts.putRight : texts.putSlider({ place });
    return place === 1 ? texts.pressLeftmost : place === (item?.points ?? 5) ? texts.pressRightmost
      : texts.pressNumber({ place });
  },
};
