// Several films of one set, each rated from 0 to 100 on a slider, as often played as wanted, with an open reference
// that is also hidden among them (MUSHRA, ITU-R BS.1534-3).

import { polesOf, rangeOf, type Asked } from "../answers";
import { element } from "../elements";
import type { Texts } from "../texts";
import type { Asking, GridFilms, TrialKind } from "./trial_kind";

/** What an item asks (pipeline/manifest/ratings/answers/grid_item.h). */
const gridItem = /^(.+)\/([1-9]\d*)$/;

const partsOf = (item: string): { scale: string; place: number } => {
  const [, scale, place] = gridItem.exec(item) ?? [];
  return { scale: scale ?? item, place: Number(place ?? 1) };
};

/** The button that plays a film; it shows whether that was seen. */
function playButton(index: number, name: string, grid: GridFilms, texts: Texts): HTMLButtonElement {
  const isReference = index === grid.reference();
  const text = isReference ? texts.gridReference : name;
  const mark = element("span", { class: "seen-mark", "aria-hidden": "true" });
  const made = element("button", { type: "button", class: "button play-film" },
    element("span", { class: "triangle", "aria-hidden": "true" }), text, mark);
  made.addEventListener("click", () => grid.playFilm(index));
  const show = () => {
    const label = isReference ? texts.playReference : texts.playVideo({ number: name });
    made.disabled = !grid.isReady(index);
    made.classList.toggle("now", grid.isPlaying(index));
    made.setAttribute("aria-label", grid.isSeen(index) ? `${label} (${texts.played})` : label);
    mark.textContent = grid.isSeen(index) ? "✓" : "";
  };
  grid.onChange(show);
  show();
  return made;
}

/** Space plays the film of the row in which the focus is. */
function letSpacePlay(row: HTMLElement, play: HTMLButtonElement): void {
  row.addEventListener("keydown", (event) => {
    if (event.key !== " " || event.target === play) return;
    event.preventDefault();
    event.stopPropagation();
    play.click();
  });
}

function referenceOf(grid: GridFilms, { texts }: Asking): Asked {
  const index = grid.reference();
  const play = playButton(index, "", grid, texts);
  const root = element("div", { class: "asked grid-row grid-reference" }, play);
  return { root, focus: () => play.focus(), answer: () => null, lack: () => (grid.isSeen(index) ? null : "play") };
}

function filmOf(item: string, grid: GridFilms, { experiment, texts, answered }: Asking): Asked {
  const { scale, place } = partsOf(item);
  const { low, high } = experiment.items[scale]!;
  const number = String(place);
  const play = playButton(place - 1, number, grid, texts);
  const shown = element("output", { class: "grid-value", "aria-hidden": "true" }, "–");
  const range = rangeOf(`${number}: ${low} – ${high}`, false, () => {
    shown.textContent = range.input.value;
    answered(asked, false);
  });
  const root = element("div", { class: "asked grid-row", "data-place": number }, play,
    element("div", { class: "grid-slider" }, range.input), shown);
  letSpacePlay(root, play);
  const asked: Asked = {
    root,
    focus: () => (grid.isSeen(place - 1) ? range.input : play).focus(),
    answer: () => {
      const given = range.value();
      return given && { item, ...given };
    },
    lack: () => (!grid.isSeen(place - 1) ? "play" : range.value() ? null : "answer"),
  };
  return asked;
}

/** The ends of all sliders, above them. */
const headOf = (item: string, { experiment }: Asking): HTMLElement => {
  const { low, high } = experiment.items[partsOf(item).scale]!;
  const poles = polesOf(low, high);
  poles.classList.add("grid-poles");
  return poles;
};

const placesOf = (asked: Asked[]): string =>
  asked.flatMap(({ root }) => root.dataset.place ?? []).join(", ");

export const grid: TrialKind = {
  ask(asking) {
    const { trial, grid: stage } = asking;
    const films = trial.items.map(({ item }) => filmOf(item, stage!, asking));
    const all = stage!.reference() < 0 ? films : [referenceOf(stage!, asking), ...films];
    all[0]!.root.prepend(headOf(trial.items[0]!.item, asking));
    return all;
  },

  question({ items: [first], reference }, experiment, texts) {
    const word = experiment.items[partsOf(first?.item ?? "").scale]?.high ?? "";
    return reference ? texts.rateGridReference({ word }) : texts.rateGrid({ word });
  },

  missingText(missing, texts) {
    const unseen = missing.filter((one) => one.lack?.() === "play");
    const unrated = missing.filter((one) => one.root.dataset.place && one.answer() === null);
    const isReferenceUnseen = unseen.some(({ root }) => !root.dataset.place);
    return [
      isReferenceUnseen ? texts.referenceUnseen : "",
      placesOf(unseen) ? texts.filmsUnseen({ list: placesOf(unseen) }) : "",
      placesOf(unrated) ? texts.slidersUnmoved({ list: placesOf(unrated) }) : "",
    ].filter(Boolean).join(" ");
  },

  meaning(trial, { item }, raw, _experiment, stimulus) {
    const { scale, place } = partsOf(item);
    return { value: raw, pole_left: "low", item: scale, stimulus: stimulus(trial.media[place - 1]),
      against: trial.reference ? stimulus(trial.reference) : "", shown: place - 1 };
  },
};
