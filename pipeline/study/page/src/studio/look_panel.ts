import { element } from "../questionnaire/elements";
import { is_map, map_of, with_member, type Json, type JsonMap } from "./document";
import { characters_of, figure_of_text, figure_text } from "./figures";
import { choice, labelled } from "./fields";
import { keep_built } from "./kept";
import type { Studio } from "./studio";

/** Look of a stimulus, the study's own with its own over them. */
export function look_of(studio: Studio): JsonMap {
  return { ...map_of(studio.document()["look"]), ...map_of(studio.stimulus()?.["look"]) };
}

/** What a value is called: its name, the one name in a map, or a file. */
export function name_of(value: Json | undefined, usual: string): string {
  if (typeof value === "string") return value;
  if (!is_map(value)) return usual;
  const named = value["view"] ?? value["set"];
  if (typeof named === "string") return named;
  return Object.keys(value)[0] ?? usual;
}

/** The set, the camera and the figure, of the whole study or of one stimulus. */
export function look_panel(studio: Studio): HTMLElement {
  const panel = element("section", { class: "panel", "aria-label": "Look" });
  let is_own = false;
  const build = (): void => {
    const look = look_of(studio);
    const whose = choice(["all", "own"], is_own ? "own" : "all", (name) => {
      is_own = name === "own";
      build();
    }, (name) => (name === "own" ? `${studio.selected} alone` : "all stimuli"));
    const field = (key: string, names: string[], usual: string): HTMLElement => {
      const is_figure = key === "figure";
      const now = (is_figure && figure_text(look[key])) || name_of(look[key], usual);
      const select = choice([...new Set([now, ...names])], now,
        (name) => set_look(studio, is_own, key, is_figure ? figure_of_text(name) : name));
      select.name = key;
      const own = key in map_of(studio.stimulus()?.["look"]);
      const made = labelled(key, select);
      if (own) made.append(element("span", { class: "quiet" }, "of its own"));
      return made;
    };
    const own = map_of(studio.stimulus()?.["look"]);
    panel.replaceChildren(
      labelled("Change it for", whose),
      field("scene", studio.words.scenes, "studio"),
      field("camera", studio.words.cameras, "three-quarter"),
      field("figure", [...studio.words.figures, ...characters_of(studio)], "stick"),
      element("p", { class: "quiet" }, "The page shows the figure, the set's colours and the camera's direction. A still "
        + "shows what the film will look like."));
    if (Object.keys(own).length > 0) {
      const back = element("button", { type: "button", class: "button" }, `${studio.selected}: as all stimuli`);
      back.addEventListener("click", () => studio.change_stimulus(with_member(studio.stimulus()!, "look", undefined)));
      panel.append(back);
    }
  };
  keep_built(studio, () => [studio.selected, studio.document()["look"], studio.stimulus()?.["look"], characters_of(studio)], build);
  return panel;
}

function set_look(studio: Studio, is_own: boolean, key: string, name: Json): void {
  const document = studio.document();
  const stimulus = studio.stimulus();
  if (is_own && stimulus) {
    studio.change_stimulus(with_member(stimulus, "look", with_member(map_of(stimulus["look"]), key, name)));
  } else {
    studio.change(with_member(document, "look", with_member(map_of(document["look"]), key, name)));
  }
}
