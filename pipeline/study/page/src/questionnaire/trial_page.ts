import { ParameterType, type JsPsych, type JsPsychPlugin, type TrialType } from "jspsych";
import type { Tracks } from "./adaptive/tracks";
import { isMissing, responsesOf, type Asked } from "./answers";
import { TrialAttempt } from "./attempts";
import { button, element } from "./elements";
import type { Experiment, PageRecord, PlayFault, Session, Trial } from "./experiment";
import { countBlurs } from "./measures";
import type { Stock } from "./media";
import { ContinuousStage } from "./continuous_stage";
import { GridStage } from "./grid_stage";
import { Stage, type ShownMedia, type TrialStage } from "./stage";
import type { Texts } from "./texts";
import { kindOf } from "./trials/trial_kinds";

const info = {
  name: "mien-trial-page",
  version: "1.0.0",
  parameters: {
    asked: { type: ParameterType.OBJECT, default: null },
    shownIn: { type: ParameterType.OBJECT, default: null },
  },
  data: {
    record: { type: ParameterType.STRING },
  },
} as const;

/** What all trials of a session share. */
export interface TrialSurroundings {
  experiment: Experiment;
  session: Session;
  texts: Texts;
  stock: Stock;
  name: string;
  refresh_hz: number | null;
  /** Of adaptive trials: what chooses their levels. */
  tracks?: Tracks | undefined;
  keep(record: PageRecord, page: HTMLElement): Promise<void>;
}

function shownOf(trial: Trial, { experiment, stock }: TrialSurroundings): ShownMedia[] {
  const shown = (token: string, role: ShownMedia["role"]): ShownMedia => {
    const media = experiment.media[token]!;
    const figures = (media.figures ?? []).map((figure) => stock.get(figure) ?? "");
    return { token, url: figures.includes("") ? undefined : stock.get(token), figures, media, role };
  };
  const [first, second] = trial.media;
  if (trial.kind === "grid")
    return [...trial.media.map((token) => shown(token, "member")),
      ...(trial.reference ? [shown(trial.reference, "reference")] : [])];
  if (trial.media.length > 2) return trial.media.map((token) => shown(token, "member"));
  if (first && second) return [shown(first, "left"), shown(second, "right")];
  if (first && trial.reference) return [shown(first, "to_rate"), shown(trial.reference, "reference")];
  return first ? [shown(first, "alone")] : [];
}

/** The letters of the longest word, or part of a word between soft hyphens, in these elements; Chinese and Japanese break
    anywhere. */
function longestWord(elements: Iterable<Element>): number {
  const words = [...elements].flatMap(({ textContent }) => (textContent ?? "").split(/[\s/\u00ad-]+/));
  const broken = /[\p{Script=Han}\p{Script=Hiragana}\p{Script=Katakana}]/u;
  return Math.max(0, ...words.map((word) => (broken.test(word) ? 0 : [...word].length)));
}

/** The width that the longest word of the ends of scales needs, in its font's size. */
const poleWidth = (rows: HTMLElement): number => 0.65 * longestWord(rows.querySelectorAll(".pole"));

/** The width that answers need for no word below the points of a scale to be broken. */
function widthOfPoints(rows: HTMLElement): string {
  const scales = [...rows.querySelectorAll(".scale.dense")];
  const points = Math.max(0, ...scales.map((scale) => scale.querySelectorAll(".choice-note").length));
  return `calc(${points} * (${longestWord(rows.querySelectorAll(".choice-note"))} * 0.46rem + 12px) + 3.4rem)`;
}

/** One trial: stimuli, answers, a comment; done when all is answered. */
class TrialAtWork {
  private began = performance.now();
  private started_at = new Date().toISOString();
  private blurs = countBlurs();
  private page = element("article", { class: "trial" });
  private answers = element("div", { class: "answers" });
  private note = element("p", { class: "note", role: "status" });
  private next: HTMLButtonElement;
  private comment = element("textarea", { rows: "2", maxlength: "4000", id: "comment" });
  private asked: Asked[] = [];
  private stage: TrialStage | null = null;
  private grid: GridStage | undefined;
  private attempt: TrialAttempt;
  private answersSince = performance.now();
  private isOpen = false;
  private isDone = false;

  constructor(
    private display: HTMLElement, private trial: Trial, private around: TrialSurroundings,
    private done: (record: PageRecord) => void,
  ) {
    this.next = button(around.texts.next, () => void this.finish(), "main");
    this.attempt = new TrialAttempt(around.experiment, around.name, trial.number);
  }

