import type { LiveCore } from "../live/core";
import { openServed } from "../live/served_core";
import { openWasm } from "../live/wasm_core";
import { element, button, heading } from "../questionnaire/elements";
import type { PageRecord } from "../questionnaire/experiment";
import type { EarlyEnds } from "../questionnaire/early_ends";
import { isForExperimenter, showExperimenterPage } from "../questionnaire/experimenter_page";
import { saveOnce, type TextFile } from "../questionnaire/files";
import { isTouched } from "../questionnaire/measures";
import { runScript } from "../questionnaire/media";
import { participantsCsv } from "../questionnaire/rows";
import { endWithdrawalOffer } from "../questionnaire/withdrawal";
import { experimentOf, expectOwn, mayBegin, mayWithdraw, showEnding, showFormerEnd } from "../questionnaire/session_page";
import { Drawer, namedSession, type Store } from "../questionnaire/store";
import { base, earlyEndsOfLink, linkParameters, modeOfPage, root, show, showClosed, storeOf, type Mode } from "../questionnaire/surroundings";
import { pageRecord, showTextPage, waitNote, type AskedPage, type GivenOnPage } from "../questionnaire/text_view";
import type { Texts } from "../questionnaire/texts";
import { checkedMatching, type MatchingExperiment, type MatchingSession, type MatchingTrial } from "./experiment";
import type { Guess } from "./record";
import { changesCsv, trialsCsv } from "./rows";
import { matchingTexts, sharedTexts } from "./texts";
import { runGuess, runTrial, type MatchingSurroundings } from "./trial_page";

/** Behind the server, or in this browser from a script that brings the module. */
async function coreOf(mode: Mode): Promise<LiveCore> {
  if (mode === "served") return openServed(`${base()}live/`);
  await runScript("live_core.js");
  const files = (globalThis as { mien_live_files?: { module: string; bundle: string } }).mien_live_files;
  if (!files) throw new Error("live_core.js contains no motion core.");
  return openWasm(files.module, files.bundle);
}

const namesOf = (experiment: MatchingExperiment, session: MatchingSession): string[] => [
  "consent",
  ...(experiment.demographics.length ? ["demographics"] : []),
  ...session.trials.map(({ number }) => `trial-${number}`),
  "ending",
];

/**
 * How often a trial, or its guess where that is made by itself, was begun in this browser, this time
 * counted: more than once after a reload.
 */
function attemptAt(
  experiment: MatchingExperiment, store: Store<MatchingSession>, trial: MatchingTrial, part: "" | "guess-" = ""): number {
  const drawer = new Drawer(`mien/${experiment.design}/${store.name}/begun`);
  const begun = drawer.read<Record<string, number>>() ?? {};
  const attempt = (begun[part + trial.number] ?? 0) + 1;
  drawer.write({ ...begun, [part + trial.number]: attempt });
  return attempt;
}

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
class Session {
  private words;
  constructor(
    private mode: Mode, private experiment: MatchingExperiment, private store: Store<MatchingSession>,
    private texts: Texts, private ends: EarlyEnds | undefined,
  ) {
    this.words = matchingTexts(experiment.language, experiment.page_texts?.[experiment.language]);
  }

  async run(): Promise<void> {
    if (!this.has("consent")) await this.consent();
    if (this.experiment.joining) return;
    await this.explain();
    if (this.experiment.demographics.length && !this.has("demographics"))
      await this.keeping("demographics",
        { title: this.texts.aboutYou, questions: this.experiment.demographics, buttons: [this.texts.next] });
    await this.trials(await this.prepared());
    if (!this.has("ending"))
      await this.keeping("ending",
        { title: this.texts.almost, comment: this.texts.lastWords, buttons: [this.texts.finish] });
    await this.store.finish();
  }

  private has = (name: string): boolean => this.store.kept.has(name);

  private page(asked: Omit<AskedPage, "words">): Promise<number> {
    return showTextPage(root(), { ...asked, words: this.texts });
  }

  private async keep(record: PageRecord, page: HTMLElement): Promise<void> {
    try {
      await this.store.keep(record, waitNote(page, this.texts));
    } catch (error) {
      showClosed(error, this.texts);
      await new Promise(() => {});  // nothing follows
    }
  }

  private keeping(name: string, asked: Omit<AskedPage, "words" | "keep">): Promise<number> {
    return this.page({ ...asked,
      keep: (given, page) => this.keep(pageRecord(name, this.store.name, given), page) });
  }

  private async consent(): Promise<void> {
    const { experiment, texts, mode } = this;
    const { consent } = experiment.texts;
    await this.page({
      title: experiment.title || texts.welcome, texts: consent,
      buttons: consent.length ? [texts.agree, texts.refuse] : [texts.next],
      keep: async (given: GivenOnPage, page) => {
        const agreed = given.pressed === 0;
        const responses = [{ item: "consent", value_raw: agreed ? "agreed" : "refused", rt_ms: 0 }];
        if (agreed || mode === "served")
          await this.keep({ ...pageRecord("consent", this.store.name, { ...given, responses }),
            language: experiment.language }, page);
        if (agreed) return mayWithdraw(experiment, this.store, texts, {}, this.ends);
        if (mode === "served") this.store.clear?.();
        show(texts.thanks, [texts.refused]);
        await new Promise(() => {});  // nothing follows
      },
    });
  }

