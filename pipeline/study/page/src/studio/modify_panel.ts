import { button, element, paragraphs } from "../questionnaire/elements";
import { mapOf, type JsonMap } from "./document";
import { adder, choice, labelled } from "./fields";
import { options } from "./modify_options";
import { amountSlider, setAt, setInStep, setSteps, stepsOf, valueAt, type Amount } from "./modify_steps";
import type { Studio } from "./studio";

const amounts: Amount[] = [
  { path: "paths", title: "path lengths of hands, head and feet; 1: unchanged", least: 0, most: 2, usual: 1 },
  { path: "acceleration", title: "sharper (above 0) or smoother (below)", least: -1, most: 1, usual: 0 },
  { path: "tempo", title: "speed factor", least: 0.25, most: 4, usual: 1 },
  { path: "variation", title: "variation between cycles", least: 0, most: 1, usual: 0 },
];

/** What is done to the motion once it is made: one step, or several after each other. */
export function modifyPanel(studio: Studio): HTMLElement {
  const panel = element("section", { class: "panel", "aria-label": "Modify" });
  let drawn = "";
  const build = (): void => {
    drawn = shapeOf(studio);
    panel.replaceChildren();
    const stimulus = studio.stimulus();
    if (!stimulus) return;
    if ("foil" in stimulus) {
      panel.append(...paragraphs(["A foil has the modifications of its stimulus."]));
      return;
    }
    if ("people" in stimulus) {
      panel.append(...paragraphs(["Each person has modifications of their own. Edit them in the manifest."]));
      return;
    }
    stepsOf(stimulus).forEach((_, index) => panel.append(step(studio, index)));
    panel.append(element("div", { class: "row" },
      button("Add a step", () => setSteps(studio, [...stepsOf(studio.stimulus()!), firstStep(studio)]))));
    if (stepsOf(stimulus).length === 0)
      panel.append(...paragraphs(["A step changes the motion by an emotion recipe, or by its path lengths, "
        + "its acceleration, posture, tempo or variation."]));
  };
  studio.on((change) => {
    if (!["document", "selection", "choices", "places"].includes(change)) return;
    if (shapeOf(studio) !== drawn) build();
    else setValues(studio, panel);
  });
  build();
  return panel;
}

/** Of a recipe, if there is one: to be changed from there. */
function firstStep(studio: Studio): JsonMap {
  const names = studio.words.recipes.map((recipe) => recipe.name);
  const name = names.includes("sad") ? "sad" : names[0];
  return name === undefined ? { paths: 1.2 } : { emotion: name };
}

/** What the panel is built anew for: everything but the numbers that have sliders. */
const shapeOf = (studio: Studio): string => {
  const stimulus = studio.stimulus();
  const slides = new Set(["strength", "low", "middle", "high", ...amounts.map((one) => one.path),
    ...studio.words.posture.map((unit) => unit.name)]);
  return JSON.stringify([studio.selected, stimulus ? stepsOf(stimulus) : [], stimulus && "foil" in stimulus,
    stimulus && "people" in stimulus, studio.choices.examples, studio.places.folders.length],
  (key, value: unknown) => (typeof value === "number" && slides.has(key) ? 0 : value));
};

function setValues(studio: Studio, panel: HTMLElement): void {
  const steps = stepsOf(studio.stimulus()!);
  for (const made of panel.querySelectorAll<HTMLElement>(".slider")) {
    const value = valueAt(steps[Number(made.dataset["step"])] ?? {}, made.dataset["path"]!) ?? made.dataset["usual"]!;
    for (const input of made.querySelectorAll("input"))
      if (input !== document.activeElement || input.type === "range") input.value = String(value);
  }
}

function step(studio: Studio, index: number): HTMLElement {
  const values = stepsOf(studio.stimulus()!)[index]!;
  const take = button("Remove", () => setSteps(studio, stepsOf(studio.stimulus()!).filter((_, i) => i !== index)), "small");
  const head = element("div", { class: "step-head" }, element("h2", {}, `Step ${index + 1}`), take);
  const made = element("div", { class: "step" }, head);
  if (!("method" in values)) made.append(...changes(studio, index, values));
  made.append(...options(studio, index));
  return made;
}

/** A recipe, and what changes most: the rest are options. */
function changes(studio: Studio, index: number, values: JsonMap): HTMLElement[] {
  const made = [recipe(studio, index, values)];
  if ("emotion" in values) made.push(amountSlider(studio, index,
    { path: "strength", title: "of the recipe and the settings below", least: 0, most: 2, usual: 1 }));
  for (const amount of amounts) made.push(amountSlider(studio, index, amount));
  const posture = mapOf(values["posture"]);
  for (const [name, value] of Object.entries(posture)) made.push(postureSlider(studio, index, name, Number(value)));
  const rest = studio.words.posture.filter((unit) => !(unit.name in posture));
  made.push(adder("add a posture…", rest.map((unit) => unit.name), (name) => setAt(studio, index, `posture.${name}`, 10)));
  return made;
}

function recipe(studio: Studio, index: number, values: JsonMap): HTMLElement {
  const none = "none";
  const names = [none, ...studio.words.recipes.map((one) => one.name)];
  const chosen = choice(names, String(values["emotion"] ?? none), (name) =>
    setInStep(studio, index, "emotion", name === none ? undefined : name));
  const note = studio.words.recipes.find((one) => one.name === values["emotion"])?.note ?? "";
  const made = element("div", {}, labelled("Recipe", chosen, note));
  if (note) made.append(element("p", { class: "quiet" }, note));
  return made;
}

const postureSlider = (studio: Studio, index: number, name: string, value: number): HTMLElement =>
  amountSlider(studio, index, {
    path: `posture.${name}`, title: studio.words.posture.find((unit) => unit.name === name)?.note ?? "",
    unit: "degrees", least: Math.min(-60, value), most: Math.max(60, value), step: 1, usual: 0,
  });