  begin(): void {
    const { trial, around, page } = this;
    const { experiment, texts } = around;
    const shown = shownOf(trial, around);
    const grid = this.grid = trial.kind === "grid" ? new GridStage(shown, experiment.settings, texts, this.attempt, this.began,
      (fault) => void this.leaveOut(fault)) : undefined;
    const told = { began: () => { if (experiment.settings.watch === "free") this.open(); },
      ended: () => this.ended(), leftOut: (fault: PlayFault) => void this.leaveOut(fault) };
    const film = trial.kind === "continuous"
      ? new ContinuousStage(shown, experiment.settings, texts, this.attempt, this.began, told) : undefined;
    this.asked = kindOf(trial).ask({ trial, experiment, texts, grid, film,
      choices: around.session.choices ?? Object.keys(experiment.choices ?? {}),
      answered: (asked, isKey) => this.answered(asked, isKey) });
    const isWide = film ? true : grid ? grid.isWide : shown.length > 1 && experiment.settings.pairs !== "in_turn";
    page.classList.add(trial.kind, isWide ? "wide" : "narrow");
    if (experiment.settings.display) page.classList.add("fixed");
    if (!shown.length) page.classList.add("bare");
    page.append(this.head());
    this.stage = grid ?? film ?? null;
    if (!this.stage && shown.length)
      this.stage = new Stage(shown, experiment.settings, texts, this.attempt, this.began, told);
    if (this.stage) page.append(this.stage.root);
    const rows = element("div", { class: this.asked.length > 3 ? "rows many" : "rows" },
      ...this.asked.map(({ root }) => root));
    this.answers.append(element("h2", { class: "question-text" }, this.question()), rows,
      ...this.commentParts(),
      element("div", { class: "buttons" }, this.next, this.note));
    rows.style.setProperty("--pole", `${poleWidth(rows)}em`);
    page.style.setProperty("--points", widthOfPoints(rows));
    for (const legend of rows.querySelectorAll("legend"))
      if (legend.textContent === this.question()) legend.classList.add("unseen");
    page.append(this.answers);
    this.display.replaceChildren(page);
    scrollTo(0, 0);
    document.addEventListener("keydown", this.pressed);
    if (this.stage?.isWatched()) this.open();
    else if (this.stage) this.lock();
    else this.open();
    if (film) this.next.setAttribute("aria-disabled", "true");  // until the film has been rated
    film?.onBegin(() => {
      this.note.textContent = "";
      for (const { root } of this.asked) root.classList.remove("missing");
    });
    // Its buttons can have the focus once the films are loaded.
    grid?.onChange(() => {
      if (!page.contains(document.activeElement)) this.focusMissing();
      this.updateMissing();
    });
  }

  private async leaveOut(fault: PlayFault): Promise<void> {
    if (this.isDone) return;
    await this.keep({ ...this.record(), responses: [], play_fault: fault });
  }

  private head(): HTMLElement {
    const { trial, around } = this;
    const { texts, session } = around;
    const all = session.trials.length;
    const bar = element("progress", { max: String(all), value: String(trial.number - 1),
      "aria-label": texts.trialOf({ number: trial.number, all }) });
    const place = element("h1", { tabindex: "-1" }, texts.trialOf({ number: trial.number, all }));
    const head = element("header", { class: "trial-head" }, place, bar);
    if (trial.practice) place.append(" ", element("span", { class: "badge" }, texts.practice));
    return head;
  }

  private question(): string {
    const { trial, around } = this;
    const { texts, experiment } = around;
    const kind = kindOf(trial);
    return (!kind.isCheck && experiment.settings.question) || kind.question(trial, experiment, texts);
  }

  private commentParts(): HTMLElement[] {
    const { experiment, texts } = this.around;
    if (!experiment.settings.comments || kindOf(this.trial).isCheck) return [];
    return [element("div", { class: "asked comment" },
      element("label", { for: this.comment.id }, `${texts.comment} (${texts.optional})`), this.comment)];
  }

  /** No answers before the film was seen. */
  private lock(): void {
    const { texts, experiment } = this.around;
    this.answers.inert = true;
    this.answers.classList.add("locked");
    const watch = this.trial.media.length > 1 ? texts.watchAllFirst : texts.watchFirst;
    this.note.textContent = experiment.settings.watch === "full" ? watch : texts.playFirst;
    // The play button may be loading still; it has the focus once it can be pressed.
    const focus = () => {
      if (this.isDone || this.isOpen) return;
      this.stage!.focus();
      if (!this.page.contains(document.activeElement)) setTimeout(focus, 50);
    };
    focus();
  }

  private open(): void {
    if (this.isOpen) return;
    this.isOpen = true;
    this.answersSince = performance.now();
    this.answers.inert = false;
    this.answers.classList.remove("locked");
    this.note.textContent = "";
    this.asked[0]?.focus();
  }

  private ended(): void {
    this.open();
    this.next.removeAttribute("aria-disabled");
    // The marker has the focus, and can no longer be moved.
    if (this.trial.kind === "continuous") return this.focusMissing();
    // While it was replayed, the button that had the focus was hidden.
    if (!this.page.contains(document.activeElement)) this.focusMissing();
  }

  private focusMissing(): void {
    const [first] = this.missing();
    if (first) first.focus();
    else this.next.focus();
  }

