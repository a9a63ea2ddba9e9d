import type { FigureView, Side } from "../figure/figure_view";
import { button, element } from "../questionnaire/elements";
import type { MatchingTexts } from "./texts";

/** Buttons of which one is pressed. */
function choiceOf<Value extends string>(
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

/** How the figures are seen; what was chosen stays for the following trials. */
export interface Seeing {
  arrangement: "over" | "beside";
  step: "keytimes" | "time";
}

export function viewControls(view: FigureView, seeing: Seeing, texts: MatchingTexts): HTMLElement {
  view.arrange(seeing.arrangement);
  view.keep(seeing.step);
  const pause = button(texts.pause, () => {
    if (view.plays()) view.pause();
    else view.play();
    pause.textContent = view.plays() ? texts.pause : texts.play;
  }, "small");
  return element("div", { class: "view-controls" },
    choiceOf(texts.arrange, [["over", texts.overEachOther], ["beside", texts.beside]], seeing.arrangement,
      (value) => view.arrange(seeing.arrangement = value)),
    choiceOf(texts.step, [["keytimes", texts.inStep], ["time", texts.ownTempo]], seeing.step,
      (value) => view.keep(seeing.step = value)),
    choiceOf<Side>(texts.lookFrom, Object.entries(texts.sides) as [Side, string][], null,
      (side) => view.lookFrom(side)),
    pause);
}
