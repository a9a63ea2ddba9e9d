import { element } from "../questionnaire/elements";

/** A slider for each mood, of which shares are taken, and one for the pace. */
export class MoodPanel {
  readonly element: HTMLElement;
  private sliders: HTMLInputElement[];
  private note = element("p", { class: "mood-note", role: "status" });

  constructor(moods: string[], private told: () => void) {
    this.sliders = moods.map((mood, place) => slider(mood, place === 0 ? 1 : 0, 1, () => this.changed()));
    const rows = moods.map((mood, place) => {
      const only = element("button", { type: "button", class: "mood", title: `${mood} alone` }, mood);
      only.addEventListener("click", () => this.choose(place));
      return element("div", { class: "mood-row" }, only, this.sliders[place]!);
    });
    this.element = element("div", { class: "moods", role: "group", "aria-label": "mood" }, ...rows, this.note);
  }

  /** One a mood, 0 to 1. */
  shares(): number[] {
    return this.sliders.map((one) => Number(one.value));
  }

  /** That mood and no other. */
  choose(mood: number): void {
    this.sliders.forEach((one, place) => (one.value = place === mood ? "1" : "0"));
    this.changed();
  }

  private changed(): void {
    const isNone = this.shares().every((share) => share === 0);
    this.note.textContent = isNone ? "No mood selected: the previous one is kept." : "";
    this.told();
  }
}

export function slider(name: string, value: number, most: number, changed: (value: number) => void): HTMLInputElement {
  const input = element("input", { type: "range", min: "0", max: String(most), step: "0.01", "aria-label": name });
  input.value = String(value);
  input.addEventListener("input", () => changed(Number(input.value)));
  return input;
}