  private answered(asked: Asked, isKey: boolean): void {
    this.updateMissing();
    if (!this.missing().length) this.note.textContent = "";
    if (!isKey) return;
    const after = this.asked[this.asked.indexOf(asked) + 1];
    if (after) after.focus();
    else this.next.focus();
  }

  private missing = (): Asked[] => this.asked.filter(isMissing);

  private sayMissing(missing: Asked[]): void {
    const { trial, around } = this;
    this.note.textContent = kindOf(trial).missingText?.(missing, around.texts, this.stage)
      ?? around.texts.missing({ count: missing.length });
    for (const one of this.asked) one.root.classList.toggle("missing", missing.includes(one));
  }

  /** What is still missing, where that was said. */
  private updateMissing(): void {
    if (this.note.textContent) this.sayMissing(this.missing());
  }

  /**
   * Space plays the stimulus again, also where answers are: whoever presses it once too often chooses nothing, unless
   * the participant went to an answer. Digits choose an answer to the first question without one, wherever the focus is;
   * in a grid, they play the films. Enter says what is missing, or goes to the button that confirms; it never chooses.
   */
  private pressed = (event: KeyboardEvent): void => {
    if (document.querySelector("dialog[open]")) return;
    const at = event.target as HTMLElement;
    const writes = at instanceof HTMLTextAreaElement ||
      (at instanceof HTMLInputElement && at.type === "text");
    const isButton = at instanceof HTMLButtonElement;
    const isChoice = at instanceof HTMLInputElement && at.type === "radio" && !at.checked;
    const isModified = event.ctrlKey || event.altKey || event.metaKey;
    if (event.key === " " && this.stage && !isButton && !writes && !isChoice) {
      event.preventDefault();
      this.stage.play();
    } else if (/^[1-9]$/.test(event.key) && !isModified && this.isOpen && !writes &&
        (this.grid || !this.answers.contains(at))) {
      const [first] = this.missing();
      if (this.grid) this.grid.playNumber(Number(event.key));
      else first?.root.dispatchEvent(new KeyboardEvent("keydown", { key: event.key }));
    } else if (event.key === "Enter" && !writes && !isButton && this.isOpen) {
      event.preventDefault();
      if (event.repeat) return;
      const own = this.asked.find(({ root }) => root.contains(at));
      const missing = this.missing();
      if (missing.length && (isChoice || !own || isMissing(own))) this.sayMissing(missing);
      this.focusMissing();
    }
  };

  private async finish(): Promise<void> {
    const missing = this.missing();
    if (this.isDone || !this.isOpen) return;
    if (missing.length) {
      this.sayMissing(missing);
      missing[0]!.focus();
      return;
    }
    await this.keep(this.record());
  }

  private async keep(record: PageRecord): Promise<void> {
    this.isDone = true;
    for (const one of this.page.querySelectorAll("button")) one.disabled = true;
    document.removeEventListener("keydown", this.pressed);
    await this.around.keep(record, this.page);
    this.attempt.end();
    this.stage?.release();
    this.done(record);
  }

  private record(): PageRecord {
    const { trial, around } = this;
    const tokens = trial.reference ? [...trial.media, trial.reference] : trial.media;
    const { number: attempt } = this.attempt;
    const seen = this.stage?.seen() ?? { attempt, replays: 0, play_start_ms: null, ended_ms: null, stalls: 0,
      stall_ms: 0, dropped_frames: null, volume_events: "" };
    return {
      record: `trial-${trial.number}`,
      session: around.name,
      responses: responsesOf(this.asked, this.answersSince),
      comment: this.comment.value.trim(),
      ...seen,
      trial_ms: Math.round(performance.now() - this.began),
      ...this.blurs(),
      viewport_width: innerWidth,
      viewport_height: innerHeight,
      refresh_hz: around.refresh_hz,
      ...this.stage?.shownSize(),
      media_sha256: tokens.map((token) => around.experiment.media[token]!.sha256),
      ...(trial.place !== undefined && { level: trial.place }),
      started_at: this.started_at,
    };
  }
}

/** The record of a trial of which nothing is shown, as its track has ended. */
const recordOfEndedTrack = (trial: Trial, { name }: TrialSurroundings): PageRecord => ({
  record: `trial-${trial.number}`, session: name, responses: [], comment: "",
  started_at: new Date().toISOString(), track_ended: true,
});

export class TrialPage implements JsPsychPlugin<typeof info> {
  static info = info;
  constructor(private jsPsych: JsPsych) {}

  trial(display: HTMLElement, trial: TrialType<typeof info>): void {
    const around = trial.shownIn as TrialSurroundings;
    const planned = trial.asked as Trial;
    const done = ({ record }: PageRecord) => this.jsPsych.finishTrial({ record });
    const shown = around.tracks ? around.tracks.next(planned) : planned;
    if (shown) return new TrialAtWork(display, shown, around, done).begin();
    const ended = recordOfEndedTrack(planned, around);
    void around.keep(ended, display).then(() => done(ended));
  }
}
