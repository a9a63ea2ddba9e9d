import { chooseByKeys, focusChoice } from "./choice_keys";
import { element } from "./elements";
import type { Item, Response } from "./experiment";
import { degreeOf, meaningOf, type Texts } from "./texts";

/** One thing that is asked and its answer, if any. */
export interface Asked {
  root: HTMLElement;
  /** Focuses where an answer is given. */
  focus(): void;
  /** Nothing until it is answered. */
  answer(): { item: string; value_raw: number | string; at: number; rt_ms?: number | null } | null;
  /** What has to be done yet, where that is not only an answer. */
  lack?(): "play" | "answer" | null;
}

/** Whether something has to be done yet. */
export const isMissing = (one: Asked): boolean => (one.lack ? one.lack() !== null : one.answer() === null);

/** Told when an answer has been given; `isKey` where it was a digit, after which one goes on. */
export type Answered = (asked: Asked, isKey: boolean) => void;

export interface Choice {
  value: string;
  text: string;
  /** Smaller, below it. */
  note?: string;
  /** What is read aloud. */
  meaning?: string;
  look?: string;
}

let names = 0;

/** Buttons of which one is chosen, by keys too. */
export function choicesOf(
  item: string, title: string, left: string, right: string, choices: Choice[],
  raw: (value: string) => number | string, chosen: string | null, answered: Answered,
): Asked {
  const name = `asked-${(names += 1)}`;
  let at = performance.now();
  let value = chosen;
  const row = element("div", { class: "choices" });
  const inputs = choices.map((choice, index) => {
    const input = element("input", { type: "radio", name, value: choice.value, id: `${name}-${index}` });
    if (choice.value === chosen) input.checked = true;
    if (choice.meaning) input.setAttribute("aria-label", choice.meaning);
    const label = element("label", { for: input.id, class: choice.look ?? "" },
      element("span", { class: "choice-text" }, choice.text));
    if (choice.note) label.append(element("span", { class: "choice-note", "aria-hidden": "true" }, choice.note));
    row.append(element("div", { class: "choice" }, input, label));
    return input;
  });
  const legend = element("legend", {}, title);
  const root = element("fieldset", { class: "asked" }, legend);
  if (left || right) {
    legend.classList.add("unseen");
    root.append(element("div", { class: choices.length > 5 ? "scale dense" : "scale" },
      element("span", { class: "pole low", "aria-hidden": "true" }, left), row,
      element("span", { class: "pole high", "aria-hidden": "true" }, right)));
  } else {
    root.append(row);
  }
  const asked: Asked = {
    root,
    focus: () => focusChoice(root, inputs),
    answer: () => (value === null ? null : { item, value_raw: raw(value), at }),
  };
  const choose = (input: HTMLInputElement, isKey: boolean) => {
    input.checked = true;
    value = input.value;
    at = performance.now();
    answered(asked, isKey);
  };
  for (const input of inputs) input.addEventListener("change", () => choose(input, false));
  chooseByKeys(root, inputs, choose);
  return asked;
}

/** The further from the middle the stronger, one hue a side: sides tell nothing of poles. */
export function lookOf(place: number, points: number): string {
  const middle = (points + 1) / 2;
  const depth = Math.round((3 * Math.abs(place - middle)) / (middle - 1));
  if (place === middle) return "middle";
  return `${place < middle ? "left" : "right"}-${Math.max(1, depth)}`;
}

/** What a point without a word of its own means: its number, and the pole of an end. */
function plainMeaning(place: number, points: number, left: string, right: string): string {
  const pole = place === 1 ? left : place === points ? right : "";
  return pole ? `${place} / ${points}: ${pole}` : `${place} / ${points}`;
}

function pointsOf(
  id: string, item: Item, flipped: boolean, texts: Texts, answered: Answered,
): Asked {
  const left = flipped ? item.high : item.low;
  const right = flipped ? item.low : item.high;
  const choices = Array.from({ length: item.points }, (_, index): Choice => {
    const place = index + 1;
    return { value: String(place), text: String(place), look: lookOf(place, item.points),
      note: item.anchors ? degreeOf(texts, place, item.points) : undefined,
      meaning: item.anchors
        ? `${place}: ${meaningOf(texts, place, item.points, left, right)}`
        : plainMeaning(place, item.points, left, right) };
  });
  const middle = (item.points + 1) / 2;
  const start = item.default === "middle" && Number.isInteger(middle) ? String(middle) : null;
  return choicesOf(id, `${left} – ${right}`, left, right, choices, Number, start, answered);
}

