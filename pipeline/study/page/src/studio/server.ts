// What the studio's server is asked (pipeline/study/studio/studio_service.h).

import type { FaceFrames } from "../figure/face";
import type { JointPoses } from "../figure/figure";
import { countOfPeople, type PeopleHead } from "../figure/people";
import { readMotion } from "../live/answers";
import type { LiveMotion, Slider } from "../live/core";
import type { Body } from "../figure/body_shape";
import { about, type Document, type Json, type JsonMap, type ManifestState, type Stimulus } from "./document";
import { Refusal, type Fault } from "./refusal";

export interface Recipe {
  name: string;
  note: string;
}

/** Of a manifest's key, what its schema says (manifests/mien.schema.json). */
export interface KeySchema {
  title: string;
  description: string;
  type?: "number" | "integer" | "boolean" | "string" | "array" | "object";
  enum?: string[];
  minimum?: number;
  maximum?: number;
  default?: Json;
  examples?: Json[];
  items?: Omit<KeySchema, "title" | "description">;
  properties?: Record<string, KeySchema>;
  oneOf?: KeySchema[];
}

export interface Words {
  sets: string[];
  recipes: Recipe[];
  posture: { name: string; note: string }[];
  /** The keys of a step of a modification. */
  modification: Record<string, KeySchema>;
  scenes: string[];
  cameras: string[];
  hands: string[];
  figures: string[];
  /** Of these, those with a surface. */
  bodies: string[];
}

export interface StudioState {
  file: string;
  place: string;
  is_on_disk: boolean;
  /** Whether the walker's page is there, and what it runs on. */
  walker: boolean;
  /** The picture or film that was begun last, perhaps by a page that was closed since. */
  job: Job | null;
  manifest: ManifestState;
  words: Words;
}

export interface Choices {
  examples: string[];
  sliders: { adjectives: Slider[]; features: Slider[] };
  blendable: boolean;
  simulated: boolean;
  warnings: string[];
}

/** What of the user's folders may be chosen (pipeline/study/studio/studio_places.h). */
export interface Places {
  folders: { folder: string; motions: string[] }[];
  characters: string[];
  all: boolean;
}

export interface Finding {
  check: string;
  joint: string;
  first: number;
  last: number;
  is_error: boolean;
  sentence: string;
}

export interface Made {
  motion: LiveMotion;
  body: Body;
  /** The body with the joints of its hands; null where it is not human. */
  hands: Body | null;
  findings: Finding[];
  warnings: string[];
  notes: string[];
  reached: Record<string, number>;
  weights: Record<string, number>;
  modified: string;
  seconds: number;
  distance: { D: number; D_sum: number; by_joint: number[]; by_time: number[] } | null;
  /** What it is shown on, if that comes as a file; joints: of its own, 0 for the body's (page_figures.h). */
  figure: { key: string; joints: number; has_hands: boolean; morphs: number; face_frames: number };
  /** Where a figure's own joints are; null: those of the body. */
  poses: JointPoses | null;
  /** How its face moves; null: it does not. */
  face: FaceFrames | null;
  /** Of several people, of whom the motion is the first's: all of them. */
  people: People | null;
}

/** What is told of several people, whose figures are asked for by their keys. */
export interface People {
  head: PeopleHead;
  numbers: Float32Array;
}

export interface Job {
  job: number;
  kind: "still" | "video";
  stimulus: string;
  state: "running" | "done" | "failed" | "cancelled";
  share: number;
  told: string;
}

async function answerTo(what: string, body?: unknown): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(what, body === undefined ? {} : {
      method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body),
    });
  } catch {
    throw new Refusal([{ path: "", wrong: "the studio does not answer",
      remedy: "has it been ended in its terminal? Play from the beginning: this page has lost its link" }]);
  }
  if (response.ok) return response;
  const told = (await response.json().catch(() => ({}))) as Partial<Fault> & { faults?: Fault[] };
  throw new Refusal(told.faults ??
    [{ path: "", wrong: told.wrong ?? `the studio answered ${response.status}`, remedy: told.remedy ?? "" }],
    response.status, told);
}

