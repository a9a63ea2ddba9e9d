import { FigureView } from "../figure/figure_view";
import type { LiveCore } from "../live/core";
import { button, element, heading } from "../questionnaire/elements";
import type { PageRecord } from "../questionnaire/experiment";
import { count_blurs } from "../questionnaire/measures";
import type { Texts } from "../questionnaire/texts";
import { ExamplesFilm } from "./examples_film";
import type { MatchingExperiment, MatchingTrial } from "./experiment";
import type { Guess, MatchingRecord } from "./record";
import { MatchingRun } from "./matching_trial";
import { SliderPanel, type SliderChange } from "./slider_panel";
import type { MatchingTexts } from "./texts";
import { view_controls, type Seeing } from "./view_controls";

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

const clock_text = (seconds: number): string => {
  const whole = Math.ceil(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
};

const centimetres = (metres: number): string => (100 * metres).toFixed(1);

/** What tells how near the motion is and how long it may take. */
class Readings {
  readonly element: HTMLElement;
  private clock = element("span", { class: "clock" });
  private distance = element("output", { class: "distance", "aria-live": "off" }, "–");
  private bar = element("div", { class: "near" }, element("div"));
  private timer: ReturnType<typeof setInterval> | undefined;

  constructor(private experiment: MatchingExperiment, words: MatchingTexts) {
    const { threshold_m, shows_distance, limit_s } = experiment.matching;
    this.clock.textContent = clock_text(limit_s);
    this.element = element("div", { class: "readings" },
      element("p", {}, `${words.clock}: `, this.clock));
    this.bar.setAttribute("aria-hidden", "true");
    if (shows_distance)
      this.element.append(
        element("p", {}, `${words.distance}: `, this.distance, " cm ",
          element("span", { class: "goal" }, `(${words.goal(centimetres(threshold_m))})`)), this.bar);
  }

  tell(d: number): void {
    const { threshold_m } = this.experiment.matching;
    this.distance.textContent = centimetres(d);
    this.element.dataset.d = String(d);
    const share = Math.min(1, threshold_m / Math.max(d, 1e-6));
    (this.bar.firstElementChild as HTMLElement).style.width = `${Math.round(100 * share)}%`;
    this.bar.classList.toggle("reached", d < threshold_m);
  }

  run(seconds_left: () => number): void {
    this.timer = setInterval(() => { this.clock.textContent = clock_text(seconds_left()); }, 200);
  }

  stop(): void {
    clearInterval(this.timer);
  }
}

function key_of_colours(experiment: MatchingExperiment, words: MatchingTexts): HTMLElement {
  const { target_colour, created_colour } = experiment.matching;
  const one = (colour: string, text: string) => {
    const dot = element("span", { class: "dot", "aria-hidden": "true" });
    dot.style.background = colour;
    return element("span", { class: "colour" }, dot, text);
  };
  return element("p", { class: "key" }, one(target_colour, words.target), one(created_colour, words.mine));
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
async function show_trial(
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
  const step = element("h2", {}, words.guess_step);
  const note = element("p", { class: "step-note" }, words.guess_note);
  const status = element("p", { class: "matching-status", role: "status" });
  const panel = new SliderPanel(trial.interface, matching.sliders[trial.interface]!, core.info,
    experiment.language, words, changed);
  const film = matching.shows_examples ? new ExamplesFilm(core, words) : null;
  const page = element("article", { class: `matching${film ? " with-examples" : ""}`, "data-step": "guess",
    "data-interface": trial.interface },
    element("header", { class: "matching-head" }, head, readings.element),
    element("div", { class: "stage" }, view.element, key_of_colours(experiment, words),
      view_controls(view, seeing, words), ...(film ? [film.element] : [])),
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
export async function run_guess(
  display: HTMLElement, trial: MatchingTrial, title: string, attempt: number, around: MatchingSurroundings,
): Promise<Guess> {
  const { experiment, core, words } = around;
  let run: MatchingRun;
  const take = button(words.take_guess, () => void run.guess(), "main");
  const { status, panel, view, release } =
    await show_trial(display, trial, title, around, (change) => run.changed(change), [take]);
  if (attempt > 1) status.textContent = words.begun_anew;
  const guess = await new Promise<Guess>((resolve) => {
    run = new MatchingRun(trial.target, experiment.matching, core, view, panel, attempt, {
      adjusting() {}, distance() {}, ended() {},
      guessed: resolve,
      failed(error) {
        console.error(error);
        status.textContent = words.lost_core;
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
export async function run_trial(
  display: HTMLElement, trial: MatchingTrial, title: string, attempt: number, around: MatchingSurroundings,
  given?: Guess,
): Promise<PageRecord> {
  const { experiment, core, texts, words } = around;
  const started_at = new Date().toISOString();
  const began = performance.now();
  const blurs = count_blurs();
  let run: MatchingRun;
  let go_on: () => void = () => {};
  const gone_on = new Promise<void>((resolve) => { go_on = resolve; });
  const show_mine = button(words.show_mine, () => void (given ? run.go_on(given) : run.guess()), "main");
  const next = button(texts.next, () => go_on(), "main");
  next.hidden = true;
  const { page, step, note, status, readings, panel, view, release } =
    await show_trial(display, trial, title, around, (change) => run.changed(change), [show_mine, next]);
  const tell_adjust = (): void => {
    step.textContent = words.adjust_step;
    note.textContent = words.adjust_note;
  };
  const is_anew = given ? attempt > given.attempt : attempt > 1;
  if (is_anew) status.textContent = words.begun_anew;

  const over = new Promise<MatchingRecord>((resolve) => {
    run = new MatchingRun(trial.target, experiment.matching, core, view, panel, attempt, {
      adjusting() {
        tell_adjust();
        status.textContent = given && is_anew ? words.begun_anew : "";
        page.dataset.step = "adjust";
        show_mine.remove();
        readings.run(() => run.seconds_left());
        panel.focus();
      },
      distance: (d) => readings.tell(d),
      guessed() {},
      ended(record) {
        readings.stop();
        page.dataset.step = "over";
        const seconds = Math.round(record.time_s);
        status.textContent = !record.success ? words.over : record.time_s === 0 ? words.matched_at_once
          : words.matched(seconds);
        status.classList.add(record.success ? "good" : "late");
        next.hidden = false;
        next.focus();
        resolve(record);
      },
      failed(error) {
        console.error(error);
        status.textContent = words.lost_core;
        // Where it was not asked for by hand, it can be from now on.
        show_mine.hidden = false;
      },
    });
  });
  if (given) {
    tell_adjust();
    page.dataset.step = "show";
    panel.put(given.first);
    panel.lock(true);
    show_mine.hidden = true;
    void run!.go_on(given);
  }

  const matched = await over;
  const trial_ms = Math.round(performance.now() - began + (given ? 1000 * given.s : 0));
  await gone_on;
  release();
  return {
    record: `trial-${trial.number}`, session: around.name, responses: [], comment: "", started_at, trial_ms,
    blurs: blurs(), viewport_width: innerWidth, viewport_height: innerHeight, matching: matched,
  };
}
