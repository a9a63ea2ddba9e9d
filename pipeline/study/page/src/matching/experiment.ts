import type { InterfaceKind } from "../live/core";
import type { LiveExperiment } from "../live_study/experiment";

/** A matching experiment, as `mien study export` and `serve` write it. */
export interface MatchingExperiment extends LiveExperiment<MatchingSession> {
  format: "mien-matching-1";
  matching: MatchingSettings;
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

/** Throws with words for whoever runs the study. */
export function checkedMatching(experiment: unknown): MatchingExperiment {
  const given = experiment as Partial<MatchingExperiment> | null | undefined;
  if (given?.format !== "mien-matching-1" || !given.sessions?.length)
    throw new Error("This page cannot read the matching experiment; export it again.");
  return given as MatchingExperiment;
}