  private async explain(): Promise<void> {
    const { experiment, texts, words } = this;
    const isResumed = this.store.session.trials.some(({ number }) => this.has(`trial-${number}`));
    await this.page({
      title: texts.instructions, buttons: [texts.next],
      texts: [...(isResumed ? [texts.resumed] : []), ...experiment.texts.instructions,
        ...(experiment.matching.order === "guesses-first" ? words.howGuessesFirst : words.how),
        ...(experiment.matching.shows_distance ? [] : [words.howHidden]), ...(isTouched() ? [] : [words.keys])],
    });
  }

  private async prepared(): Promise<MatchingSurroundings> {
    const { experiment, texts, words, store } = this;
    const note = element("p", { role: "status" });
    const bar = element("progress", { "aria-label": words.preparing });
    root().replaceChildren(element("article", { class: "page" }, heading(words.preparing), bar, note));
    for (;;) {
      try {
        return { experiment, core: await coreOf(this.mode), name: store.name, texts, words,
          seeing: { arrangement: "over", step: "keytimes" } };
      } catch (error) {
        console.error(error);
        note.textContent = `${words.notPrepared} ${error instanceof Error ? error.message : ""}`;
        await new Promise<void>((again) => {
          const more = button(texts.again, () => { more.remove(); again(); }, "main");
          note.after(more);
          more.focus();
        });
      }
    }
  }

  private async trials(around: MatchingSurroundings): Promise<void> {
    const { session } = this.store;
    if (this.experiment.matching.order === "guesses-first") return this.guessesFirst(around);
    let before: MatchingTrial | undefined;
    for (const trial of session.trials) {
      if (this.has(`trial-${trial.number}`)) continue;
      await this.beforeTrial(trial, before);
      const alike = session.trials.filter(({ practice }) => practice === trial.practice);
      const place = alike.indexOf(trial) + 1;
      const title = trial.practice ? this.words.practiceOf({ number: place, all: alike.length })
        : this.words.motionOf({ number: place, all: alike.length });
      const record = await runTrial(root(), trial, title, attemptAt(this.experiment, this.store, trial), around);
      await this.keep(record, root());
      before = trial;
    }
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
          await runGuess(root(), trial, title, attemptAt(experiment, store, trial, "guess-"), around));
      }
      for (const trial of left) {
        const guess = guesses.of(trial)!;
        await this.beforeStep(title, trial, [words.matchWith({ name: words.interfaces[trial.interface] })]);
        const attempt = guess.attempt - 1 + attemptAt(experiment, store, trial);
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

/** The files of a session. */
function filesOf(
  experiment: MatchingExperiment,
  { session, records, name }: Pick<Store<MatchingSession>, "session" | "records" | "name">): TextFile[] {
  const begin = `subject-${session.participant}_session-${name.slice(0, 8)}`;
  const everything = { format: "mien-matching-session-1", study: experiment.study, design: experiment.design,
    participant: session.participant, session: name, seed: session.seed, trials: session.trials, records };
  const csvOf = (what: string, text: string) =>
    ({ name: `${begin}_description-${what}_data.csv`, type: "text/csv", text });
  return [
    csvOf("trials", trialsCsv(experiment, session, records)),
    csvOf("changes", changesCsv(experiment, session, records)),
    csvOf("participant", participantsCsv(experiment, session, records)),
    { name: `${begin}_records.json`, type: "application/json", text: JSON.stringify(everything, null, 1) },
  ];
}

async function main(): Promise<void> {
  const mode = modeOfPage();
  const experiment = await experimentOf(mode, checkedMatching);
  const texts = sharedTexts(experiment.language, experiment.page_texts?.[experiment.language]);
  const link = await linkParameters(mode);
  if (mode === "static" && isForExperimenter(link))
    return showExperimenterPage(experiment, (kept) => filesOf(experiment,
      { ...kept, session: namedSession(experiment.sessions, kept.participant) }));
  if (!mayBegin(experiment, texts)) return;
  const ends = earlyEndsOfLink(mode, experiment, link);
  if (showFormerEnd(experiment, texts, {}, ends)) return;
  const store = await storeOf(mode, experiment, texts, {
    results: (session, records) => trialsCsv(experiment, session, records),
    files: (session, records) => ({
      "changes.csv": changesCsv(experiment, session, records),
      "participants.csv": participantsCsv(experiment, session, records),
    }),
  });
  const isOwn = !experiment.browser || experiment.browser === store.name;
  if (isOwn && store.kept.has("consent")) mayWithdraw(experiment, store, texts, {}, ends);
  if (!namesOf(experiment, store.session).every((name) => store.kept.has(name))) {
    expectOwn(experiment, store);
    await new Session(mode, experiment, store, texts, ends).run();
  }
  if (mode === "static") endWithdrawalOffer();
  showEnding(mode, experiment, store, texts, () => saveOnce(filesOf(experiment, store), store));
}


main().catch((error: unknown) => showClosed(error, sharedTexts(document.documentElement.lang)));
