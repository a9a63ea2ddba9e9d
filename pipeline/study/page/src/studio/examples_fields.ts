import { element } from "../questionnaire/elements";
import { isMap, mapOf, sourceOf, withMember, type Json, type JsonMap } from "./document";
import { choice, labelled } from "./fields";
import type { Studio } from "./studio";

/** What a set of examples is called: a built-in one, or its folder. */
function setText(set: Json | undefined): string {
  if (typeof set === "string") return set;
  const folder = mapOf(set)["folder"];
  return typeof folder === "string" ? folder : "";
}

const examplesOf = (studio: Studio): JsonMap => mapOf(studio.document()["examples"]);

/** The examples of the whole study: a built-in set, or a folder of captures. */
export function exampleFields(studio: Studio): HTMLElement[] {
  const { set } = examplesOf(studio);
  const { folders } = studio.places;
  const names = [setText(set), setText(studio.openedExamples["set"]), ...studio.words.sets,
    ...folders.map((one) => one.folder)];
  const chosen = choice([...new Set(names)].filter((name) => name !== ""), setText(set),
    (name) => choose(studio, name), (name) => withCount(studio, name));
  chosen.name = "examples";
  const fields: HTMLElement[] = [labelled("Examples", chosen, "for the whole study: built-in, or a folder of motion files")];
  if (isMap(set)) fields.push(...folderFields(studio, set));
  return fields;
}

function withCount(studio: Studio, name: string): string {
  const found = studio.places.folders.find((one) => one.folder === name);
  if (!found) return name;
  const place = name === "." ? "the manifest's folder" : name;
  return `${place} (${found.motions.length} ${found.motions.length === 1 ? "motion" : "motions"})`;
}

/** With ratings that there can be: adjectives of captures that nobody rated are simulated, which every
    output says. */
function choose(studio: Studio, name: string): void {
  const { openedExamples: openedExamples } = studio;
  if (name === setText(openedExamples["set"])) {
    studio.change(withMember(studio.document(), "examples", { ...openedExamples }));
    return;
  }
  const isBuiltin = studio.words.sets.includes(name);
  const needsRatings = studio.document().stimuli.some((one) => sourceOf(one) === "adjectives");
  let examples = withMember(examplesOf(studio), "set", isBuiltin ? name : { folder: name });
  for (const key of ["unknown", "expect"]) examples = withMember(examples, key, undefined);
  const ratings = isBuiltin ? (name === "builtin:actors" ? undefined : "builtin") : needsRatings ? "simulated" : undefined;
  studio.change(withMember(studio.document(), "examples", withMember(examples, "ratings", ratings)));
}

/** Which of its files, and what was thought of them. */
function folderFields(studio: Studio, set: JsonMap): HTMLElement[] {
  const change = (examples: JsonMap): void => studio.change(withMember(studio.document(), "examples", examples));
  const pattern = (key: string, title: string): HTMLElement => {
    const field = element("input", { type: "text", name: key, spellcheck: "false",
      placeholder: key === "include" ? "all" : "none" });
    field.value = String(set[key] ?? "");
    field.addEventListener("change", () => {
      const wanted = field.value.trim();
      change(withMember(examplesOf(studio), "set", withMember(set, key, wanted || undefined)));
    });
    return labelled(key, field, title);
  };
  const ratings = examplesOf(studio)["ratings"];
  const now = typeof ratings === "string" ? ratings : "none";
  const opened = studio.openedExamples["ratings"];
  const names = [now, "none", "simulated", ...(typeof opened === "string" && opened !== "builtin" ? [opened] : [])];
  const rated = choice([...new Set(names)], now, (name) =>
    change(withMember(examplesOf(studio), "ratings", name === "none" ? undefined : name)));
  rated.name = "ratings";
  return [pattern("include", "files of the folder to use, as a pattern: *walk*.bvh"),
    pattern("exclude", "files to exclude"),
    labelled("Ratings", rated, "ratings of the examples; simulated: derived from measured features")];
}
