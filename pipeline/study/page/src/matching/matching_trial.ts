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
 * A blind run ends with its guess, of which nothing is shown; go_on takes such a guess up in another run.
 */
export class MatchingRun {
  private began = performance.now();
  private changes: MatchingChange[] = [];
  private first: LiveSetting | null = null;
  private first_d = 0;
  private last: LiveSetting | null = null;
  private last_d = 0;
  private guess_s = 0;
  private is_over = false;
  private is_late = false;
  private is_making = false;
  /** Asked for and not made yet, with the number of the change that it came of. */
  private wish: { setting: LiveSetting; change: number } | null = null;
  private limit: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private target: string, private settings: MatchingSettings, private core: LiveCore, private view: FigureView,
    private panel: SliderPanel, private attempt: number, private told: MatchingEvents, private is_blind = false,
  ) {}

  /** Seconds since the trial began. */
  private now(): number {
    return Math.round(performance.now() - this.began) / 1000;
  }

  /** Seconds that are left; all of them before the clock runs. */
  seconds_left(): number {
    if (!this.first) return this.settings.limit_s;
    return Math.max(0, this.settings.limit_s - (this.now() - this.guess_s));
  }

  changed({ action, slider, value }: SliderChange): void {
    if (this.is_over) return;
    const step = this.first ? "adjust" : "guess";
    this.changes.push({ s: this.now(), step, action, slider, value });
    if (!this.first) return;
    this.wish = { setting: this.panel.setting(), change: this.changes.length - 1 };
    void this.make();
  }

  async guess(): Promise<void> {
    if (this.first || this.is_making) return;
    this.is_making = true;
    // What is moved meanwhile would be no part of the guess.
    this.panel.lock(true);
    try {
      const s = this.now();
      const setting = this.panel.setting();
      if (this.is_blind) return await this.guess_blind(s, setting);
      const d = await this.show(setting);
      this.changes.push({ s, step: "guess", action: "guess", d });
      this.first_d = d;
      // The clock runs from when the motion is seen.
      this.guess_s = this.now();
      this.begin(setting);
    } catch (error) {
      this.is_making = false;
      this.panel.lock(false);
      this.told.failed(error);
    }
  }

  /** With a guess of a blind run, whose motion is shown now. */
  async go_on(guess: Guess): Promise<void> {
    if (this.first || this.is_making) return;
    this.is_making = true;
    try {
      const setting = this.panel.setting();
      await this.show(setting);
      this.changes = [...guess.changes];
      this.first_d = guess.d;
      this.guess_s = guess.s;
      this.began = performance.now() - 1000 * guess.s;
      this.begin(setting);
    } catch (error) {
      this.is_making = false;
      this.told.failed(error);
    }
  }

  private async guess_blind(s: number, setting: LiveSetting): Promise<void> {
    const { D } = await this.core.distance(this.target, setting);
    this.changes.push({ s, step: "guess", action: "guess", d: D });
    this.release();
    const { sliders, values } = setting;
    this.told.guessed({ first: { sliders, values }, d: D, s, attempt: this.attempt, changes: this.changes });
  }

  private begin(setting: LiveSetting): void {
    this.first = setting;
    this.is_making = false;
    this.panel.lock(false);
    this.told.adjusting();
    this.told.distance(this.last_d);
    if (this.last_d < this.settings.threshold_m) return this.end("match", this.guess_s);
    this.limit = setTimeout(() => void this.run_out(), this.settings.limit_s * 1000);
  }

  /** Nothing more comes of it. */
  release(): void {
    this.is_over = true;
    clearTimeout(this.limit);
  }

  private async show(setting: LiveSetting): Promise<number> {
    this.view.expect_motion();
    const shown = this.core.make(setting).then((motion) => this.view.show(1, motion));
    const [{ D }] = await Promise.all([this.core.distance(this.target, setting), shown]);
    this.last = setting;
    this.last_d = D;
    return D;
  }

  private async make(): Promise<void> {
    if (this.is_making) return;
    this.is_making = true;
    try {
      while (this.wish && !this.is_over) {
        const { setting, change } = this.wish;
        this.wish = null;
        const d = await this.show(setting);
        const made = this.changes[change]!;
        made.d = d;
        this.told.distance(d);
        if (d < this.settings.threshold_m) return this.end("match", made.s);
      }
      if (this.is_late) this.end("limit", this.guess_s + this.settings.limit_s);
    } catch (error) {
      this.told.failed(error);
      if (this.is_late) this.end("limit", this.guess_s + this.settings.limit_s);
    } finally {
      this.is_making = false;
    }
  }

  /** What was moved before the limit still counts. */
  private async run_out(): Promise<void> {
    this.is_late = true;
    this.panel.lock(true);
    if (!this.is_making) await this.make();
  }

  private end(action: "match" | "limit", s: number): void {
    if (this.is_over) return;
    this.release();
    this.panel.lock(true);
    this.panel.put(this.last!);
    // A change that came while the match was found is of nothing any more.
    this.changes = this.changes.filter((change) => change.s <= s);
    const end = Math.max(s, this.changes[this.changes.length - 1]?.s ?? 0);
    this.changes.push({ s: end, step: "adjust", action, d: this.last_d });
    const given = ({ sliders, values }: LiveSetting) => ({ sliders, values });
    const success = action === "match";
    this.told.ended({
      first: given(this.first!), first_guess_d: this.first_d, guess_s: this.guess_s,
      last: given(this.last!), d: this.last_d, success, attempt: this.attempt,
      time_s: success ? Math.round((s - this.guess_s) * 1000) / 1000 : this.settings.limit_s,
      changes: this.changes,
    });
  }
}
