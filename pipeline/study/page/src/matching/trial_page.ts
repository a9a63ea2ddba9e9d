import { FigureView } from "../figure/figure_view";
import type { LiveCore } from "../live/core";
import { button, element, heading } from "../questionnaire/elements";
import type { PageRecord } from "../questionnaire/experiment";
import { countBlurs } from "../questionnaire/measures";
import type { Texts } from "../questionnaire/texts";
import { numberText } from "../texts/phrase";
import { ExamplesFilm } from "./examples_film";
import type { MatchingExperiment, MatchingTrial } from "./experiment";
import type { Guess, MatchingRecord } from "./record";
import { MatchingRun } from "./matching_trial";
import { SliderPanel, type SliderChange } from "./slider_panel";
import type { MatchingTexts } from "../live_study/texts";
import { seeingControls, type Seeing } from "./seeing";

/** What all trials of a session have in common. */
export interface MatchingSurroundings {
  experiment: MatchingExperiment;
  core: LiveCore;
  /** Random name of this browser session. */
  name: string;
  texts: Texts;
  words: MatchingTexts;
  seeing: Seeing;
}

const clockText = (seconds: number): string => {
  const whole = Math.ceil(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
};

const centimetres = (metres: number, language: string): string => numberText(100 * metres, language, 1);

/** What tells how near the motion is and how long it may take. */
class Readings {
  readonly element: HTMLElement;
  private clock = element("span", { class: "clock" });
  private distance = element("output", { class: "distance", "aria-live": "off" }, "–");
  private bar = element("div", { class: "near" }, element("div"));
  private timer: ReturnType<typeof setInterval> | undefined;

  constructor(private experiment: MatchingExperiment, private words: MatchingTexts) {
    const { threshold_m: thresholdM, shows_distance: showsDistance, limit_s: limitS } = experiment.matching;
    this.clock.textContent = clockText(limitS);
    this.element = element("div", { class: "readings" },
      element("p", {}, `${words.clock}: `, this.clock));
    this.bar.setAttribute("aria-hidden", "true");
    if (showsDistance)
      this.element.append(
        element("p", {}, `${words.distance}: `, this.distance, " ", element("span", { class: "goal" },
          `(${words.goal({ centimetres: centimetres(thresholdM, experiment.language) })})`)), this.bar);
  }

  tell(d: number): void {
    const { threshold_m: thresholdM } = this.experiment.matching;
    this.distance.textContent = this.words.length({ centimetres: centimetres(d, this.experiment.language) });
    this.element.dataset.d = String(d);
    const share = Math.min(1, thresholdM / Math.max(d, 1e-6));
    (this.bar.firstElementChild as HTMLElement).style.width = `${Math.round(100 * share)}%`;
    this.bar.classList.toggle("reached", d < thresholdM);
  }

  run(secondsLeft: () => number): void {
    this.timer = setInterval(() => { this.clock.textContent = clockText(secondsLeft()); }, 200);
  }

  stop(): void {
    clearInterval(this.timer);
  }
}

function keyOfColours(experiment: MatchingExperiment, words: MatchingTexts): HTMLElement {
  const { target_colour: targetColour, created_colour: createdColour } = experiment.matching;
  const one = (colour: string, text: string) => {
    const dot = element("span", { class: "dot", "aria-hidden": "true" });
    dot.style.background = colour;
    return element("span", { class: "colour" }, dot, text);
  };
  return element("p", { class: "key" }, one(targetColour, words.target), one(createdColour, words.mine));
}

/** What is on the screen of a trial. */
interface Shown {
  page: HTMLElement;
  step: HTMLElement;
  note: HTMLElement;
  status: HTMLElement;
  readings: Readings;
  panel: SliderPanel;
  view: FigureView;
  release(): void;
}

/** Shows the target alone, the sliders, and buttons below them. */
async function showTrial(
  display: HTMLElement, trial: MatchingTrial, title: string, around: MatchingSurroundings,
  changed: (change: SliderChange) => void, buttons: HTMLButtonElement[],
): Promise<Shown> {
  const { experiment, core, words, seeing } = around;
  const { matching } = experiment;
  const target = await core.target(trial.target);
  const view = new FigureView(core.info.body, [matching.target_colour, matching.created_colour], words.view);
  view.show(0, target);
  const readings = new Readings(experiment, words);
  const head = heading(title);
  const step = element("h2", {}, words.guessStep);
  const note = element("p", { class: "step-note" }, words.guessNote);
  const status = element("p", { class: "matching-status", role: "status" });
  const panel = new SliderPanel(trial.interface, matching.sliders[trial.interface]!, core.info,
    experiment.language, words, changed);
  const film = matching.shows_examples ? new ExamplesFilm(core, words) : null;
  const page = element("article", { class: `matching${film ? " with-examples" : ""}`, "data-step": "guess",
    "data-interface": trial.interface },
    element("header", { class: "matching-head" }, head, readings.element),
    element("div", { class: "stage" }, view.element, keyOfColours(experiment, words),
      seeingControls(view, seeing, words), ...(film ? [film.element] : [])),
    element("section", { class: "control", "aria-label": words.interfaces[trial.interface] },
      step, note, panel.element, status, element("div", { class: "buttons" }, ...buttons)));
  display.replaceChildren(page);
  scrollTo(0, 0);
  head.focus();
  const release = (): void => {
    film?.release();
    view.release();
  };
  return { page, step, note, status, readings, panel, view, release };
}

/** Shows the target alone until a guess is made; nothing is seen of what comes of it. */
export async function runGuess(
  display: HTMLElement, trial: MatchingTrial, title: string, attempt: number, around: MatchingSurroundings,
): Promise<Guess> {
  const { experiment, core, words } = around;
  let run: MatchingRun;
  const take = button(words.takeGuess, () => void run.guess(), "main");
  const { status, panel, view, release } =
    await showTrial(display, trial, title, around, (change) => run.changed(change), [take]);
  if (attempt > 1) status.textContent = words.begunAnew;
  const guess = await new Promise<Guess>((resolve) => {
    run = new MatchingRun(trial.target, experiment.matching, core, view, panel, attempt, {
      adjusting() {}, distance() {}, ended() {},
      guessed: resolve,
      failed(error) {
        console.error(error);
        status.textContent = words.lostCore;
      },
    }, true);
  });
  release();
  return guess;
}

/**
 * Shows a trial until it is over and the participant goes on; what is to be kept of it. With a guess that was
 * made before, the trial begins with its motion.
 */
export async function runTrial(
  display: HTMLElement, trial: MatchingTrial, title: string, attempt: number, around: MatchingSurroundings,
  given?: Guess,
): Promise<PageRecord> {
  const { experiment, core, texts, words } = around;
  const startedAt = new Date().toISOString();
  const began = performance.now();
  const blurs = countBlurs();
  let run: MatchingRun;
  let goOn: () => void = () => {};
  const goneOn = new Promise<void>((resolve) => { goOn = resolve; });
  const showMine = button(words.showMine, () => void (given ? run.goOn(given) : run.guess()), "main");
  const next = button(texts.next, () => goOn(), "main");
  next.hidden = true;
  const { page, step, note, status, readings, panel, view, release } =
    await showTrial(display, trial, title, around, (change) => run.changed(change), [showMine, next]);
  const tellAdjust = (): void => {
    step.textContent = words.adjustStep;
    note.textContent = words.adjustNote;
  };
  const isAnew = given ? attempt > given.attempt : attempt > 1;
  if (isAnew) status.textContent = words.begunAnew;

  const over = new Promise<MatchingRecord>((resolve) => {
    run = new MatchingRun(trial.target, experiment.matching, core, view, panel, attempt, {
      adjusting() {
        tellAdjust();
        status.textContent = given && isAnew ? words.begunAnew : "";
        page.dataset.step = "adjust";
        showMine.remove();
        readings.run(() => run.secondsLeft());
        panel.focus();
      },
      distance: (d) => readings.tell(d),
      guessed() {},
      ended(record) {
        readings.stop();
        page.dataset.step = "over";
        const seconds = Math.round(record.time_s);
        status.textContent = !record.success ? words.over : record.time_s === 0 ? words.matchedAtOnce
          : words.matched({ seconds });
        status.classList.add(record.success ? "good" : "late");
        next.hidden = false;
        next.focus();
        resolve(record);
      },
      failed(error) {
        console.error(error);
        status.textContent = words.lostCore;
        // Where it was not asked for by hand, it can be from now on.
        showMine.hidden = false;
      },
    });
  });
  if (given) {
    tellAdjust();
    page.dataset.step = "show";
    panel.put(given.first);
    panel.lock(true);
    showMine.hidden = true;
    void run!.goOn(given);
  }

  const matched = await over;
  const trialMs = Math.round(performance.now() - began + (given ? 1000 * given.s : 0));
  await goneOn;
  release();
  return {
    record: `trial-${trial.number}`, session: around.name, responses: [], comment: "", started_at: startedAt, trial_ms: trialMs,
    ...blurs(), viewport_width: innerWidth, viewport_height: innerHeight, matching: matched,
  };
}
