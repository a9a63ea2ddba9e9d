import type { FigureView } from "../figure/figure_view";
import type { MatchingTexts } from "../live_study/texts";
import { choiceOf, viewControls } from "../live_study/view_controls";

/** How the figures are seen; what was chosen stays for the following trials. */
export interface Seeing {
  arrangement: "over" | "beside";
  step: "keytimes" | "time";
}

export function seeingControls(view: FigureView, seeing: Seeing, texts: MatchingTexts): HTMLElement {
  view.arrange(seeing.arrangement);
  view.keep(seeing.step);
  return viewControls(view, texts,
    choiceOf(texts.arrange, [["over", texts.overEachOther], ["beside", texts.beside]], seeing.arrangement,
      (value) => view.arrange(seeing.arrangement = value)),
    choiceOf(texts.step, [["keytimes", texts.inStep], ["time", texts.ownTempo]], seeing.step,
      (value) => view.keep(seeing.step = value)));
}
