import { FigureView } from "../figure/figure_view";
import type { LiveCore, LiveMotion } from "../live/core";
import { button, element } from "../questionnaire/elements";
import type { MatchingTexts } from "../live_study/texts";

const exampleMs = 4000;

/** What shows the examples one after the other, each for some seconds, with their names. `release` ends it. */
export class ExamplesFilm {
  readonly element: HTMLElement;
  private view: FigureView;
  private name = element("span", { class: "example-name" });
  private timer: ReturnType<typeof setInterval> | undefined;
  private made = new Map<string, LiveMotion>();
  private at = -1;

  constructor(private core: LiveCore, words: MatchingTexts) {
    this.view = new FigureView(core.info.body, ["#c9c9c9"], words.examplesView);
    const pause = button(words.pause, () => {
      const goesOn = this.timer === undefined;
      if (goesOn) this.play();
      else this.pause();
      pause.textContent = goesOn ? words.pause : words.play;
    }, "small");
    const next = button(words.nextExample, () => void this.next(), "small");
    this.element = element("section", { class: "examples-film", "aria-label": words.examples },
      this.view.element,
      element("div", {}, element("p", {}, `${words.examples}: `, this.name),
        element("div", { class: "choice-of" }, pause, next)));
    this.play();
    void this.next();
  }

  release(): void {
    this.pause();
    this.view.release();
  }

  private play(): void {
    this.view.play();
    this.timer = setInterval(() => void this.next(), exampleMs);
  }

  private pause(): void {
    this.view.pause();
    clearInterval(this.timer);
    this.timer = undefined;
  }

  private async next(): Promise<void> {
    const { examples } = this.core.info;
    this.at = (this.at + 1) % examples.length;
    const example = examples[this.at]!;
    try {
      const motion = this.made.get(example) ?? await this.core.example(example);
      this.made.set(example, motion);
      if (examples[this.at] !== example) return;  // the next one was quicker
      this.view.show(0, motion);
      this.name.textContent = example;
    } catch (error) {
      console.error(error);
    }
  }
}
