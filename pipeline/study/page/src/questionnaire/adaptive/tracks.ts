// Adaptive trials: the level of each follows from the answers to the earlier trials of its track.

import type { Adaptive, Experiment, LevelAnswer, PageRecord, Session, Trial } from "../experiment";
import { Quest } from "./quest";
import { staircaseAfter } from "./staircase";

/** A trial of a track as it is shown at a level. */
function shownAt(trial: Trial, place: number, { levels }: Adaptive): Trial {
  return { ...trial, media: trial.by_level![place]!, level: levels[place]!, place };
}

/** A trial as its record says that it was shown. */
export function shownIn(trial: Trial, record: PageRecord, { adaptive }: Experiment): Trial {
  return adaptive && trial.by_level && record.level !== undefined ? shownAt(trial, record.level, adaptive) : trial;
}

/** All that a trial may show. */
export const mediaOf = (trial: Trial): string[] => trial.by_level?.flat() ?? trial.media;

/** What the record of a trial says of its track; nothing where it has no answer. */
function answerIn(trial: Trial, record: PageRecord): LevelAnswer | undefined {
  const [response] = record.responses;
  if (record.level === undefined || !response || record.play_fault) return undefined;
  return { place: record.level, positive: String(response.value_raw) === trial.positive };
}

/** The tracks of a session. */
export class Tracks {
  private quest: Quest | undefined;
  /** By the numbers of their trials. */
  private answers = new Map<number, LevelAnswer>();

  /** `records` are those kept so far, as far as the page has them, `answered` what a server tells of others. */
  constructor(
    private adaptive: Adaptive, private session: Session, records: Record<string, PageRecord>,
    answered: Record<string, LevelAnswer> = {}) {
    if (adaptive.quest) this.quest = new Quest(adaptive.ease, adaptive.quest, adaptive.end);
    for (const trial of session.trials) {
      const told = answered[`trial-${trial.number}`];
      if (told) this.answers.set(trial.number, told);
    }
    Object.values(records).forEach((record) => this.note(record));
  }

  /** Takes the answer of a record that has been kept. */
  note(record: PageRecord): void {
    const trial = this.session.trials.find(({ number }) => record.record === `trial-${number}`);
    const answer = trial?.by_level && answerIn(trial, record);
    if (answer) this.answers.set(trial!.number, answer);
  }

  /** The trial as it is to be shown; nothing if its track has ended. */
  next(trial: Trial): Trial | undefined {
    if (!trial.by_level) return trial;
    const place = this.placeOf(trial);
    return place === undefined ? undefined : shownAt(trial, place, this.adaptive);
  }

  private placeOf(trial: Trial): number | undefined {
    const earlier = this.session.trials.filter(({ track, number }) => track === trial.track && number < trial.number)
      .flatMap(({ number }) => this.answers.get(number) ?? []);
    if (this.quest) return this.quest.hasEnded(earlier) ? undefined : this.quest.placeAfter(earlier);
    const { place, ended } = staircaseAfter(this.adaptive.staircase!, this.adaptive.levels.length, earlier);
    return ended ? undefined : place;
  }
}
