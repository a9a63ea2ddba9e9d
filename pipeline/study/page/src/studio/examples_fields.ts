import { element } from "../questionnaire/elements";
import { is_map, map_of, source_of, with_member, type Json, type JsonMap } from "./document";
import { choice, labelled } from "./fields";
import type { Studio } from "./studio";

/** What a set of examples is called: a built-in one, or its folder. */
function set_text(set: Json | undefined): string {
  if (typeof set === "string") return set;
  const folder = map_of(set)["folder"];
  return typeof folder === "string" ? folder : "";
}

const examples_of = (studio: Studio): JsonMap => map_of(studio.document()["examples"]);

/** The examples of the whole study: a built-in set, or a folder of captures. */
export function example_fields(studio: Studio): HTMLElement[] {
  const { set } = examples_of(studio);
  const { folders } = studio.places;
  const names = [set_text(set), set_text(studio.opened_examples["set"]), ...studio.words.sets,
    ...folders.map((one) => one.folder)];
  const chosen = choice([...new Set(names)].filter((name) => name !== ""), set_text(set),
    (name) => choose(studio, name), (name) => with_count(studio, name));
  chosen.name = "examples";
  const fields: HTMLElement[] = [labelled("Examples", chosen, "of the whole study: built-in, or a folder of motion files")];
  if (is_map(set)) fields.push(...folder_fields(studio, set));
  return fields;
}

function with_count(studio: Studio, name: string): string {
  const found = studio.places.folders.find((one) => one.folder === name);
  if (!found) return name;
  const place = name === "." ? "the manifest's folder" : name;
  return `${place} (${found.motions.length} ${found.motions.length === 1 ? "motion" : "motions"})`;
}

/** With ratings that there can be: adjectives of captures that nobody rated are simulated, which every
    output says. */
function choose(studio: Studio, name: string): void {
  const { opened_examples } = studio;
  if (name === set_text(opened_examples["set"])) {
    studio.change(with_member(studio.document(), "examples", { ...opened_examples }));
    return;
  }
  const is_builtin = studio.words.sets.includes(name);
  const needs_ratings = studio.document().stimuli.some((one) => source_of(one) === "adjectives");
  let examples = with_member(examples_of(studio), "set", is_builtin ? name : { folder: name });
  for (const key of ["unknown", "expect"]) examples = with_member(examples, key, undefined);
  const ratings = is_builtin ? (name === "builtin:actors" ? undefined : "builtin") : needs_ratings ? "simulated" : undefined;
  studio.change(with_member(studio.document(), "examples", with_member(examples, "ratings", ratings)));
}

/** Which of its files, and what was thought of them. */
function folder_fields(studio: Studio, set: JsonMap): HTMLElement[] {
  const change = (examples: JsonMap): void => studio.change(with_member(studio.document(), "examples", examples));
  const pattern = (key: string, title: string): HTMLElement => {
    const field = element("input", { type: "text", name: key, spellcheck: "false",
      placeholder: key === "include" ? "all" : "none" });
    field.value = String(set[key] ?? "");
    field.addEventListener("change", () => {
      const wanted = field.value.trim();
      change(with_member(examples_of(studio), "set", with_member(set, key, wanted || undefined)));
    });
    return labelled(key, field, title);
  };
  const ratings = examples_of(studio)["ratings"];
  const now = typeof ratings === "string" ? ratings : "none";
  const opened = studio.opened_examples["ratings"];
  const names = [now, "none", "simulated", ...(typeof opened === "string" && opened !== "builtin" ? [opened] : [])];
  const rated = choice([...new Set(names)], now, (name) =>
    change(with_member(examples_of(studio), "ratings", name === "none" ? undefined : name)));
  rated.name = "ratings";
  return [pattern("include", "which files of the folder, by a pattern of their names: *walk*.bvh"),
    pattern("exclude", "files that are left out"),
    labelled("Ratings", rated, "what people thought of the examples; simulated: from measured features")];
}
