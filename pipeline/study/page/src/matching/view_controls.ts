import type { FigureView, Side } from "../figure/figure_view";
import { button, element } from "../questionnaire/elements";
import type { MatchingTexts } from "./texts";

/** Buttons of which one is pressed. */
function choice_of<Value extends string>(
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

export function view_controls(view: FigureView, seeing: Seeing, texts: MatchingTexts): HTMLElement {
  view.arrange(seeing.arrangement);
  view.keep(seeing.step);
  const pause = button(texts.pause, () => {
    if (view.plays()) view.pause();
    else view.play();
    pause.textContent = view.plays() ? texts.pause : texts.play;
  }, "small");
  return element("div", { class: "view-controls" },
    choice_of(texts.arrange, [["over", texts.over_each_other], ["beside", texts.beside]], seeing.arrangement,
      (value) => view.arrange(seeing.arrangement = value)),
    choice_of(texts.step, [["keytimes", texts.in_step], ["time", texts.own_tempo]], seeing.step,
      (value) => view.keep(seeing.step = value)),
    choice_of<Side>(texts.look_from, Object.entries(texts.sides) as [Side, string][], null,
      (side) => view.look_from(side)),
    pause);
}