/** Faults of a part of a document tell the places of stimuli in the whole of it. */
const ofWhole = (document: Document, part: JsonMap) => (refusal: unknown): never => {
  if (!(refusal instanceof Refusal)) throw refusal;
  const place = (all: string, index: string): string => {
    const at = document.stimuli.indexOf((part["stimuli"] as Stimulus[])[Number(index)]!);
    return at < 0 ? all : `stimuli[${at}]`;
  };
  throw new Refusal(refusal.faults.map((fault) => ({ ...fault, path: fault.path.replace(/^stimuli\[(\d+)\]/, place) })),
    refusal.status);
};

const jsonOf = async <Told>(what: string, body?: unknown): Promise<Told> =>
  (await (await answerTo(what, body)).json()) as Told;

export const loadStudio = (): Promise<StudioState> => jsonOf("studio.json");
export const loadChoices = (document: Document): Promise<Choices> =>
  jsonOf("choices", { document: about(document, []) });

export async function make(document: Document, show: string, against: string): Promise<Made> {
  const body = { document: about(document, [show, against]), show, against };
  const bytes = await (await answerTo("motion", body).catch(ofWhole(document, body.document))).arrayBuffer();
  const length = new DataView(bytes).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length))) as
    Omit<Made, "motion" | "poses" | "face" | "people"> & { people: PeopleHead | null };
  if (head.people) {
    const peopleAt = bytes.byteLength - 4 * countOfPeople(head.people);
    return { ...head, motion: readMotion(bytes.slice(4 + length, peopleAt)), poses: null, face: null,
      people: { head: head.people, numbers: new Float32Array(bytes.slice(peopleAt)) } };
  }
  const { joints, has_hands, morphs, face_frames } = head.figure;
  const faceAt = bytes.byteLength - 4 * morphs * face_frames;
  const posesAt = faceAt - 4 * 7 * joints * framesOf(bytes, 4 + length);
  return { ...head, people: null, motion: readMotion(bytes.slice(4 + length, posesAt)),
    poses: posesIn(bytes.slice(posesAt, faceAt), has_hands),
    face: morphs > 0 ? { weights: new Float32Array(bytes.slice(faceAt)), frames: face_frames } : null };
}

/** Of the motion that begins there. */
const framesOf = (bytes: ArrayBuffer, at: number): number => new DataView(bytes).getInt32(at + 4, true);

function posesIn(bytes: ArrayBuffer, hasHands: boolean): JointPoses | null {
  if (bytes.byteLength === 0) return null;
  const numbers = new Float32Array(bytes);
  const places = numbers.length / 7;
  return { positions: numbers.subarray(0, 3 * places), rotations: numbers.subarray(3 * places), hasHands };
}

/** The file of the figure that a motion is shown on; refused where it is another by now. */
export const loadFigure = async (document: Document, show: string, key: string): Promise<ArrayBuffer> =>
  (await answerTo("figure", { document: about(document, [show]), show, key })).arrayBuffer();

export const loadPlaces = (): Promise<Places> => jsonOf("places", {});

/** The file's text was made from that of `version`, and says what the document does. */
export const save = (document: Document, text: string, version: string): Promise<ManifestState & { saved: boolean }> =>
  jsonOf("save", { document, text, version });
export const reload = (): Promise<ManifestState> => jsonOf("reload", {});

export const beginJob = (document: Document, job: JsonMap): Promise<Job> =>
  jsonOf("jobs", { document: about(document, [String(job["stimulus"])]), ...job });
export const jobTold = (job: number): Promise<Job> => jsonOf(`jobs/${job}`);
export const cancelJob = (job: number): Promise<unknown> => jsonOf(`jobs/${job}/cancel`, {});
export const jobResult = (job: number): string => `jobs/${job}/result`;