/** A slider from 0 to 100 without a knob until it is moved. */
export interface Range {
  input: HTMLInputElement;
  /** Nothing until it was moved. */
  value(): { value_raw: number; at: number } | null;
}

export function rangeOf(label: string, isGivenFirst: boolean, moved: () => void): Range {
  let isGiven = isGivenFirst;
  let at = performance.now();
  const input = element("input", { type: "range", min: "0", max: "100", step: "1",
    "aria-label": label, class: isGiven ? "" : "untouched" });
  input.value = "50";
  const tell = () =>
    input.setAttribute("aria-valuetext", isGiven ? `${input.value} / 100` : "–");
  tell();
  const given = () => {
    isGiven = true;
    at = performance.now();
    input.classList.remove("untouched");
    tell();
    moved();
  };
  input.addEventListener("input", given);
  // Where the knob lies already may be what is meant.
  input.addEventListener("pointerup", given);
  input.addEventListener("keydown", (event) => {
    if (/^(Arrow|Page|Home|End)/.test(event.key)) setTimeout(given);
  });
  return { input, value: () => (isGiven ? { value_raw: Number(input.value), at } : null) };
}

/** The ends of a slider, above it. */
export const polesOf = (left: string, right: string): HTMLElement =>
  element("div", { class: "poles", "aria-hidden": "true" },
    element("span", { class: "pole low" }, left), element("span", { class: "pole high" }, right));

function sliderOf(id: string, item: Item, flipped: boolean, answered: Answered): Asked {
  const left = flipped ? item.high : item.low;
  const right = flipped ? item.low : item.high;
  const range = rangeOf(`${left} – ${right}`, item.default === "middle", () => answered(asked, false));
  const asked: Asked = {
    root: element("div", { class: "asked slider" }, polesOf(left, right), range.input),
    focus: () => range.input.focus(),
    answer: () => {
      const given = range.value();
      return given && { item: id, ...given };
    },
  };
  return asked;
}

/** Free words: in several lines or, with suggestions, in one line that the browser completes. */
export function wordsOf(id: string, title: string, answered: Answered, suggest: string[] = []): Asked {
  let at = performance.now();
  const name = `asked-${(names += 1)}`;
  const input = suggest.length
    ? element("input", { type: "text", maxlength: "2000", id: name, list: `${name}-words`, autocomplete: "off" })
    : element("textarea", { rows: "2", maxlength: "2000", id: name });
  const root = element("div", { class: "asked words" }, element("label", { for: name }, title), input);
  if (suggest.length)
    root.append(element("datalist", { id: `${name}-words` },
      ...suggest.map((word) => element("option", { value: word }))));
  const asked: Asked = {
    root,
    focus: () => input.focus(),
    answer: () => (input.value.trim() ? { item: id, value_raw: input.value.trim(), at } : null),
  };
  input.addEventListener("input", () => {
    at = performance.now();
    answered(asked, false);
  });
  return asked;
}

/** A scale with its ends, answered as it says; in words where it is none. */
export function scaleOf(
  id: string, item: Item | undefined, flipped: boolean, texts: Texts, answered: Answered,
): Asked {
  if (!item || item.words)
    return wordsOf(id, item ? `${item.low} – ${item.high}` : texts.describe, answered, item?.suggest);
  return item.slider ? sliderOf(id, item, flipped, answered)
    : pointsOf(id, item, flipped, texts, answered);
}

/** Answers in the order in which they were asked; times from `since`, where they have no time of their own. */
export const responsesOf = (asked: Asked[], since: number): Response[] =>
  asked.flatMap((one) => {
    const answer = one.answer();
    if (!answer) return [];
    const { item, value_raw: valueRaw, at, rt_ms: own } = answer;
    return [{ item, value_raw: valueRaw, rt_ms: own === undefined ? Math.max(0, Math.round(at - since)) : own }];
  });
