import { FigureView } from "../figure/figure_view";
import type { LiveCore } from "../live/core";
import type { MatchingTexts } from "../live_study/texts";
import { viewControls } from "../live_study/view_controls";
import { element, heading } from "../questionnaire/elements";
import type { PageRecord } from "../questionnaire/experiment";
import { countBlurs } from "../questionnaire/measures";
import { root } from "../questionnaire/surroundings";
import type { Texts } from "../questionnaire/texts";
import { ChoiceControl } from "./choice_control";
import type { ChainSettings, CheckSide } from "./experiment";
import { ShownMotions } from "./shown_motions";
import { SliderControl } from "./slider_control";
import { coordinateAt, settingAt, type Step, type StepAnswer } from "./steps";
import { withWord, type ChainTexts } from "./texts";

/** What the page of all trials is made of. */
export interface TrialSurroundings {
  chains: ChainSettings;
  core: LiveCore;
  texts: Texts;
  words: MatchingTexts;
  chainWords: ChainTexts;
}

/** What is measured of a trial. */
export type Measures = Pick<PageRecord,
  "started_at" | "trial_ms" | "blurs" | "blur_ms" | "viewport_width" | "viewport_height">;

const narrow = matchMedia("(max-width: 40rem)");

/** The page of all trials: figures, which keep walking as they are seen, and below them what the participant uses. */
export class TrialPage {
  private page: HTMLElement;
  private head = heading("");
  private progress = element("p", { class: "progress" });
  private status = element("p", { class: "chain-status", role: "status" });
  private controls: HTMLElement;
  private view: FigureView;
  private motions: ShownMotions;
  private slider: SliderControl | null = null;
  private choice: ChoiceControl | null = null;

  constructor(private around: TrialSurroundings) {
    const { chains, core, words, chainWords } = around;
    const isGibbs = chains.method === "gibbs";
    this.view = new FigureView(core.info.body, isGibbs ? [chains.colour] : [chains.colour, chains.colour],
      isGibbs ? chainWords.view : chainWords.viewOfTwo);
    this.view.keep("time");  // the tempo is part of how a motion looks
    this.motions = new ShownMotions(core, this.view, (has) => this.say(has ? words.lostCore : ""));
    if (isGibbs) this.slider = new SliderControl(chainWords, words);
    else this.choice = new ChoiceControl(chainWords);
    this.controls = (this.slider ?? this.choice)!.element;
    this.page = element("article", { class: `chains ${chains.method}` },
      element("header", { class: "chains-head" }, this.progress, this.head),
      element("div", { class: "stage" },
        element("div", { class: "figures" }, this.view.element, ...(isGibbs ? [] : [this.controls])),
        viewControls(this.view, words)),
      ...(isGibbs ? [this.controls] : []), this.status);
    this.arrange();
    narrow.addEventListener("change", this.arrange);
  }

  /** Where records are waited for. */
  get element(): HTMLElement {
    return this.page;
  }

  /** Shows a step until it is answered; then it stays on the screen, and nothing can be changed. */
  async run(step: Step, progress: string, said: string): Promise<{ answer: StepAnswer; measures: Measures }> {
    if (!this.page.isConnected) {
      this.fill(step, progress);
      root().replaceChildren(this.page);
      scrollTo(0, 0);
    }
    await this.motions.show(this.figuresAt(step));
    this.fill(step, progress);
    this.say(said);
    this.open(step);
    const startedAt = new Date().toISOString();
    const began = performance.now();
    const blurs = countBlurs();
    const answer = await this.answerTo(step);
    const trialMs = Math.round(performance.now() - began);
    this.controls.inert = true;
    await this.motions.shown();
    this.say("");
    return { answer, measures: { started_at: startedAt, trial_ms: trialMs, ...blurs(),
      viewport_width: innerWidth, viewport_height: innerHeight } };
  }

  release(): void {
    narrow.removeEventListener("change", this.arrange);
    this.view.release();
  }

  /** One below the other where the window is narrow. */
  private arrange = (): void => this.view.arrange(narrow.matches ? "below" : "beside");

  private figuresAt({ point, dimension, slider, proposal, proposal_first: isFirst }: Step) {
    const { chains } = this.around;
    if (slider) return [settingAt(this.pointAt(point, dimension!, SliderControl.shareAt(slider)), chains)];
    const both = isFirst ? [proposal!, point] : [point, proposal!];
    return both.map((one) => settingAt(one, chains));
  }

  private pointAt(point: number[], dimension: number, share: number): number[] {
    return point.map((one, d) => (d === dimension ? coordinateAt(share, this.around.chains.dimensions[d]!) : one));
  }

  private fill(step: Step, progress: string): void {
    const { chains, texts, chainWords } = this.around;
    const word = chains.words[step.word] ?? step.word;
    this.progress.textContent = progress;
    this.head.replaceChildren(...(step.expected ? [new Text(this.checkText(step.expected))]
      : withWord(this.slider ? chainWords.make : texts.whichIsMore, word)));
  }

  private checkText(expected: CheckSide): string {
    const { chainWords } = this.around;
    if (!this.slider) return chainWords.checkFigure({ number: expected === "left" ? 1 : 2 });
    return expected === "left" ? chainWords.checkLeft : chainWords.checkRight;
  }

  /** `data-step` says which step is shown, `data-count` the how manieth on this page it is,
      `data-check` what an attention check asks for. */
  private open({ word, chain, step, expected }: Step): void {
    const { dataset } = this.page;
    if (expected) dataset.check = expected;
    else delete dataset.check;
    dataset.step = `${word}/${chain}/${step}`;
    dataset.count = String(Number(dataset.count ?? 0) + 1);
    this.controls.inert = false;
  }

  private async answerTo(step: Step): Promise<StepAnswer> {
    if (this.slider) return this.slide(step, this.slider);
    this.head.focus({ preventScroll: true });
    const place = await this.choice!.ask();
    return { chose_proposal: (place === 0) === step.proposal_first, moves: 0 };
  }

  private async slide({ point, dimension, slider }: Step, control: SliderControl): Promise<StepAnswer> {
    const { chains, chainWords } = this.around;
    const answered = control.ask(slider!, (share) => {
      this.say("");
      void this.motions.show([settingAt(this.pointAt(point, dimension!, share), chains)]);
    }, () => this.say(chainWords.moveFirst));
    control.focus();
    const { share, moves } = await answered;
    return { value: coordinateAt(share, chains.dimensions[dimension!]!), moves };
  }

  private say(text: string): void {
    this.status.textContent = text;
  }
}
