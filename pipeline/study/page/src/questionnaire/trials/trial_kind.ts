import type { Answered, Asked } from "../answers";
import type { Experiment, Response, Trial } from "../experiment";
import type { Texts } from "../texts";

/** The films of a grid by their places from 0; the open reference comes after them. */
export interface GridFilms {
  /** The place of the reference; −1 if there is none. */
  reference(): number;
  isReady(place: number): boolean;
  isSeen(place: number): boolean;
  isPlaying(place: number): boolean;
  /** From the beginning; another one that is playing stops. */
  playFilm(place: number): void;
  /** Called when any of this changes. */
  onChange(listener: () => void): void;
}

/** A film that is rated while it plays. */
export interface TraceFilm {
  isPlaying(): boolean;
  hasEnded(): boolean;
  /** The film's own time, in seconds. */
  time(): number;
  /** Called before it begins to play. */
  onBegin(listener: () => void): void;
}

/** What a page knows when it asks a trial. */
export interface Asking {
  trial: Trial;
  /** Ids of what is offered, as it stands there. */
  choices: string[];
  experiment: Experiment;
  texts: Texts;
  answered: Answered;
  /** Of a grid, what plays its films. */
  grid?: GridFilms;
  /** Of a continuous rating, what is rated. */
  film?: TraceFilm;
}

/** What a raw answer means, as the table of answers has it. */
export interface Meaning {
  value: string;
  pole_left: "" | "low" | "high";
  /** What the answer is about, and the item, where these are not those of the trial and the response. */
  stimulus?: string;
  against?: string;
  item?: string;
  /** Which of the trial's films that is. */
  shown?: number;
}

/** How the trials of one kind are asked and understood (pipeline/study/trials/trial_kind.h). */
export interface TrialKind {
  /** An attention check, which stands in for trials of another kind. */
  isCheck?: true;
  /** All that a trial asks, in its order. */
  ask(asking: Asking): Asked[];
  /** What stands above it where the study has no question of its own. */
  question(trial: Trial, experiment: Experiment, texts: Texts): string;
  /** What has to be done yet, in words; otherwise it is counted. */
  missingText?(missing: Asked[], texts: Texts, stage: { isPlaying?(place: number): boolean } | null): string;
  /** `raw` is the response's raw answer as tables have it; `stimulus` tells what a token stands for. */
  meaning(trial: Trial, response: Response, raw: string, experiment: Experiment,
    stimulus: (token: string | undefined) => string): Meaning;
}

/** What a kind of trial has besides, so that checks can look like it. */
export interface CheckedKind extends TrialKind {
  /** The one item of a check. */
  askCheck(asking: Asking): Asked;
  /** What a check asks for. */
  checkText(trial: Trial, experiment: Experiment, texts: Texts): string;
}
