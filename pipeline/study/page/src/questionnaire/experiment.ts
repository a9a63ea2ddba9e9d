import type { ChainRecord } from "../chains/record";
import type { MatchingRecord } from "../matching/record";
import type { InLanguages } from "./language";

/** What a questionnaire shows, as `mien study export` and `serve` write it. */
export interface Experiment {
  format: "mien-questionnaire-1";
  study: string;
  title: string;
  /** Tag (BCP 47): of this page, once one of several was chosen. */
  language: string;
  languages?: InLanguages["languages"];
  page_texts?: InLanguages["page_texts"];
  design: string;
  simulated: boolean;
  texts: ExperimentTexts;
  /** Which consent text is shown. */
  consent?: ConsentText;
  settings: Settings;
  items: Record<string, Item>;
  /** What trials offer to choose from: as it is shown. */
  choices?: Record<string, string>;
  screening?: Screening;
  demographics: Demographic[];
  recruitment?: Recruitment;
  /** Where the participant of a finished session is sent to; from a server. */
  destination?: Destination;
  media: Record<string, Media>;
  /** Which stimulus a token stands for; never sent by a server. */
  stimuli?: Record<string, string>;
  sessions: Session[];
  adaptive?: Adaptive;
  /** Of adaptive trials: what the server has already, by the names of records. */
  answered?: Record<string, LevelAnswer>;
  /** Records that the server has already. */
  kept?: string[];
  /** Browser session that gave them, and alone may give more; empty before the first. */
  browser?: string;
  /** How the session ended early. */
  ended?: SessionEnd;
  /** Whoever agrees is given a session: there is none yet. */
  joining?: boolean;
  /** All places are taken: nobody is given one any more. */
  enough?: boolean;
}

export interface ExperimentTexts {
  consent: string[];
  instructions: string[];
  /** After the last answer and after withdrawal. */
  debriefing?: string[];
  ending: string[];
}

export interface ConsentText {
  version: string;
  sha256: string;
}

export type SessionEnd = "completed" | "screened_out" | "refused" | "withdrawn" | "failed_attention";

/** Choices, or numbers from … to. */
export type AnswerRange = string[] | { from?: number; to?: number };

/** What decides whether a participant may take part; a server does not send what it accepts. */
export interface Screening {
  questions?: (Demographic & { accept?: AnswerRange })[];
  /** Smallest width and height of the viewport, CSS pixels. */
  window?: [number, number];
  refresh_hz?: number;
  /** Tones are counted, to show that sound is heard. */
  sound?: boolean;
}

/** Where a participant is sent to: an address with parameters of the link in braces, and a code. */
export interface Destination {
  address: string;
  code: string;
}

export interface Recruitment {
  url_parameters: string[];
  pseudonymise: boolean;
  /** Whoever fails more attention checks has another end. */
  most_failed_checks: number;
  /** A server tells those of completed sessions at their end. */
  ends: Partial<Record<SessionEnd, Destination>>;
}

export interface Settings {
  /** "counted": as often as is liked; "none"; or how often at most. */
  replays: "counted" | "none" | number;
  watch: "full" | "free";
  comments: boolean;
  phones: "refused" | "served";
  view: "video" | "turn";
  /** As large as the window allows where it is not given. */
  display?: Display;
  /** Pairs are shown one after the other, not side by side. */
  pairs?: "in_turn";
  /** Above the items of a trial, in place of the usual question. */
  question?: string;
}

/** The size of stimuli on the screen. */
export interface Display {
  size: "native" | { cm: number } | { degrees: number };
  distance_cm: number;
  /** Whether the distance is measured with the blind spot, and what was measured in this session. */
  blind_spot?: boolean;
  measured_cm?: number;
}

/** A scale. */
export interface Item {
  low: string;
  high: string;
  points: number;
  slider: boolean;
  words?: boolean;
  /** Of free words: what is suggested while one types. */
  suggest?: string[];
  anchors: boolean;
  /** What is chosen before an answer is given. */
  default: "middle" | null;
  least: number;
  most: number;
  /** Of pairs: no preference may be answered, and preferences may be slight or strong. */
  ties?: boolean;
  strength?: boolean;
  /** How it is rated while a film plays: the mean leaves out the first seconds (lead); held keys move the marker
      by so many hundredths a second (speed). */
  continuous?: { input: "slider" | "keys"; start: "middle" | "low"; lead: number; speed: number };
}

export interface Demographic {
  id: string;
  ask: string;
  answer: "number" | "text" | string[];
  /** What is recorded of choices in their order, where that is not what is shown. */
  values?: string[];
  required?: boolean;
}

export interface Media {
  /** Relative to the page. */
  file: string;
  type: string;
  sha256: string;
  seconds: number;
  width: number;
  height: number;
  /** Whether it is heard; otherwise it is played muted. */
  sound?: boolean;
  /** Tokens of the figures of people who can be turned. */
  figures?: string[];
}

