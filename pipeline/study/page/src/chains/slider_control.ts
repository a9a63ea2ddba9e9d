import { button, element } from "../questionnaire/elements";
import type { MatchingTexts } from "../live_study/texts";
import type { SliderStart } from "./experiment";
import type { ChainTexts } from "./texts";

/** What was done with the slider. */
export interface Slid {
  /** Of the range, 0 to 1. */
  share: number;
  moves: number;
}

const parts = 1000;  // steps of the slider
const keyPart = 0.01;  // of an arrow key
const rounded = (share: number): number => Math.round(share * parts) / parts;

/** A slider without names at its ends, and a button that ends the trial once the slider was moved. Left and right are
    those of the screen, whatever the direction of writing. */
export class SliderControl {
  readonly element: HTMLElement;
  private input: HTMLInputElement;
  private done: HTMLButtonElement;
  private changed: () => void = () => {};
  private pressed: () => void = () => {};

  constructor(words: ChainTexts, private texts: MatchingTexts) {
    this.input = element("input", { type: "range", class: "marker", dir: "ltr", min: "0", max: "1",
      step: String(1 / parts), "aria-label": words.slider });
    this.input.addEventListener("input", () => this.changed());
    this.input.addEventListener("keydown", (event) => this.keyed(event));
    this.done = button(words.done, () => this.pressed(), "main");
    this.element = element("div", { class: "slider-control" }, element("div", { class: "track" }, this.input),
      element("div", { class: "buttons" }, this.done));
  }

  /**
   * Puts the slider where it stands at first. `moved` is told of every change, `early` of a press before the first;
   * resolves when the participant is done.
   */
  ask({ start, reversed }: SliderStart, moved: (share: number) => void, early: () => void): Promise<Slid> {
    const ownWay = (place: number): number => rounded(reversed ? 1 - place : place);
    let moves = 0;
    let place = ownWay(start);
    this.put(place);
    this.done.setAttribute("aria-disabled", "true");
    return new Promise((resolve) => {
      this.changed = () => {
        const now = Number(this.input.value);
        this.tell();
        if (now === place) return;
        place = now;
        moves += 1;
        this.done.removeAttribute("aria-disabled");
        moved(ownWay(place));
      };
      this.pressed = () => (moves ? resolve({ share: ownWay(place), moves }) : early());
    });
  }

  /** Where the slider stands, as a share of the range. */
  static shareAt({ start }: SliderStart): number {
    return rounded(start);
  }

  focus(): void {
    this.input.focus({ preventScroll: true });
  }

  private put(place: number): void {
    this.input.value = String(place);
    this.tell();
  }

  private tell(): void {
    this.input.setAttribute("aria-valuetext", this.texts.percent({ value: Math.round(100 * Number(this.input.value)) }));
  }

  /** Arrow keys move in steps that are seen; Enter shows what it would press next. */
  private keyed(event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const by: Record<string, number> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };
    const direction = by[event.key];
    if (direction === undefined && event.key !== "Enter") return;
    event.preventDefault();
    if (direction === undefined) return this.done.focus({ preventScroll: true });
    this.put(rounded(Math.min(1, Math.max(0, Number(this.input.value) + direction * keyPart))));
    this.changed();
  }
}
