import { button, element, paragraphs } from "../questionnaire/elements";
import type { Slider } from "../live/core";
import { kinds, mapOf, rounded, sourceOf, withMember, type JsonMap, type Kind, type Stimulus } from "./document";
import { exampleFields } from "./examples_fields";
import { adder, choice, labelled, slider } from "./fields";
import type { Studio } from "./studio";

/** What a stimulus is made from: sliders of adjectives, of features or of weights. */
export function motionPanel(studio: Studio): HTMLElement {
  const panel = element("section", { class: "panel", "aria-label": "Motion" });
  let drawn = "";

  const build = (): void => {
    const stimulus = studio.stimulus();
    drawn = keyOf(studio);
    panel.replaceChildren();
    if (!stimulus) return;
    panel.append(heads(studio, stimulus), ...content(studio, stimulus));
    tellReached(studio, panel);
  };
  studio.on((change) => {
    if (change === "motion") tellReached(studio, panel);
    if (!["document", "choices", "selection", "places"].includes(change)) return;
    if (keyOf(studio) !== drawn) build();
    else setValues(studio, panel);
  });
  build();
  return panel;
}

/** What the panel is built anew for: other sliders, not other values. */
function keyOf(studio: Studio): string {
  const stimulus = studio.stimulus();
  const source = stimulus ? sourceOf(stimulus) : "";
  const values = stimulus ? Object.keys(mapOf(stimulus[source])) : [];
  return JSON.stringify([studio.selected, source, values, studio.choices.examples, studio.document()["examples"],
    studio.places.folders.map((one) => one.folder), stimulus?.["hold"], stimulus?.["role"]]);
}

function setValues(studio: Studio, panel: HTMLElement): void {
  const stimulus = studio.stimulus();
  if (!stimulus) return;
  const values = mapOf(stimulus[sourceOf(stimulus)]);
  for (const made of panel.querySelectorAll<HTMLElement>(".slider")) {
    const value = String(values[made.dataset["name"]!] ?? 0);
    for (const input of made.querySelectorAll("input"))
      if (input !== document.activeElement || input.type === "range") input.value = value;
  }
}

function tellReached(studio: Studio, panel: HTMLElement): void {
  for (const made of panel.querySelectorAll<HTMLElement>(".slider")) {
    const reached = studio.made?.reached[made.dataset["name"]!];
    const asked = Number(made.querySelector<HTMLInputElement>("input")!.value);
    const told = made.querySelector("output")!;
    told.textContent = reached !== undefined && Math.abs(reached - asked) > 0.005 ? `has ${reached.toFixed(2)}` : "";
  }
}

function heads(studio: Studio, stimulus: Stimulus): HTMLElement {
  const role = choice(["target", "created", "reference"], String(stimulus["role"] ?? "created"),
    (name) => studio.changeStimulus(withMember(stimulus, "role", name === "created" ? undefined : name)));
  return element("div", { class: "fields" }, ...exampleFields(studio), labelled("Role", role, "position and colour on sheets"));
}

function content(studio: Studio, stimulus: Stimulus): HTMLElement[] {
  const source = sourceOf(stimulus);
  if (source === "clip") return paragraphs(["This stimulus shows a motion file. See Modify for its modifications."]);
  if (source === "path") return paragraphs(["This stimulus walks along the path in the manifest. See Modify for "
    + "its modifications."]);
  if (source === "people") return paragraphs(["This stimulus shows several people. Edit their motions, places and "
    + "figures in the manifest."]);
  if (source === "foil") return paragraphs(["This stimulus is a foil of another and has no sliders."]);
  const tabs = element("div", { class: "kinds", role: "group", "aria-label": "made from" });
  for (const kind of kinds) {
    const tab = button(kind, () => changeKind(studio, stimulus, kind), kind === source ? "chosen" : "");
    tab.setAttribute("aria-pressed", String(kind === source));
    tabs.append(tab);
  }
  return [tabs, ...sliders(studio, stimulus, source)];
}

/** Other sliders for about the same motion. */
function changeKind(studio: Studio, stimulus: Stimulus, kind: Kind): void {
  const before = sourceOf(stimulus);
  if (before === kind) return;
  const made: Stimulus = { id: stimulus.id };
  for (const [key, value] of Object.entries(stimulus)) {
    if (key === before) made[kind] = firstValues(studio, kind);
    else if (key !== "hold") made[key] = value;
  }
  studio.changeStimulus(made);
}

function firstValues(studio: Studio, kind: Kind): JsonMap {
  const weights = studio.made?.weights ?? {};
  if (kind === "weights") {
    const told = Object.entries(weights).map(([name, value]) => [name, Math.max(0, rounded(value))]);
    const kept = told.filter(([, value]) => Number(value) > 0);
    return kept.length > 0 ? Object.fromEntries(kept) : { [studio.choices.examples[0] ?? "normal"]: 1 };
  }
  const primary = studio.choices.sliders[kind].filter((one) => one.primary);
  return Object.fromEntries(primary.map((one) => [one.name, rounded(one.mean)]));
}

function sliders(studio: Studio, stimulus: Stimulus, kind: Kind): HTMLElement[] {
  const values = mapOf(stimulus[kind]);
  const set = (name: string, value: number | undefined, gesture: string): void => {
    const now = studio.stimulus();
    if (!now) return;
    studio.changeStimulus(withMember(now, kind, withMember(mapOf(now[kind]), name, value)), gesture);
  };
  const known: Map<string, Slider | undefined> = kind === "weights"
    ? new Map(studio.choices.examples.map((name) => [name, undefined]))
    : new Map(studio.choices.sliders[kind].map((one) => [one.name, one]));
  const shown = Object.keys(values);
  const many = shown.length > 1;
  const made = shown.map((name) => {
    const one = known.get(name);
    const value = Number(values[name]);
    return slider({
      name, least: 0, most: Math.max(1, value), step: 0.01, value,
      ...(one ? { usual: one.mean } : {}),
      ...(one?.low && one.high ? { low: one.low, high: one.high } : {}),
      moved: (next) => set(name, next, `${kind} ${name}`),
      settled: () => studio.history.endGesture(),
      ...(many ? { removed: () => set(name, undefined, "") } : {}),
    });
  });
  const rest = [...known.keys()].filter((name) => !shown.includes(name));
  const words = { adjectives: "add an adjective pair…", features: "add a feature…", weights: "add an example…" };
  const add = adder(words[kind], rest, (name) => set(name, kind === "weights" ? 0.2 : rounded(known.get(name)?.mean ?? 0.5), ""));
  const notes: string[] = [];
  if (kind === "adjectives" && studio.choices.simulated) notes.push("The ratings are simulated.");
  if ("hold" in stimulus) notes.push("Other parameters are held as specified in the manifest.");
  const note = paragraphs(notes);
  for (const one of note) one.className = "quiet";
  return [...made, ...(rest.length > 0 ? [add] : []), ...note];
}
