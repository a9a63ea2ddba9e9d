import { Stage } from "./stage";
import type { TraceFilm } from "./trials/trial_kind";

/** A film that is played once to its end while it is rated; a new attempt begins anew. */
export class ContinuousStage extends Stage implements TraceFilm {
  private beginnings: (() => void)[] = [];

  onBegin(listener: () => void): void {
    this.beginnings.push(listener);
  }

  isPlaying(): boolean {
    return this.state === "playing";
  }

  hasEnded(): boolean {
    return this.played.ended > 0;
  }

  time(): number {
    return this.screens[0]?.time?.() ?? 0;
  }

  /** The marker can be moved before the film. */
  override isWatched(): boolean {
    return true;
  }

  /** What was seen before a reload has no answer. */
  override canPlay(): boolean {
    return this.state === "covered" && !this.hasEnded();
  }

  override play(): void {
    if (!this.canPlay()) return;
    for (const listener of this.beginnings) listener();
    super.play();
  }

  protected override isFirst(): boolean {
    return !this.hasEnded();
  }
}
