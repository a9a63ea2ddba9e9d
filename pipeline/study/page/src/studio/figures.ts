import { isMap, mapOf, type Json } from "./document";
import type { Studio } from "./studio";

// Figures in the words of choices: "mannequin", "character robot.glb".

const character = "character ";

const fileOf = (figure: Json | undefined): string => {
  const name = mapOf(figure)["character"];
  return typeof name === "string" ? name : "";
};

/** What a figure is called in a choice; "" where there is none. */
export function figureText(figure: Json | undefined): string {
  if (typeof figure === "string") return figure;
  if (!isMap(figure)) return "";
  return fileOf(figure) ? character + fileOf(figure) : Object.keys(figure)[0] ?? "";
}

/** The figure of what a choice says; null for "". */
export const figureOfText = (text: string): Json =>
  text.startsWith(character) ? { character: text.slice(character.length) } : text || null;

/** Characters that the manifest names, and those in its folders. */
export function charactersOf(studio: Studio): string[] {
  const document = studio.document();
  const figures = [document, ...document.stimuli].map((one) => mapOf(one["look"])["figure"]);
  const files = [...figures.map(fileOf).filter((name) => name !== ""), ...studio.places.characters];
  return [...new Set(files)].map((name) => character + name);
}
