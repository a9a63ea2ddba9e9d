// A marker on a scale from 0 to 100, moved by mouse, touch or arrow keys.

import { element } from "./elements";

export interface MarkerSettings {
  input: "slider" | "keys";
  /** Of 0 to 100. */
  start: number;
  /** While an arrow key is held, a second. */
  speed: number;
}

const writes = (at: EventTarget | null): boolean =>
  at instanceof HTMLTextAreaElement || (at instanceof HTMLInputElement && at.type !== "range");

/** Held arrow keys move it steadily, whatever the rate at which the keyboard repeats them, wherever the focus is. */
export class Marker {
  readonly input: HTMLInputElement;
  private at: number;
  private held = new Set<string>();
  private movedBy = 0;
  private listening = new AbortController();

  constructor(label: string, private settings: MarkerSettings, private moved: () => void) {
    this.at = settings.start;
    this.input = element("input", { type: "range", min: "0", max: "100", step: "any", "aria-label": label,
      class: "marker" });
    this.show();
    this.input.addEventListener("input", () => {
      this.at = Number(this.input.value);
      this.tell();
      this.moved();
    });
    const { signal } = this.listening;
    document.addEventListener("keydown", (event) => this.pressed(event), { signal });
    document.addEventListener("keyup", (event) => this.let(event.key), { signal });
    addEventListener("blur", () => this.held.clear(), { signal });
    if (settings.input === "keys") this.input.classList.add("by-keys");
  }

  get value(): number {
    return this.at;
  }

  reset(): void {
    this.at = this.settings.start;
    this.show();
  }

  /** No longer movable. */
  stop(): void {
    this.listening.abort();
    this.held.clear();
    this.input.disabled = true;
  }

  /** Moves it for the time since the last call; `now` as performance.now(). */
  tick(now: number): void {
    const direction = this.direction();
    const share = Math.min(1, Math.max(0, (now - this.movedBy) / 1000));
    this.movedBy = now;
    if (direction === 0) return;
    this.at = Math.min(100, Math.max(0, this.at + direction * share * this.settings.speed));
    this.show();
    this.moved();
  }

  /** Towards which end the held keys move it: 1, −1, or 0. */
  private direction(): number {
    const right = getComputedStyle(this.input).direction === "rtl" ? -1 : 1;
    const by: Record<string, number> = { ArrowRight: right, ArrowLeft: -right, ArrowUp: 1, ArrowDown: -1 };
    return Math.sign([...this.held].reduce((sum, key) => sum + by[key]!, 0));
  }

  private pressed(event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey || writes(event.target)) return;
    if (document.querySelector("dialog[open]")) return;
    const isJump = /^(Home|End|Page(Up|Down))$/.test(event.key);
    if (isJump && this.settings.input === "keys") event.preventDefault();
    if (!/^Arrow(Left|Right|Up|Down)$/.test(event.key)) return;
    event.preventDefault();
    if (event.repeat || this.held.has(event.key)) return;
    this.tick(performance.now());
    this.held.add(event.key);
  }

  private let(key: string): void {
    if (this.held.has(key)) this.tick(performance.now());
    this.held.delete(key);
  }

  private show(): void {
    this.input.value = String(this.at);
    this.tell();
  }

  private tell(): void {
    this.input.setAttribute("aria-valuetext", `${Math.round(this.at)} / 100`);
  }
}
