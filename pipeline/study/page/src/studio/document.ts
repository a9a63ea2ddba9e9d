// A manifest as the page holds it: what the file says, in JSON, every change a new document.

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type JsonMap = { [key: string]: Json };

export interface Document extends JsonMap {
  study: string;
  stimuli: Stimulus[];
}

export interface Stimulus extends JsonMap {
  id: string;
}

/** A manifest's file as it was read: its text, what it says, and what tells it apart from others. */
export interface ManifestState {
  text: string;
  version: string;
  document: Document;
}

export type Kind = "adjectives" | "features" | "weights";
export const kinds: Kind[] = ["adjectives", "features", "weights"];

/** What a stimulus is made from: sliders of a kind, a motion file, a path that is walked, several people, or another
    stimulus. */
export const sourceOf = (stimulus: Stimulus): Kind | "clip" | "path" | "people" | "foil" =>
  kinds.find((kind) => kind in stimulus) ??
  (["clip", "path", "people"] as const).find((kind) => kind in stimulus) ?? "foil";

export const isMap = (value: Json | undefined): value is JsonMap =>
  typeof value === "object" && value !== null && !Array.isArray(value);

export const mapOf = (value: Json | undefined): JsonMap => (isMap(value) ? value : {});

/** With a member set, or without it where the value is undefined; order stays. */
export function withMember<Map extends JsonMap>(map: Map, key: string, value: Json | undefined): Map {
  const made: JsonMap = { ...map };
  if (value === undefined) delete made[key];
  else made[key] = value;
  return made as Map;
}

export const find = (document: Document, id: string): Stimulus | undefined =>
  document.stimuli.find((stimulus) => stimulus.id === id);

/** With that figure for all stimuli and examples. */
export function withFigure(document: Document, figure: Json): Document {
  const wearing = (one: JsonMap): JsonMap => withMember(one, "look", { ...mapOf(one["look"]), figure });
  const made = wearing(document) as Document;
  made.stimuli = document.stimuli.map((one) => ("look" in one ? (wearing(one) as Stimulus) : one));
  return made;
}

/** An id that no stimulus has: "walk", "walk-2", … */
export function freeId(document: Document, wanted: string): string {
  const stem = wanted.replace(/-\d+$/, "");
  for (let number = 1; ; number += 1) {
    const id = number === 1 && stem !== wanted ? wanted : `${stem}-${number}`;
    if (!find(document, id)) return id;
  }
}

/** Names of a stimulus in sheets, overlays and foils are changed with it. */
function renamedIn(value: Json, from: string, to: string): Json {
  if (value === from) return to;
  if (Array.isArray(value)) return value.map((one) => renamedIn(one, from, to));
  if (!isMap(value)) return value;
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, renamedIn(one, from, to)]));
}

export function withNewId(document: Document, from: string, to: string): Document {
  const made = { ...document };
  for (const part of ["sheets", "overlays"])
    if (made[part] !== undefined) made[part] = renamedIn(made[part]!, from, to);
  made.stimuli = document.stimuli.map((one) => {
    if (one.id === from) return { ...one, id: to };
    const foil = mapOf(one["foil"]);
    return foil["of"] === from ? withMember(one, "foil", { ...foil, of: to }) : one;
  });
  return made;
}

const names = (value: Json | undefined, id: string): boolean =>
  value === id || (Array.isArray(value) && value.some((one) => names(one, id))) ||
  (isMap(value) && Object.values(value).some((one) => names(one, id)));

/** Parts of a manifest, and foils, that name a stimulus. */
export const partsNaming = (document: Document, id: string): string[] => [
  ...["sheets", "overlays", "questionnaire", "matching"].filter((part) => names(document[part], id)),
  ...document.stimuli.filter((one) => mapOf(one["foil"])["of"] === id).map((one) => one.id),
];

/** Without what no motion or film is made of; which other stimuli one goes by, the studio's server knows. */
export function about(document: Document, ids: string[]): JsonMap {
  const made: JsonMap = { ...document };
  for (const part of ["sheets", "overlays", "questionnaire", "matching", "regression"]) delete made[part];
  if (ids.length === 0) made["stimuli"] = [];
  return made;
}

/** A number as people would write it: at most three digits behind the point. */
export const rounded = (value: number): number => Math.round(value * 1000) / 1000;
