import { ParameterType, type JsPsych, type JsPsychPlugin, type TrialType } from "jspsych";
import { showTextPage, type AskedPage } from "./text_view";

const info = {
  name: "mien-text-page",
  version: "1.0.0",
  parameters: {
    title: { type: ParameterType.STRING, default: "" },
    texts: { type: ParameterType.STRING, array: true, default: [] },
    /** Labels of the buttons; the first goes on. */
    buttons: { type: ParameterType.STRING, array: true, default: [] },
    questions: { type: ParameterType.COMPLEX, array: true, default: [] },
    /** Label of a place for free words; empty for none. */
    comment: { type: ParameterType.STRING, default: "" },
    words: { type: ParameterType.OBJECT, default: null },
    /** Given what was pressed and answered; returns once it is kept. */
    keep: { type: ParameterType.FUNCTION, default: null },
  },
  data: {
    pressed: { type: ParameterType.INT },
  },
} as const;

/** A page of texts and questions: consent, instructions, about you, the ending. */
export class TextPage implements JsPsychPlugin<typeof info> {
  static info = info;
  constructor(private jsPsych: JsPsych) {}

  trial(display: HTMLElement, trial: TrialType<typeof info>): void {
    void showTextPage(display, trial as unknown as AskedPage)
      .then((pressed) => this.jsPsych.finishTrial({ pressed }));
  }
}
