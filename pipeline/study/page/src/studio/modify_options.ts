import { element } from "../questionnaire/elements";
import { isMap, mapOf, withMember, type Json, type JsonMap } from "./document";
import { adder, choice, labelled } from "./fields";
import { amountSlider, setAt, setInStep, stepsOf, valueAt } from "./modify_steps";
import type { KeySchema } from "./server";
import type { Studio } from "./studio";

/** Keys that have fields of their own in the panel. */
const shownElsewhere = ["emotion", "strength", "paths", "acceleration", "tempo", "variation", "posture"];
/** What a step with an older method may say; other steps may say the rest, and those of both. */
const ofMethods = ["method", "neutral", "styled", "harmonics", "order", "inputs", "components", "swap"];
const ofBoth = ["seed", "repair"];

/** Every other key of a step by what the schema says of it: those that are set, and a box to add one. */
export function options(studio: Studio, index: number): HTMLElement[] {
  const values = stepsOf(studio.stimulus()!)[index]!;
  const all = Object.keys(studio.words.modification).filter((key) => !shownElsewhere.includes(key) || "method" in values);
  const isOpen = (key: string): boolean =>
    ofBoth.includes(key) || ofMethods.includes(key) === "method" in values || (key === "method" && Object.keys(values).length === 0);
  const set = Object.keys(values).filter((key) => all.includes(key));
  const made = set.map((key) => option(studio, index, key));
  const rest = all.filter((key) => !(key in values) && isOpen(key));
  if (rest.length > 0) made.push(adder("add an option…", rest, (key) => setAt(studio, index, key, firstValue(studio, key))));
  return made;
}

/** To begin from: something that a manifest may say, as little changed as can be. */
function firstValue(studio: Studio, key: string): Json {
  const schema = studio.words.modification[key]!;
  const [first, second] = studio.choices.examples;
  if (key === "gains") return { middle: 1.2 };
  if (key === "pose") return { neutral: first ?? "", posed: second ?? first ?? "" };
  if (key === "neutral") return first ?? "";
  if (key === "styled") return second ?? first ?? "";
  return schema.default ?? schema.examples?.[0] ?? 0;
}

function option(studio: Studio, index: number, key: string): HTMLElement {
  const schema = studio.words.modification[key]!;
  const title = schema.description;
  const made = element("div", { class: "option", "data-option": key });
  const remove = element("button", { type: "button", class: "small", "aria-label": `remove ${key}` }, "×");
  remove.addEventListener("click", () => setAt(studio, index, key, undefined));
  const name = element("span", { class: "slider-name", title }, key);
  if (key === "gains") made.append(element("div", { class: "slider-head" }, name, remove), ...gains(studio, index, schema));
  else if (key === "pose") made.append(element("div", { class: "slider-head" }, name, remove), ...pose(studio, index));
  else {
    const row = labelled(key, field(studio, index, key, schema), title);
    row.append(remove);
    made.append(row);
  }
  return made;
}

/** By the kind of value; what is none of these stays as it is written and is shown. */
function field(studio: Studio, index: number, path: string, schema: Omit<KeySchema, "title" | "description">): HTMLElement {
  const value = valueAt(stepsOf(studio.stimulus()!)[index]!, path);
  const set = (made: Json): void => setAt(studio, index, path, made);
  const named = (made: HTMLElement): HTMLElement => {
    made.setAttribute("aria-label", path);
    return made;
  };
  if (schema.enum) return named(choice(schema.enum, String(value), set));
  if (path === "neutral" || path === "styled") return named(choice(motions(studio, value), String(value), set));
  if (schema.type === "boolean") {
    const box = element("input", { type: "checkbox" });
    box.checked = value === true;
    box.addEventListener("change", () => set(box.checked));
    return named(box);
  }
  if (schema.type === "integer" || schema.type === "number") return named(number(value, schema, set));
  const asNumber = schema.oneOf?.find((one) => one.type === "number");
  if (asNumber && typeof value === "number") return named(number(value, asNumber, set));
  if (schema.type === "array" && schema.items?.enum) return named(several(value, schema.items.enum, set));
  if (schema.type === "array") return named(numbers(value, set));
  return element("code", { class: "as-written" }, JSON.stringify(value));
}

