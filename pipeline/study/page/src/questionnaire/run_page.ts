import { ParameterType, type JsPsych, type JsPsychPlugin, type TrialType } from "jspsych";

const info = {
  name: "mien-run-page",
  version: "1.0.0",
  parameters: {
    /** Shows what it likes; the page is over when the promise is. */
    run: { type: ParameterType.FUNCTION, default: null },
  },
  data: {},
} as const;

/** A page that consists of a function. */
export class RunPage implements JsPsychPlugin<typeof info> {
  static info = info;
  constructor(private jsPsych: JsPsych) {}

  trial(display: HTMLElement, trial: TrialType<typeof info>): void {
    const run = trial.run as unknown as (display: HTMLElement) => Promise<void>;
    void run(display).then(() => this.jsPsych.finishTrial({}));
  }
}
