import { button, element } from "../questionnaire/elements";
import type { ChainTexts } from "./texts";

/** A second press of what chose in the trial before chooses nothing. */
const deafMs = 400;

/** Two buttons, over or below their figures, and the keys 1 and 2. */
export class ChoiceControl {
  readonly element: HTMLElement;
  private chosen: (place: number) => void = () => {};

  constructor(words: ChainTexts) {
    this.element = element("div", { class: "picks" }, ...[0, 1].map((place) => {
      const one = button(words.figure({ number: place + 1 }), () => this.chosen(place), "main");
      one.dataset.pick = String(place + 1);
      return element("div", {}, one);
    }));
    document.addEventListener("keydown", (event) => this.keyed(event));
  }

  /** Resolves with the figure that is chosen, 0 or 1. */
  ask(): Promise<number> {
    const since = performance.now();
    return new Promise((resolve) => {
      this.chosen = (place) => {
        if (performance.now() - since >= deafMs) resolve(place);
      };
    });
  }

  private keyed({ key, repeat, ctrlKey, altKey, metaKey }: KeyboardEvent): void {
    const isOurs = this.element.isConnected && !this.element.closest("[inert]") && !document.querySelector("dialog[open]");
    if (isOurs && !repeat && !ctrlKey && !altKey && !metaKey && (key === "1" || key === "2")) this.chosen(Number(key) - 1);
  }
}
