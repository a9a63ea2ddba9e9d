import { ParameterType, type JsPsych, type JsPsychPlugin, type TrialType } from "jspsych";
import { button, element, heading } from "./elements";
import type { Texts } from "./texts";

const info = {
  name: "mien-load-page",
  version: "1.0.0",
  parameters: {
    words: { type: ParameterType.OBJECT, default: null },
    /** Loads what is missing and tells how far it is; throws when that cannot be had. */
    load: { type: ParameterType.FUNCTION, default: null },
  },
  data: {},
} as const;

type Load = (told: (done: number, all: number) => void) => Promise<void>;

/** Waits until all that a session shows is here. */
export class LoadPage implements JsPsychPlugin<typeof info> {
  static info = info;
  constructor(private jsPsych: JsPsych) {}

  trial(display: HTMLElement, trial: TrialType<typeof info>): void {
    const texts = trial.words as Texts;
    const load = trial.load as Load;
    const bar = element("progress", { "aria-label": texts.preparing });
    const note = element("p", { role: "status" });
    const page = element("article", { class: "page" }, heading(texts.preparing), bar, note);
    const again = button(texts.again, () => void attempt(), "main");
    const without = button(texts.goOnWithout, () => this.jsPsych.finishTrial({}));
    let failures = 0;
    const attempt = async () => {
      again.remove();
      without.remove();
      try {
        await load((done, all) => {
          bar.max = Math.max(all, 1);
          bar.value = done;
          note.textContent = texts.preparingOf({ done, all });
        });
        this.jsPsych.finishTrial({});
      } catch (error) {
        console.error(error);
        note.textContent = texts.loadFailed;
        failures += 1;
        page.append(again);
        if (failures > 1) page.append(without);
        again.focus();
      }
    };
    display.replaceChildren(page);
    void attempt();
  }
}