function number(value: Json | undefined, schema: { minimum?: number; maximum?: number; type?: string },
    set: (value: Json) => void): HTMLElement {
  const input = element("input", { type: "number", step: schema.type === "integer" ? "1" : "any" });
  if (schema.minimum !== undefined) input.min = String(schema.minimum);
  if (schema.maximum !== undefined) input.max = String(schema.maximum);
  input.value = String(value ?? "");
  input.addEventListener("change", () => {
    if (input.checkValidity() && input.value !== "") set(Number(input.value));
    else input.value = String(value ?? "");
  });
  return input;
}

/** "0.3, 0.3, 1.8" */
function numbers(value: Json | undefined, set: (value: Json) => void): HTMLElement {
  const input = element("input", { type: "text", spellcheck: "false" });
  const written = Array.isArray(value) ? value.join(", ") : "";
  input.value = written;
  input.addEventListener("change", () => {
    const given = input.value.split(/[\s,]+/).filter((part) => part !== "").map(Number);
    if (given.length > 0 && given.every(Number.isFinite)) set(given);
    else input.value = written;
  });
  return input;
}

/** At least one of the names, in their order. */
function several(value: Json | undefined, names: string[], set: (value: Json) => void): HTMLElement {
  const chosen = Array.isArray(value) ? value : [];
  const made = element("span", { class: "several", role: "group" });
  for (const name of names) {
    const box = element("input", { type: "checkbox" });
    box.checked = chosen.includes(name);
    box.addEventListener("change", () => {
      const now = names.filter((one) => (one === name ? box.checked : chosen.includes(one)));
      if (now.length > 0) set(now);
      else box.checked = true;
    });
    made.append(element("label", { class: "check" }, box, name));
  }
  return made;
}

function gains(studio: Studio, index: number, schema: KeySchema): HTMLElement[] {
  const values = mapOf(stepsOf(studio.stimulus()!)[index]!["gains"]);
  const parts = schema.properties ?? {};
  const made: HTMLElement[] = Object.entries(parts).filter(([, part]) => part.type === "number").map(([name, part]) =>
    amountSlider(studio, index, {
      path: `gains.${name}`, title: part.description, least: part.minimum ?? 0,
      most: Math.max(3, Number(values[name] ?? 0)), usual: Number(part.default ?? 1),
    }));
  if ("bands" in values) {
    const row = labelled("bands", field(studio, index, "gains.bands", parts["bands"]!), parts["bands"]!.description);
    const remove = element("button", { type: "button", class: "small", "aria-label": "remove bands" }, "×");
    remove.addEventListener("click", () => setAt(studio, index, "gains.bands", undefined));
    row.append(remove);
    made.push(row);
  } else {
    made.push(adder("add gains of single bands…", ["bands"], () => setAt(studio, index, "gains.bands", [0.3, 0.3, 1.8])));
  }
  return made;
}

/** Examples, and motion files that may be chosen; what stands there in any case. */
function motions(studio: Studio, now: Json | undefined): string[] {
  const files = studio.places.folders.flatMap(({ folder, motions: names }) =>
    names.map((name) => (folder === "." ? name : `${folder}/${name}`)));
  return [...new Set([...(typeof now === "string" && now ? [now] : []), ...studio.choices.examples, ...files])];
}

/** Two standing poses: a motion and a frame of it each. */
function pose(studio: Studio, index: number): HTMLElement[] {
  const values = mapOf(stepsOf(studio.stimulus()!)[index]!["pose"]);
  const set = (name: string, one: JsonMap): void => {
    const frame = Number(one["frame"] ?? 0);
    setInStep(studio, index, "pose", withMember(values, name, frame > 0 ? { motion: one["motion"]!, frame } : one["motion"]!));
  };
  return ["neutral", "posed"].map((name) => {
    const given = values[name];
    const one: JsonMap = isMap(given) ? given : { motion: given ?? "" };
    const motion = choice(motions(studio, one["motion"]), String(one["motion"]), (chosen) => set(name, { ...one, motion: chosen }));
    motion.setAttribute("aria-label", `${name} pose`);
    const frame = number(one["frame"] ?? 0, { minimum: 0, type: "integer" }, (chosen) => set(name, { ...one, frame: chosen }));
    frame.setAttribute("aria-label", `${name} pose, frame`);
    const row = labelled(name, motion);
    row.append(element("span", { class: "quiet" }, "frame"), frame);
    return row;
  });
}
