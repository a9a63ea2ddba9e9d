import { element } from "../questionnaire/elements";
import type { View } from "./painting";

/** What plays in the clock's place, and tells it of its frames. */
export interface Driver {
  play(): void;
  stop(): void;
}

/** The frame that all views of a stimulus show. */
export class Clock {
  driver: Driver | null = null;
  private readonly listeners: (() => void)[] = [];
  private began: number | null = null;

  constructor(readonly count: number, readonly fps: number, public frame: number) {}

  seconds = (): number => this.frame / this.fps;
  frameAt = (seconds: number): number => Math.min(this.count - 1, Math.max(0, Math.round(seconds * this.fps)));
  isPlaying = (): boolean => this.began !== null;

  onFrame(listener: () => void): void {
    this.listeners.push(listener);
  }

  show(frame: number): void {
    this.frame = Math.min(this.count - 1, Math.max(0, frame));
    for (const listener of this.listeners) listener();
  }

  /** Stops there. */
  go(frame: number): void {
    this.stop();
    this.show(frame);
  }

  step(by: number): void {
    this.go((this.frame + by + this.count) % this.count);
  }

  play(): void {
    this.began = performance.now();
    if (this.driver) this.driver.play();
    else requestAnimationFrame((now) => this.advance(now, this.frame, this.began!));
    this.show(this.frame);
  }

  private advance(now: number, from: number, began: number): void {
    if (this.began !== began) return;
    const frame = (from + Math.max(0, Math.floor((now - began) / 1000 * this.fps))) % this.count;
    if (frame !== this.frame) this.show(frame);
    requestAnimationFrame((next) => this.advance(next, from, began));
  }

  stop(): void {
    if (this.began === null) return;
    this.began = null;
    this.driver?.stop();
    this.show(this.frame);
  }

  toggle = (): void => (this.isPlaying() ? this.stop() : this.play());
}

/** Plays and stops it, and shows where it is. */
export function transport(clock: Clock): View {
  const button = (pressed: () => void, attributes: Record<string, string>, text = ""): HTMLButtonElement => {
    const made = element("button", { type: "button", ...attributes }, text);
    made.addEventListener("click", pressed);
    return made;
  };
  const play = button(clock.toggle, { "aria-keyshortcuts": "Space" });
  const place = element("input", { type: "range", min: "0", max: String(clock.count - 1), step: "1", "aria-label": "frame" });
  place.addEventListener("input", () => clock.go(place.valueAsNumber));
  const told = element("output");
  const paint = (): void => {
    play.textContent = clock.isPlaying() ? "Pause" : "Play";
    place.value = String(clock.frame);
    told.textContent = `frame ${clock.frame} of ${clock.count - 1} · ${clock.seconds().toFixed(2)} s`;
  };
  clock.onFrame(paint);
  const node = element("div", { class: "bar wide transport" }, play,
    button(() => clock.step(-1), { "aria-label": "previous frame" }, "←"),
    button(() => clock.step(1), { "aria-label": "next frame" }, "→"), place, told);
  return { node, paint };
}
