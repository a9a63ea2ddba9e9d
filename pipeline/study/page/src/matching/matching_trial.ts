import type { FigureView } from "../figure/figure_view";
import type { LiveCore, LiveSetting } from "../live/core";
import type { MatchingSettings } from "./experiment";
import type { Guess, MatchingChange, MatchingRecord } from "./record";
import type { SliderChange, SliderPanel } from "./slider_panel";

/** What the page is told while somebody matches. */
export interface MatchingEvents {
  /** The created motion is there for the first time, and the clock runs. */
  adjusting(): void;
  distance(d: number): void;
  /** Of a blind run: the guess is made, and that was all. */
  guessed(guess: Guess): void;
  /** The trial is over. */
  ended(record: MatchingRecord): void;
  failed(error: unknown): void;
}

/**
 * One trial: a guess that is made without seeing what comes of it, then adjusting until D is below
 * the threshold or the limit is over. Of sliders that are moved faster than motions are made, the
 * last setting is made; every change is noted with its time all the same.
 *
 * A blind run ends with its guess, of which nothing is shown; goOn takes such a guess up in another run.
 */
export class MatchingRun {
  private began = performance.now();
  private changes: MatchingChange[] = [];
  private first: LiveSetting | null = null;
  private firstD = 0;
  private last: LiveSetting | null = null;
  private lastD = 0;
  private guessSeconds = 0;
  private isOver = false;
  private isLate = false;
  private isMaking = false;
  /** Asked for and not made yet, with the number of the change that it came of. */
  private wish: { setting: LiveSetting; change: number } | null = null;
  private limit: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private target: string, private settings: MatchingSettings, private core: LiveCore, private view: FigureView,
    private panel: SliderPanel, private attempt: number, private told: MatchingEvents, private isBlind = false,
  ) {}

  /** Seconds since the trial began. */
  private now(): number {
    return Math.round(performance.now() - this.began) / 1000;
  }

  /** Seconds that are left; all of them before the clock runs. */
  secondsLeft(): number {
    if (!this.first) return this.settings.limit_s;
    return Math.max(0, this.settings.limit_s - (this.now() - this.guessSeconds));
  }

  changed({ action, slider, value }: SliderChange): void {
    if (this.isOver) return;
    const step = this.first ? "adjust" : "guess";
    this.changes.push({ s: this.now(), step, action, slider, value });
    if (!this.first) return;
    this.wish = { setting: this.panel.setting(), change: this.changes.length - 1 };
    void this.make();
  }

  async guess(): Promise<void> {
    if (this.first || this.isMaking) return;
    this.isMaking = true;
    // What is moved meanwhile would be no part of the guess.
    this.panel.lock(true);
    try {
      const s = this.now();
      const setting = this.panel.setting();
      if (this.isBlind) return await this.guessBlind(s, setting);
      const d = await this.show(setting);
      this.changes.push({ s, step: "guess", action: "guess", d });
      this.firstD = d;
      // The clock runs from when the motion is seen.
      this.guessSeconds = this.now();
      this.begin(setting);
    } catch (error) {
      this.isMaking = false;
      this.panel.lock(false);
      this.told.failed(error);
    }
  }

  /** With a guess of a blind run, whose motion is shown now. */
  async goOn(guess: Guess): Promise<void> {
    if (this.first || this.isMaking) return;
    this.isMaking = true;
    try {
      const setting = this.panel.setting();
      await this.show(setting);
      this.changes = [...guess.changes];
      this.firstD = guess.d;
      this.guessSeconds = guess.s;
      this.began = performance.now() - 1000 * guess.s;
      this.begin(setting);
    } catch (error) {
      this.isMaking = false;
      this.told.failed(error);
    }
  }

  private async guessBlind(s: number, setting: LiveSetting): Promise<void> {
    const { D } = await this.core.distance(this.target, setting);
    this.changes.push({ s, step: "guess", action: "guess", d: D });
    this.release();
    const { sliders, values } = setting;
    this.told.guessed({ first: { sliders, values }, d: D, s, attempt: this.attempt, changes: this.changes });
  }

  private begin(setting: LiveSetting): void {
    this.first = setting;
    this.isMaking = false;
    this.panel.lock(false);
    this.told.adjusting();
    this.told.distance(this.lastD);
    if (this.lastD < this.settings.threshold_m) return this.end("match", this.guessSeconds);
    this.limit = setTimeout(() => void this.runOut(), this.settings.limit_s * 1000);
  }

  /** Nothing more comes of it. */
  release(): void {
    this.isOver = true;
    clearTimeout(this.limit);
  }

  private async show(setting: LiveSetting): Promise<number> {
    this.view.expectMotion();
    const shown = this.core.make(setting).then((motion) => this.view.show(1, motion));
    const [{ D }] = await Promise.all([this.core.distance(this.target, setting), shown]);
    this.last = setting;
    this.lastD = D;
    return D;
  }

  private async make(): Promise<void> {
    if (this.isMaking) return;
    this.isMaking = true;
    try {
      while (this.wish && !this.isOver) {
        const { setting, change } = this.wish;
        this.wish = null;
        const d = await this.show(setting);
        const made = this.changes[change]!;
        made.d = d;
        this.told.distance(d);
        if (d < this.settings.threshold_m) return this.end("match", made.s);
      }
      if (this.isLate) this.end("limit", this.guessSeconds + this.settings.limit_s);
    } catch (error) {
      this.told.failed(error);
      if (this.isLate) this.end("limit", this.guessSeconds + this.settings.limit_s);
    } finally {
      this.isMaking = false;
    }
  }

  /** What was moved before the limit still counts. */
  private async runOut(): Promise<void> {
    this.isLate = true;
    this.panel.lock(true);
    if (!this.isMaking) await this.make();
  }

  private end(action: "match" | "limit", s: number): void {
    if (this.isOver) return;
    this.release();
    this.panel.lock(true);
    this.panel.put(this.last!);
    // A change that came while the match was found is of nothing any more.
    this.changes = this.changes.filter((change) => change.s <= s);
    const end = Math.max(s, this.changes[this.changes.length - 1]?.s ?? 0);
    this.changes.push({ s: end, step: "adjust", action, d: this.lastD });
    const given = ({ sliders, values }: LiveSetting) => ({ sliders, values });
    const success = action === "match";
    this.told.ended({
      first: given(this.first!), first_guess_d: this.firstD, guess_s: this.guessSeconds,
      last: given(this.last!), d: this.lastD, success, attempt: this.attempt,
      time_s: success ? Math.round((s - this.guessSeconds) * 1000) / 1000 : this.settings.limit_s,
      changes: this.changes,
    });
  }
}
