// What the studio's server is asked (pipeline/studio/studio_service.h).

import { read_motion } from "../live/answers";
import type { LiveMotion, Slider } from "../live/core";
import type { Body } from "../figure/body_shape";
import { about, type Document, type JsonMap } from "./document";

export interface ManifestState {
  text: string;
  version: string;
  document: Document;
}

export interface Recipe {
  name: string;
  note: string;
}

export interface Words {
  sets: string[];
  recipes: Recipe[];
  posture: { name: string; note: string }[];
  scenes: string[];
  cameras: string[];
  figures: string[];
}

export interface StudioState {
  file: string;
  place: string;
  is_on_disk: boolean;
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
  findings: Finding[];
  warnings: string[];
  notes: string[];
  reached: Record<string, number>;
  weights: Record<string, number>;
  modified: string;
  seconds: number;
  distance: { D: number; D_sum: number; by_joint: number[]; by_time: number[] } | null;
}

export interface Job {
  job: number;
  kind: "still" | "video";
  stimulus: string;
  state: "running" | "done" | "failed" | "cancelled";
  share: number;
  told: string;
}

export interface Fault {
  path: string;
  wrong: string;
  remedy: string;
}

/** What the server refuses, in words for people. */
export class Refusal extends Error {
  constructor(readonly status: number, readonly faults: Fault[]) {
    super(faults.map(sentence_of).join("\n"));
  }
}

export const sentence_of = ({ path, wrong, remedy }: Fault): string =>
  `${path ? `${path}: ` : ""}${wrong}${remedy ? `; ${remedy}` : ""}`;

async function answer_to(what: string, body?: unknown): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(what, body === undefined ? {} : {
      method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body),
    });
  } catch {
    throw new Refusal(0, [{ path: "", wrong: "the studio does not answer",
      remedy: "has it been ended in its terminal? Start it again: this page has lost its link" }]);
  }
  if (response.ok) return response;
  const told = (await response.json().catch(() => ({}))) as Partial<Fault> & { faults?: Fault[] };
  throw new Refusal(response.status, told.faults ??
    [{ path: "", wrong: told.wrong ?? `the studio answered ${response.status}`, remedy: told.remedy ?? "" }]);
}

const json_of = async <Told>(what: string, body?: unknown): Promise<Told> =>
  (await (await answer_to(what, body)).json()) as Told;

export const load_studio = (): Promise<StudioState> => json_of("studio.json");
export const load_choices = (document: Document): Promise<Choices> =>
  json_of("choices", { document: about(document, []) });

export async function make(document: Document, show: string, against: string): Promise<Made> {
  const body = { document: about(document, [show, against]), show, against };
  const bytes = await (await answer_to("motion", body)).arrayBuffer();
  const length = new DataView(bytes).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length))) as Omit<Made, "motion">;
  return { ...head, motion: read_motion(bytes.slice(4 + length)) };
}

/** The manifest as it would be saved, and the lines of one stimulus. */
export const text_of = (document: Document, show: string): Promise<{ text: string; stimulus: string }> =>
  json_of("text", { document, show });

export const save = (document: Document, version: string, over: boolean): Promise<ManifestState & { saved: boolean }> =>
  json_of("save", { document, version, over });
export const reload = (): Promise<ManifestState> => json_of("reload", {});

export const begin_job = (document: Document, job: JsonMap): Promise<Job> =>
  json_of("jobs", { document: about(document, [String(job["stimulus"])]), ...job });
export const job_told = (job: number): Promise<Job> => json_of(`jobs/${job}`);
export const cancel_job = (job: number): Promise<unknown> => json_of(`jobs/${job}/cancel`, {});
export const job_result = (job: number): string => `jobs/${job}/result`;
