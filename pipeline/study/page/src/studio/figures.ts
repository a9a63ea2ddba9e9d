import { is_map, map_of, type Json } from "./document";
import type { Studio } from "./studio";

// Figures in the words of choices: "mannequin", "character robot.glb".

const character = "character ";

const file_of = (figure: Json | undefined): string => {
  const name = map_of(figure)["character"];
  return typeof name === "string" ? name : "";
};

/** What a figure is called in a choice; "" where there is none. */
export function figure_text(figure: Json | undefined): string {
  if (typeof figure === "string") return figure;
  if (!is_map(figure)) return "";
  return file_of(figure) ? character + file_of(figure) : Object.keys(figure)[0] ?? "";
}

/** The figure of what a choice says; null for "". */
export const figure_of_text = (text: string): Json =>
  text.startsWith(character) ? { character: text.slice(character.length) } : text || null;

/** Characters that the manifest names, and those in its folders. */
export function characters_of(studio: Studio): string[] {
  const document = studio.document();
  const figures = [document, ...document.stimuli].map((one) => map_of(one["look"])["figure"]);
  const files = [...figures.map(file_of).filter((name) => name !== ""), ...studio.places.characters];
  return [...new Set(files)].map((name) => character + name);
}
