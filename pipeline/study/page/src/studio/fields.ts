import { element } from "../questionnaire/elements";

/** A field with its name before it. */
export function labelled(text: string, field: HTMLElement, title = ""): HTMLLabelElement {
  const label = element("label", { class: "field" }, element("span", {}, text), field);
  if (title) label.title = title;
  return label;
}

/** A choice of names; `shown` where a name is written in other words. */
export function choice(
  names: string[], chosen: string, changed: (name: string) => void, shown: (name: string) => string = (name) => name,
): HTMLSelectElement {
  const select = element("select");
  for (const name of names) {
    const option = element("option", { value: name }, shown(name));
    option.selected = name === chosen;
    select.append(option);
  }
  select.addEventListener("change", () => changed(select.value));
  return select;
}

export interface SliderSettings {
  name: string;
  title?: string;
  low?: string;
  high?: string;
  least: number;
  most: number;
  step: number;
  value: number;
  /** Where it stands when nobody has set it; marked. */
  usual?: number;
  unit?: string;
  /** Called while it is moved. */
  moved: (value: number) => void;
  /** Called when it is let go. */
  settled: () => void;
  /** Takes it away, or sets it back. */
  removed?: () => void;
}

/** A slider with its number beside it, which may be typed. */
export function slider(settings: SliderSettings): HTMLElement {
  const { name, least, most, step, value } = settings;
  const range = element("input", { type: "range", min: String(least), max: String(most), step: String(step),
    "aria-label": name });
  const number = element("input", { type: "number", min: String(least), max: String(most), step: String(step),
    "aria-label": `${name}, number` });
  range.value = String(value);
  number.value = String(value);
  range.addEventListener("input", () => {
    number.value = range.value;
    settings.moved(Number(range.value));
  });
  range.addEventListener("change", settings.settled);
  number.addEventListener("change", () => {
    const given = Number(number.value);
    if (number.value === "" || !Number.isFinite(given)) number.value = range.value;
    else {
      const kept = Math.min(most, Math.max(least, given));
      number.value = range.value = String(kept);
      settings.moved(kept);
    }
    settings.settled();
  });
  const head = element("div", { class: "slider-head" }, element("span", { class: "slider-name" }, name));
  if (settings.unit) head.append(element("span", { class: "quiet" }, settings.unit));
  const reached = element("output", { class: "reached", title: "value of the motion" });
  head.append(reached, number);
  if (settings.removed) {
    const remove = element("button", { type: "button", class: "small", "aria-label": `remove ${name}` }, "×");
    remove.addEventListener("click", settings.removed);
    head.append(remove);
  }
  const made = element("div", { class: "slider", "data-name": name }, head, range);
  if (settings.title) made.title = settings.title;
  if (settings.usual !== undefined) {
    const share = (settings.usual - least) / (most - least);
    made.append(element("i", { class: "usual", title: "the mean of the examples" }));
    (made.lastChild as HTMLElement).style.setProperty("--at", String(share));
  }
  if (settings.low && settings.high) made.append(element("div", { class: "ends quiet" },
    element("span", {}, settings.low), element("span", {}, settings.high)));
  return made;
}

/** A box to choose from what is not there yet. */
export function adder(text: string, names: string[], added: (name: string) => void): HTMLElement {
  const select = choice(["", ...names], "", (name) => name && added(name), (name) => name || text);
  select.className = "adder";
  select.setAttribute("aria-label", text);
  return select;
}
