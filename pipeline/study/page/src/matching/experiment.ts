import type { InterfaceKind } from "../live/core";
import type { Demographic, Planned } from "../questionnaire/experiment";

/** A matching experiment, as `mien study export` and `serve` write it. */
export interface MatchingExperiment extends Planned<MatchingSession> {
  format: "mien-matching-1";
  study: string;
  title: string;
  language: "en" | "ja";
  simulated: boolean;
  texts: { consent: string[]; instructions: string[]; ending: string[] };
  settings: { phones: "refused" | "served" };
  matching: MatchingSettings;
  demographics: Demographic[];
}

export interface MatchingSettings {
  /** Seconds for a match, after the guess. */
  limit_s: number;
  /** D below which a motion matches, metres. */
  threshold_m: number;
  shows_distance: boolean;
  /** guesses-first: with all interfaces a guess at a target before anything is seen of one. */
  order?: "trial-by-trial" | "guesses-first";
  /** Whether the examples play beside. */
  shows_examples?: boolean;
  target_colour: string;
  created_colour: string;
  /** By interface: there from the beginning, and may be added. */
  sliders: Partial<Record<InterfaceKind, { shown: string[]; offered: string[] }>>;
}

export interface MatchingSession {
  participant: string;
  seed: string;
  trials: MatchingTrial[];
}

export interface MatchingTrial {
  number: number;
  block: string;
  kind: "matching";
  target: string;
  interface: InterfaceKind;
  practice: boolean;
}

export interface SliderSetting {
  sliders: string[];
  /** 0 to 1. */
  values: number[];
}

/** Something that a participant did. */
export interface MatchingChange {
  /** Seconds since the trial began. */
  s: number;
  step: "guess" | "adjust";
  action: "move" | "add" | "remove" | "guess" | "match" | "limit";
  slider?: string;
  value?: number;
  /** Of the motion that came of it, metres; not there where none was made of it. */
  d?: number;
}

/** A guess that was made without seeing what comes of it. */
export interface Guess {
  first: SliderSetting;
  d: number;
  /** Seconds that it took. */
  s: number;
  /** How often it was begun: more than once after a reload. */
  attempt: number;
  changes: MatchingChange[];
}

/** A trial as it is kept (pipeline/study/questionnaire/service/matching_record.h). */
export interface MatchingRecord {
  first: SliderSetting;
  first_guess_d: number;
  guess_s: number;
  last: SliderSetting;
  d: number;
  time_s: number;
  success: boolean;
  attempt: number;
  changes: MatchingChange[];
}

/** Throws with words for whoever runs the study. */
export function checked_matching(experiment: unknown): MatchingExperiment {
  const given = experiment as Partial<MatchingExperiment> | null | undefined;
  if (given?.format !== "mien-matching-1" || !given.sessions?.length)
    throw new Error("This is no matching experiment that this page understands; export it again.");
  return given as MatchingExperiment;
}
