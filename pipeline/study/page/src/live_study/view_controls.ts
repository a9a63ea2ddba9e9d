import type { FigureView, Side } from "../figure/figure_view";
import { button, element } from "../questionnaire/elements";
import type { MatchingTexts } from "./texts";

/** Buttons of which one is pressed. */
export function choiceOf<Value extends string>(
  name: string, options: [Value, string][], first: Value | null, chosen: (value: Value) => void): HTMLElement {
  const group = element("div", { class: "choice-of", role: "group", "aria-label": name });
  const buttons = options.map(([value, text]) => {
    const one = button(text, () => {
      if (first !== null) mark(value);
      chosen(value);
    }, "small");
    one.dataset.value = value;
    group.append(one);
    return one;
  });
  const mark = (value: Value) => {
    for (const one of buttons) one.setAttribute("aria-pressed", String(one.dataset.value === value));
  };
  if (first !== null) mark(first);
  return group;
}

/** How figures are seen: other choices, the side from which, and whether they move. */
export function viewControls(view: FigureView, texts: MatchingTexts, ...choices: HTMLElement[]): HTMLElement {
  const pause = button(texts.pause, () => {
    if (view.plays()) view.pause();
    else view.play();
    pause.textContent = view.plays() ? texts.pause : texts.play;
  }, "small");
  return element("div", { class: "view-controls" }, ...choices,
    choiceOf<Side>(texts.lookFrom, Object.entries(texts.sides) as [Side, string][], null,
      (side) => view.lookFrom(side)),
    pause);
}
