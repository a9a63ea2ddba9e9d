import type { LiveCore } from "../live/core";
import { attemptAt } from "../live_study/begun";
import { placeOf } from "../live_study/experiment";
import { LiveSession } from "../live_study/live_session";
import { runLiveStudy } from "../live_study/live_study";
import { Drawer, type Store } from "../questionnaire/store";
import { root } from "../questionnaire/surroundings";
import { checkedMatching, type MatchingExperiment, type MatchingSession, type MatchingTrial } from "./experiment";
import type { Guess } from "./record";
import { changesCsv, trialsCsv } from "./rows";
import { runGuess, runTrial, type MatchingSurroundings } from "./trial_page";

/** Guesses that were made before anything was seen, by the number of the trial; they outlive a reload. */
class KeptGuesses {
  private drawer: Drawer;

  constructor(experiment: MatchingExperiment, store: Store<MatchingSession>) {
    this.drawer = new Drawer(`mien/${experiment.design}/${store.name}/guesses`);
  }

  of(trial: MatchingTrial): Guess | undefined {
    return this.drawer.read<Record<string, Guess>>()?.[trial.number];
  }

  keep(trial: MatchingTrial, guess: Guess): void {
    this.drawer.write({ ...(this.drawer.read<Record<string, Guess>>() ?? {}), [trial.number]: guess });
  }
}

/** Trials one after the other that are of one target. */
function ofOneTarget(trials: MatchingTrial[]): MatchingTrial[][] {
  const groups: MatchingTrial[][] = [];
  for (const trial of trials) {
    const last = groups[groups.length - 1]?.[0];
    if (last && last.target === trial.target && last.practice === trial.practice) groups[groups.length - 1]!.push(trial);
    else groups.push([trial]);
  }
  return groups;
}

/** The pages of a session, one after the other. */
class Session extends LiveSession<MatchingSession, MatchingExperiment> {
  protected howTo(): string[] {
    const { words } = this;
    const { order, shows_distance: showsDistance } = this.experiment.matching;
    return [...(order === "guesses-first" ? words.howGuessesFirst : words.how), ...(showsDistance ? [] : [words.howHidden])];
  }

  protected async trials(core: LiveCore): Promise<string[]> {
    const { experiment, store, texts, words } = this;
    const around: MatchingSurroundings = { experiment, core, name: store.name, texts, words,
      seeing: { arrangement: "over", step: "keytimes" } };
    if (experiment.matching.order === "guesses-first") await this.guessesFirst(around);
    else await this.trialByTrial(around);
    return [];
  }

  private async trialByTrial(around: MatchingSurroundings): Promise<void> {
    const { session } = this.store;
    let before: MatchingTrial | undefined;
    for (const trial of session.trials) {
      if (this.has(`trial-${trial.number}`)) continue;
      await this.beforeTrial(trial, before);
      const place = placeOf(session, trial);
      const title = trial.practice ? this.words.practiceOf(place) : this.words.motionOf(place);
      const record = await runTrial(root(), trial, title, this.attempt(trial), around);
      await this.keep(record, root());
      before = trial;
    }
  }

  /** How often a trial, or its guess where that is made by itself, was begun. */
  private attempt({ number }: MatchingTrial, part: "" | "guess-" = ""): number {
    return attemptAt(this.experiment, this.store.name, part + number);
  }

  /** At each target a guess with every interface, then a match with every interface. */
  private async guessesFirst(around: MatchingSurroundings): Promise<void> {
    const { experiment, store, words } = this;
    const guesses = new KeptGuesses(experiment, store);
    const groups = ofOneTarget(store.session.trials);
    for (const group of groups) {
      const { practice } = group[0]!;
      const alike = groups.filter((one) => one[0]!.practice === practice);
      const place = alike.indexOf(group) + 1;
      const title = practice ? words.practiceOf({ number: place, all: alike.length }) : words.motionOf({ number: place, all: alike.length });
      const left = group.filter(({ number }) => !this.has(`trial-${number}`));
      for (const trial of left) {
        if (guesses.of(trial)) continue;
        const said = trial === group[0] ? this.beforeMotion(practice, place, alike.length) : [];
        await this.beforeStep(title, trial, [...said, words.guessWith({ name: words.interfaces[trial.interface] })]);
        guesses.keep(trial,
          await runGuess(root(), trial, title, this.attempt(trial, "guess-"), around));
      }
      for (const trial of left) {
        const guess = guesses.of(trial)!;
        await this.beforeStep(title, trial, [words.matchWith({ name: words.interfaces[trial.interface] })]);
        const attempt = guess.attempt - 1 + this.attempt(trial);
        await this.keep(await runTrial(root(), trial, title, attempt, around, guess), root());
      }
    }
  }

  /** What is said where another motion begins. */
  private beforeMotion(practice: boolean, place: number, all: number): string[] {
    const { texts, words, store } = this;
    if (practice) return place === 1 ? [texts.practiceBegins] : [];
    if (place > 1) return [words.restText({ done: place - 1, all })];
    return store.session.trials.some((trial) => trial.practice) ? [texts.mainBegins] : [];
  }

  private async beforeStep(title: string, trial: MatchingTrial, said: string[]): Promise<void> {
    await this.page({ title, texts: [...said, this.words.explains[trial.interface]], buttons: [this.texts.next] });
  }

  /** A rest, and what comes where the interface changes. */
  private async beforeTrial(trial: MatchingTrial, before: MatchingTrial | undefined): Promise<void> {
    const { texts, words } = this;
    const main = this.store.session.trials.filter(({ practice }) => !practice);
    const done = main.indexOf(trial);
    const title = trial.practice ? texts.practice : before && !before.practice ? words.rest : this.experiment.title;
    const said: string[] = [];
    if (trial.practice && !before) said.push(texts.practiceBegins);
    if (!trial.practice && before?.practice) said.push(texts.mainBegins);
    if (done > 0) said.push(words.restText({ done, all: main.length }));
    if (!before || before.interface !== trial.interface || before.practice !== trial.practice)
      said.push(words.nextAre({ name: words.interfaces[trial.interface] }), words.explains[trial.interface]);
    await this.page({ title, texts: said, buttons: [texts.next] });
  }
}

runLiveStudy<MatchingSession, MatchingExperiment>({
  format: "mien-matching-session-1",
  checked: checkedMatching,
  tables: (experiment, session, records) => ({
    trials: trialsCsv(experiment, session, records),
    changes: changesCsv(experiment, session, records),
  }),
  session: (parts) => new Session(parts),
});
