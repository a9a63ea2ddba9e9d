import type { SettingKind } from "../live/core";
import type { LiveExperiment } from "../live_study/experiment";

/** Gibbs sampling with people (Harrison et al. 2020) or MCMC with people (Sanborn and Griffiths 2008). */
export interface ChainExperiment extends LiveExperiment<ChainSession> {
  format: "mien-chains-1";
  chains: ChainSettings;
}

export interface Dimension {
  /** A slider of the motion core. */
  name: string;
  low: number;
  high: number;
}

export interface ChainSettings {
  method: "gibbs" | "mcmc";
  /** Whether a server hands out each step; otherwise each participant has chains of their own. */
  across_participants: boolean;
  kind: SettingKind;
  dimensions: Dimension[];
  /** As they are shown, by their ids. */
  words: Record<string, string>;
  colour: string;
  /** Of MCMC: the standard deviation of proposals, a share of each range. */
  deviation: number;
  /** A server ends the session of whoever fails more attention checks. */
  max_failed_checks?: number;
}

export interface ChainSession {
  participant: string;
  seed: string;
  /** Where the chains begin, "sad/1"; "practice/1" of practice. */
  starts: Record<string, number[]>;
  trials: ChainTrial[];
}

/** Where a slider stands at first. */
export interface SliderStart {
  /** A share of the range. */
  start: number;
  /** The high end is on the left. */
  reversed: boolean;
}

export type CheckSide = "left" | "right";

/** What chains of a participant's own, and those of practice, have fixed in the plan. */
export interface ChainTrial {
  number: number;
  block: string;
  kind: "chain";
  practice: boolean;
  /** Of an attention check: the end of the slider, or the side of the figure, that it asks for. */
  expected?: CheckSide;
  media: [];
  word?: string;
  chain?: number;
  step?: number;
  dimension?: number;
  slider?: SliderStart;
  /** Standard normal deviates, one a dimension. */
  normals?: number[];
  proposal_first?: boolean;
}

/** Texts in other languages have only what differs: the words. */
type InLanguage = Partial<Omit<ChainExperiment, "chains">> & { chains?: Partial<ChainSettings> };

/** Throws with words for whoever runs the study. */
export function checkedChains(experiment: unknown): ChainExperiment {
  const given = experiment as Partial<ChainExperiment> | null | undefined;
  if (given?.format !== "mien-chains-1" || !given.sessions?.length || !given.chains)
    throw new Error("This page cannot read the experiment; export it again.");
  const { chains, languages } = given;
  if (!languages) return given as ChainExperiment;
  const complete = Object.entries(languages as Record<string, InLanguage>).map(([language, texts]) =>
    [language, { ...texts, chains: { ...chains, ...texts.chains } }]);
  return { ...given, languages: Object.fromEntries(complete) } as ChainExperiment;
}
