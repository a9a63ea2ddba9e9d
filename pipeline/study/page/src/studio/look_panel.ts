import { element } from "../questionnaire/elements";
import { isMap, mapOf, withMember, type Json, type JsonMap } from "./document";
import { charactersOf, figureOfText, figureText } from "./figures";
import { choice, labelled } from "./fields";
import { keepBuilt } from "./kept";
import type { Studio } from "./studio";

/** Look of a stimulus, the study's own with its own over them. */
export function lookOf(studio: Studio): JsonMap {
  return { ...mapOf(studio.document()["look"]), ...mapOf(studio.stimulus()?.["look"]) };
}

/** What a value is called: its name, the one name in a map, or a file. */
export function nameOf(value: Json | undefined, usual: string): string {
  if (typeof value === "string") return value;
  if (!isMap(value)) return usual;
  const named = value["view"] ?? value["set"];
  if (typeof named === "string") return named;
  return Object.keys(value)[0] ?? usual;
}

/** The set, the camera and the figure, of the whole study or of one stimulus. */
export function lookPanel(studio: Studio): HTMLElement {
  const panel = element("section", { class: "panel", "aria-label": "Look" });
  let isOwn = false;
  const build = (): void => {
    const look = lookOf(studio);
    const whose = choice(["all", "own"], isOwn ? "own" : "all", (name) => {
      isOwn = name === "own";
      build();
    }, (name) => (name === "own" ? `${studio.selected} only` : "all stimuli"));
    const field = (key: string, names: string[], usual: string): HTMLElement => {
      const isFigure = key === "figure";
      const now = (isFigure && figureText(look[key])) || nameOf(look[key], usual);
      const select = choice([...new Set([now, ...names])], now,
        (name) => setLook(studio, isOwn, key, isFigure ? figureOfText(name) : name));
      select.name = key;
      const own = key in mapOf(studio.stimulus()?.["look"]);
      const made = labelled(key, select);
      if (own) made.append(element("span", { class: "quiet" }, "of this stimulus"));
      return made;
    };
    const own = mapOf(studio.stimulus()?.["look"]);
    panel.replaceChildren(
      labelled("Applies to", whose),
      field("scene", studio.words.scenes, "studio"),
      field("camera", studio.words.cameras, "three-quarter"),
      field("figure", [...studio.words.figures, ...charactersOf(studio)], "stick"),
      field("hands", studio.words.hands, "auto"),
      element("p", { class: "quiet" }, "The page shows the figure, the set's colours and the camera direction. A still "
        + "shows the final appearance."));
    if (Object.keys(own).length > 0) {
      const back = element("button", { type: "button", class: "button" }, `${studio.selected}: same as all stimuli`);
      back.addEventListener("click", () => studio.changeStimulus(withMember(studio.stimulus()!, "look", undefined)));
      panel.append(back);
    }
  };
  keepBuilt(studio, () => [studio.selected, studio.document()["look"], studio.stimulus()?.["look"], charactersOf(studio)], build);
  return panel;
}

function setLook(studio: Studio, isOwn: boolean, key: string, name: Json): void {
  const document = studio.document();
  const stimulus = studio.stimulus();
  if (isOwn && stimulus) {
    studio.changeStimulus(withMember(stimulus, "look", withMember(mapOf(stimulus["look"]), key, name)));
  } else {
    studio.change(withMember(document, "look", withMember(mapOf(document["look"]), key, name)));
  }
}
