import type { InterfaceKind, LiveInfo, LiveSetting, Slider } from "../live/core";
import { button, element } from "../questionnaire/elements";
import type { MatchingTexts } from "../live_study/texts";

/** What somebody did to the sliders. */
export interface SliderChange {
  action: "move" | "add" | "remove";
  slider: string;
  value: number;
}

interface Row {
  slider: Slider;
  input: HTMLInputElement;
  root: HTMLElement;
}

/** What a slider is called, and its ends. */
function wordsOf(slider: Slider, language: string, texts: MatchingTexts): { name: string; ends: [string, string] } {
  const pair = slider.texts?.[language] ?? (slider.low && slider.high ? [slider.low, slider.high] as [string, string] : null);
  if (pair) return { name: `${pair[0]} – ${pair[1]}`, ends: pair };
  const name = slider.labels?.[language] ?? slider.labels?.en ?? slider.name;
  return { name, ends: [texts.less, texts.more] };
}

/** The sliders of an interface as the core has them; examples have one each. */
function knownSliders(info: LiveInfo, kind: InterfaceKind): Slider[] {
  if (kind !== "weights") return info.sliders[kind];
  return info.examples.map((name) => ({ name, primary: true, mean: 0 }));
}

/**
 * The sliders of one interface, with a list from which more are added where there are more. They
 * begin where the examples lie on the average; shares at none.
 */
export class SliderPanel {
  readonly element: HTMLElement;
  private rows: Row[] = [];
  private list: HTMLElement;
  private choice: HTMLSelectElement | null = null;
  private known: Map<string, Slider>;

  constructor(
    private kind: InterfaceKind, sliders: { shown: string[]; offered: string[] }, info: LiveInfo,
    private language: string, private texts: MatchingTexts, private changed: (change: SliderChange) => void,
  ) {
    this.known = new Map(knownSliders(info, kind).map((slider) => [slider.name, slider]));
    this.list = element("div", { class: `sliders ${kind}` });
    this.element = element("div", { class: "slider-panel" }, this.list);
    for (const name of sliders.shown) this.addRow(name, false);
    if (sliders.offered.length) this.element.append(this.offer(sliders.offered));
  }

  setting(): LiveSetting {
    return {
      kind: this.kind,
      sliders: this.rows.map(({ slider }) => slider.name),
      values: this.rows.map(({ input }) => Number(input.value)),
    };
  }

  /** Puts the sliders where a setting has them, adding those that are not there; those that it does not name stay. */
  put(setting: { sliders: string[]; values: number[] }): void {
    for (const name of setting.sliders) {
      if (this.rows.some(({ slider }) => slider.name === name)) continue;
      this.choice?.querySelector(`option[value="${CSS.escape(name)}"]`)?.remove();
      this.addRow(name, true);
    }
    for (const { slider, input } of this.rows) {
      const at = setting.sliders.indexOf(slider.name);
      if (at >= 0) input.value = String(setting.values[at]);
      this.tell(input);
    }
  }

  lock(isLocked: boolean): void {
    this.element.inert = isLocked;
  }

  focus(): void {
    this.rows[0]?.input.focus({ preventScroll: true });
  }

  private tell(input: HTMLInputElement): void {
    input.setAttribute("aria-valuetext", this.texts.percent({ value: Math.round(100 * Number(input.value)) }));
  }

  private addRow(name: string, isAdded: boolean): Row {
    const slider = this.known.get(name);
    if (!slider) throw new Error(`The motion core knows no slider "${name}".`);
    const { name: shown, ends } = wordsOf(slider, this.language, this.texts);
    const id = `slider-${this.kind}-${name}`;
    const start = Math.round(100 * Math.min(1, Math.max(0, slider.mean))) / 100;
    const input = element("input", {
      type: "range", id, min: "0", max: "1", step: "0.01", value: String(start), "data-slider": name,
    });
    input.addEventListener("input", () => {
      this.tell(input);
      this.changed({ action: "move", slider: name, value: Number(input.value) });
    });
    const isPair = shown !== name && shown.includes(" – ");
    const root = element("div", { class: `slider ${isPair ? "pair" : "named"}` },
      element("label", { for: id }, shown),
      element("div", { class: "slider-line" },
        element("span", { class: "end", "aria-hidden": "true" }, ends[0]), input,
        element("span", { class: "end", "aria-hidden": "true" }, ends[1])));
    const row = { slider, input, root };
    if (isAdded) {
      const away = button("×", () => this.remove(row), "small");
      away.setAttribute("aria-label", this.texts.remove({ name: shown }));
      root.append(away);
    }
    this.tell(input);
    this.rows.push(row);
    this.list.append(root);
    return row;
  }

  private offer(offered: string[]): HTMLElement {
    const choice = element("select", { id: `more-${this.kind}` });
    for (const name of offered) choice.append(this.option(name));
    this.choice = choice;
    const add = button(this.texts.add, () => {
      const name = choice.value;
      if (!name) return;
      choice.querySelector(`option[value="${CSS.escape(name)}"]`)?.remove();
      const row = this.addRow(name, true);
      this.changed({ action: "add", slider: name, value: Number(row.input.value) });
      row.input.focus();
    }, "small");
    return element("div", { class: "offer" },
      element("label", { for: choice.id }, this.kind === "weights" ? "" : this.texts.addPair[this.kind]), choice, add);
  }

  private option(name: string): HTMLOptionElement {
    const slider = this.known.get(name);
    if (!slider) throw new Error(`The motion core knows no slider "${name}".`);
    return element("option", { value: name }, wordsOf(slider, this.language, this.texts).name);
  }

  private remove(row: Row): void {
    this.rows = this.rows.filter((one) => one !== row);
    row.root.remove();
    this.choice?.append(this.option(row.slider.name));
    this.changed({ action: "remove", slider: row.slider.name, value: Number(row.input.value) });
    this.focus();
  }
}
