import { button, element, paragraphs } from "../questionnaire/elements";
import { is_map, map_of, with_member, type Json, type JsonMap, type Stimulus } from "./document";
import { adder, choice, labelled, slider } from "./fields";
import type { Studio } from "./studio";

interface Amount {
  key: string;
  title: string;
  least: number;
  most: number;
  usual: number;
}

const amounts: Amount[] = [
  { key: "paths", title: "lengths of the paths of hands, head and feet: 1 as they are", least: 0, most: 2, usual: 1 },
  { key: "acceleration", title: "sharper (above 0) or smoother (below)", least: -1, most: 1, usual: 0 },
  { key: "tempo", title: "times as fast", least: 0.25, most: 4, usual: 1 },
  { key: "variation", title: "how much cycles differ from each other", least: 0, most: 1, usual: 0 },
];

/** What is done to the motion once it is made: one step, or several after each other. */
export function modify_panel(studio: Studio): HTMLElement {
  const panel = element("section", { class: "panel", "aria-label": "Modify" });
  let drawn = "";
  const build = (): void => {
    drawn = shape_of(studio);
    panel.replaceChildren();
    const stimulus = studio.stimulus();
    if (!stimulus) return;
    if ("foil" in stimulus) {
      panel.append(...paragraphs(["A foil is modified as the stimulus that it is of."]));
      return;
    }
    steps_of(stimulus).forEach((_, index) => panel.append(step(studio, index)));
    panel.append(element("div", { class: "row" },
      button("Add a step", () => set_steps(studio, [...steps_of(studio.stimulus()!), first_step(studio)]))));
    if (steps_of(stimulus).length === 0)
      panel.append(...paragraphs(["A step changes the motion by a recipe of an emotion, by the lengths of its paths, "
        + "its acceleration, posture, tempo or variation."]));
  };
  studio.on((change) => {
    if (change !== "document" && change !== "selection") return;
    if (shape_of(studio) !== drawn) build();
    else set_values(studio, panel);
  });
  build();
  return panel;
}

function steps_of(stimulus: Stimulus): JsonMap[] {
  const modify = stimulus["modify"];
  if (Array.isArray(modify)) return modify.map(map_of);
  return is_map(modify) ? [modify] : [];
}

/** Of a recipe, if there is one: to be changed from there. */
function first_step(studio: Studio): JsonMap {
  const names = studio.words.recipes.map((recipe) => recipe.name);
  const name = names.includes("sad") ? "sad" : names[0];
  return name === undefined ? { paths: 1.2 } : { emotion: name };
}

/** One step stays a map where it was one. */
function set_steps(studio: Studio, steps: JsonMap[], gesture = ""): void {
  const stimulus = studio.stimulus();
  if (!stimulus) return;
  const was_list = Array.isArray(stimulus["modify"]);
  const value: Json | undefined = steps.length === 0 ? undefined : steps.length === 1 && !was_list ? steps[0]! : steps;
  studio.change_stimulus(with_member(stimulus, "modify", value), gesture);
}

function set_in_step(studio: Studio, index: number, key: string, value: Json | undefined, gesture = ""): void {
  const steps = steps_of(studio.stimulus()!);
  const made = with_member(steps[index]!, key, value);
  set_steps(studio, steps.map((one, i) => (i === index ? made : one)), gesture && `modify ${index} ${gesture}`);
}

/** What the panel is built anew for: everything but the numbers. */
const shape_of = (studio: Studio): string => {
  const stimulus = studio.stimulus();
  return JSON.stringify([studio.selected, stimulus ? steps_of(stimulus) : [], stimulus && "foil" in stimulus],
    (_, value: unknown) => (typeof value === "number" ? 0 : value));
};