/** How levels of adaptive trials are chosen (pipeline/study/thresholds/track_json.h). Levels are places of a grid. */
export interface Adaptive {
  method: "quest" | "staircase";
  /** As they are written, from the hardest to the easiest. */
  levels: string[];
  /** Numbers that increase with ease. */
  ease: number[];
  quest?: QuestGrid;
  /** Of QUEST+; otherwise tracks show all trials of the plan. */
  end?: QuestEnd;
  staircase?: StaircaseRule;
}

/**
 * When a track of QUEST+ ends: once the standard deviation of the threshold, the level with this proportion of positive
 * answers, is at most `deviation`, or after so many trials.
 */
export interface QuestEnd {
  deviation: number;
  proportion: number;
  most_trials: number;
}

/** The values of the parameters of psychometric functions. */
export interface QuestGrid {
  location: number[];
  width: number[];
  guess: number[];
  lapse: number[];
}

export interface StaircaseRule {
  start: number;
  positive_to_fall: number;
  negative_to_rise: number;
  step_down: number;
  step_up: number;
  /** 0: without limit. */
  most_reversals: number;
  most_trials: number;
}

/** The answer to a trial of a track: the place of its level, and whether it was right, "yes" or "different". */
export interface LevelAnswer {
  place: number;
  positive: boolean;
}

export interface Session {
  participant: string;
  /** Digits: more of them than a number of JavaScript holds. */
  seed: string | number;
  /** Ids of what trials offer, as they stand there. */
  choices?: string[];
  trials: Trial[];
}

export interface Trial {
  number: number;
  block: string;
  /** Of trialKinds (trials/trial_kinds.ts). */
  kind: string;
  media: string[];
  reference: string;
  items: { item: string; flipped: boolean }[];
  practice: boolean;
  warm_up: boolean;
  /** An attention check, or a stimulus that is shown a second time. */
  check: boolean;
  expected?: string;
  /** Of adaptive trials: the level; of a track, once it is known. */
  level?: string;
  /** Of a track: what is shown at each level, the raw answer that is positive, and, once it is known, the place. */
  track?: number;
  by_level?: string[][];
  positive?: string;
  place?: number;
}

export interface Response {
  item: string;
  value_raw: number | string;
  /** Nothing where a marker was not moved. */
  rt_ms: number | null;
}

/** What stores must know of a study: a questionnaire, or an experiment with live motions. */
export interface Planned<Own extends { participant: string } = Session> {
  design: string;
  sessions: Own[];
  kept?: string[];
  browser?: string;
  ended?: SessionEnd;
  joining?: boolean;
  enough?: boolean;
  destination?: Destination;
  recruitment?: Recruitment;
}

/** A stimulus was not loaded, or cannot be decoded, or stopped again and again. */
export type PlayFault = "not_loaded" | "not_decoded" | "stalled";

/** What is kept of a page: of the consent, the screening, the demographics, a trial or the ending. */
export interface PageRecord {
  record: string;
  session: string;
  responses: Response[];
  comment: string;
  started_at: string;
  replays?: number;
  /** How often the page of the trial was opened: more than once where it was reloaded. */
  attempt?: number;
  /** Playings that were begun before the last reload, and the length of the longest. */
  plays_before?: number;
  watched_before_ms?: number;
  /** Why the stimulus could not be played, so that the trial was left out. */
  play_fault?: PlayFault | "";
  trial_ms?: number;
  play_start_ms?: number | null;
  ended_ms?: number | null;
  stalls?: number;
  stall_ms?: number;
  dropped_frames?: number | null;
  /** Changes of the volume of what is heard: "milliseconds:volume …". */
  volume_events?: string;
  blurs?: number;
  blur_ms?: number;
  viewport_width?: number;
  viewport_height?: number;
  refresh_hz?: number | null;
  shown_width?: number | null;
  shown_height?: number | null;
  pixel_ratio?: number | null;
  shown_cm?: number | null;
  shown_degrees?: number | null;
  viewing_cm?: number | null;
  media_sha256?: string[];
  /** Of a trial of a track: the place of the level. */
  level?: number;
  /** The track had ended, and nothing was shown. */
  track_ended?: true;
  /** Of consent: the language of the page. */
  language?: string;
  /** Of consent: the text that was shown. */
  consent?: ConsentText;
  /** Of consent: parameters of the participant's link. */
  url_parameters?: Record<string, string>;
  /** Of consent, on JATOS: the ids by which it knows the participant. */
  jatos?: Record<string, string>;
  /** Of a trial of a matching experiment. */
  matching?: MatchingRecord;
  /** Of a step of a chain. */
  chain?: ChainRecord;
}

/** Throws with words for whoever runs the study. */
export function checked(experiment: unknown): Experiment {
  const given = experiment as Partial<Experiment> | null | undefined;
  if (given?.format !== "mien-questionnaire-1" || !given.sessions?.length)
    throw new Error("This page cannot read the questionnaire; export it again.");
  return given as Experiment;
}

/** The records of a session in their order. */
export function recordsOf(experiment: Experiment, session: Session): string[] {
  return [
    "consent",
    ...(experiment.screening ? ["screening"] : []),
    ...(experiment.demographics.length ? ["demographics"] : []),
    ...session.trials.map((trial) => `trial-${trial.number}`),
    "ending",
  ];
}
