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