function set_values(studio: Studio, panel: HTMLElement): void {
  const steps = steps_of(studio.stimulus()!);
  for (const made of panel.querySelectorAll<HTMLElement>(".slider")) {
    const values = steps[Number(made.dataset["step"])] ?? {};
    const key = made.dataset["key"]!;
    const value = values[key] ?? map_of(values["posture"])[key] ?? made.dataset["usual"]!;
    for (const input of made.querySelectorAll("input"))
      if (input !== document.activeElement || input.type === "range") input.value = String(value);
  }
}

function step(studio: Studio, index: number): HTMLElement {
  const steps = steps_of(studio.stimulus()!);
  const values = steps[index]!;
  const take = button("Remove", () => set_steps(studio, steps_of(studio.stimulus()!).filter((_, i) => i !== index)), "small");
  const head = element("div", { class: "step-head" }, element("h2", {}, `Step ${index + 1}`), take);
  const made = element("div", { class: "step" }, head);
  if ("method" in values || "pose" in values || "gains" in values)
    made.append(element("code", { class: "as-written" }, JSON.stringify(values)));
  if ("method" in values) return made;
  made.append(recipe(studio, index, values));
  if ("emotion" in values) made.append(amount_slider(studio, index, values,
    { key: "strength", title: "of the recipe and what stands below", least: 0, most: 2, usual: 1 }));
  for (const amount of amounts) made.append(amount_slider(studio, index, values, amount));
  for (const name of Object.keys(map_of(values["posture"]))) made.append(posture_slider(studio, index, name));
  const rest = studio.words.posture.filter((unit) => !(unit.name in map_of(values["posture"])));
  made.append(adder("add a posture…", rest.map((unit) => unit.name), (name) => set_posture(studio, index, name, 10)));
  return made;
}

function recipe(studio: Studio, index: number, values: JsonMap): HTMLElement {
  const none = "none";
  const names = [none, ...studio.words.recipes.map((one) => one.name)];
  const chosen = choice(names, String(values["emotion"] ?? none), (name) =>
    set_in_step(studio, index, "emotion", name === none ? undefined : name));
  const note = studio.words.recipes.find((one) => one.name === values["emotion"])?.note ?? "";
  const made = element("div", {}, labelled("Recipe", chosen, note));
  if (note) made.append(element("p", { class: "quiet" }, note));
  return made;
}

function amount_slider(studio: Studio, index: number, values: JsonMap, amount: Amount): HTMLElement {
  const given = values[amount.key];
  const made = slider({
    name: amount.key, title: amount.title, least: amount.least, most: amount.most, step: 0.01,
    value: typeof given === "number" ? given : amount.usual,
    moved: (value) => set_in_step(studio, index, amount.key, value, amount.key),
    settled: () => studio.history.end_gesture(),
    ...(typeof given === "number" ? { removed: () => set_in_step(studio, index, amount.key, undefined) } : {}),
  });
  made.dataset["step"] = String(index);
  made.dataset["key"] = amount.key;
  made.dataset["usual"] = String(amount.usual);
  made.classList.toggle("unset", typeof given !== "number");
  return made;
}

function set_posture(studio: Studio, index: number, name: string, degrees: number | undefined, gesture = ""): void {
  const posture = with_member(map_of(steps_of(studio.stimulus()!)[index]!["posture"]), name, degrees);
  const value = Object.keys(posture).length > 0 ? posture : undefined;
  set_in_step(studio, index, "posture", value, gesture);
}

function posture_slider(studio: Studio, index: number, name: string): HTMLElement {
  const value = Number(map_of(steps_of(studio.stimulus()!)[index]!["posture"])[name]);
  const made = slider({
    name, title: studio.words.posture.find((unit) => unit.name === name)?.note ?? "", unit: "degrees",
    least: Math.min(-60, value), most: Math.max(60, value), step: 1, value,
    moved: (next) => set_posture(studio, index, name, next, `posture ${name}`),
    settled: () => studio.history.end_gesture(),
    removed: () => set_posture(studio, index, name, undefined),
  });
  made.dataset["step"] = String(index);
  made.dataset["key"] = name;
  made.dataset["usual"] = "0";
  return made;
}
