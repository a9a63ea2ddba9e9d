import type { LiveCore } from "../live/core";
import { open_served } from "../live/served_core";
import { open_wasm } from "../live/wasm_core";
import { element, button, heading } from "../questionnaire/elements";
import type { PageRecord } from "../questionnaire/experiment";
import { save_once, type SavedFile } from "../questionnaire/files";
import { is_touched } from "../questionnaire/measures";
import { run_script } from "../questionnaire/media";
import { participants_csv } from "../questionnaire/rows";
import { experiment_of, expect_own, may_begin, show_ending } from "../questionnaire/session_page";
import { Drawer, type Store } from "../questionnaire/store";
import { base, mode_of_page, root, show, show_closed, store_of, type Mode } from "../questionnaire/surroundings";
import { page_record, show_text_page, wait_note, type AskedPage, type GivenOnPage } from "../questionnaire/text_view";
import type { Texts } from "../questionnaire/texts";
import { checked_matching, type MatchingExperiment, type MatchingSession, type MatchingTrial } from "./experiment";
import type { Guess } from "./record";
import { changes_csv, trials_csv } from "./rows";
import { matching_texts, shared_texts } from "./texts";
import { run_guess, run_trial, type MatchingSurroundings } from "./trial_page";

/** Behind the server, or in this browser from a script that brings the module. */
async function core_of(mode: Mode): Promise<LiveCore> {
  if (mode === "served") return open_served(`${base()}live/`);
  await run_script("live_core.js");
  const files = (globalThis as { mien_live_files?: { module: string; bundle: string } }).mien_live_files;
  if (!files) throw new Error("live_core.js brings no motion core.");
  return open_wasm(files.module, files.bundle);
}

const names_of = (experiment: MatchingExperiment, session: MatchingSession): string[] => [
  "consent",
  ...(experiment.demographics.length ? ["demographics"] : []),
  ...session.trials.map(({ number }) => `trial-${number}`),
  "ending",
];

/**
 * How often a trial, or its guess where that is made by itself, was begun in this browser, this time
 * counted: more than once after a reload.
 */
function attempt_at(
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
function of_one_target(trials: MatchingTrial[]): MatchingTrial[][] {
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
    private texts: Texts,
  ) {
    this.words = matching_texts(experiment.language);
  }

  async run(): Promise<void> {
    if (!this.has("consent")) await this.consent();
    if (this.experiment.joining) return;
    await this.explain();
    if (this.experiment.demographics.length && !this.has("demographics"))
      await this.keeping("demographics",
        { title: this.texts.about_you, questions: this.experiment.demographics, buttons: [this.texts.next] });
    await this.trials(await this.prepared());
    if (!this.has("ending"))
      await this.keeping("ending",
        { title: this.texts.almost, comment: this.texts.last_words, buttons: [this.texts.finish] });
    await this.store.finish();
  }

  private has = (name: string): boolean => this.store.kept.has(name);

  private page(asked: Omit<AskedPage, "words">): Promise<number> {
    return show_text_page(root(), { ...asked, words: this.texts });
  }

  private async keep(record: PageRecord, page: HTMLElement): Promise<void> {
    try {
      await this.store.keep(record, wait_note(page, this.texts));
    } catch (error) {
      show_closed(error, this.texts);
      await new Promise(() => {});  // nothing follows
    }
  }

  private keeping(name: string, asked: Omit<AskedPage, "words" | "keep">): Promise<number> {
    return this.page({ ...asked,
      keep: (given, page) => this.keep(page_record(name, this.store.name, given), page) });
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
        if (agreed || mode !== "static")
          await this.keep(page_record("consent", this.store.name, { ...given, responses }), page);
        if (agreed) return;
        if (mode === "static") this.store.clear?.();
        show(texts.thanks, [texts.refused]);
        await new Promise(() => {});  // nothing follows
      },
    });
  }

  private async explain(): Promise<void> {
    const { experiment, texts, words } = this;
    const is_resumed = this.store.session.trials.some(({ number }) => this.has(`trial-${number}`));
    await this.page({
      title: texts.instructions, buttons: [texts.next],
      texts: [...(is_resumed ? [texts.resumed] : []), ...experiment.texts.instructions,
        ...(experiment.matching.order === "guesses-first" ? words.how_guesses_first : words.how),
        ...(experiment.matching.shows_distance ? [] : [words.how_hidden]), ...(is_touched() ? [] : [words.keys])],
    });
  }

  private async prepared(): Promise<MatchingSurroundings> {
    const { experiment, texts, words, store } = this;
    const note = element("p", { role: "status" });
    const bar = element("progress", { "aria-label": words.preparing });
    root().replaceChildren(element("article", { class: "page" }, heading(words.preparing), bar, note));
    for (;;) {
      try {
        return { experiment, core: await core_of(this.mode), name: store.name, texts, words,
          seeing: { arrangement: "over", step: "keytimes" } };
      } catch (error) {
        console.error(error);
        note.textContent = `${words.not_prepared} ${error instanceof Error ? error.message : ""}`;
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
    if (this.experiment.matching.order === "guesses-first") return this.guesses_first(around);
    let before: MatchingTrial | undefined;
    for (const trial of session.trials) {
      if (this.has(`trial-${trial.number}`)) continue;
      await this.before_trial(trial, before);
      const alike = session.trials.filter(({ practice }) => practice === trial.practice);
      const place = alike.indexOf(trial) + 1;
      const title = trial.practice ? this.words.practice_of(place, alike.length)
        : this.words.motion_of(place, alike.length);
      const record = await run_trial(root(), trial, title, attempt_at(this.experiment, this.store, trial), around);
      await this.keep(record, root());
      before = trial;
    }
  }

  /** At each target a guess with every interface, then a match with every interface. */
  private async guesses_first(around: MatchingSurroundings): Promise<void> {
    const { experiment, store, words } = this;
    const guesses = new KeptGuesses(experiment, store);
    const groups = of_one_target(store.session.trials);
    for (const group of groups) {
      const { practice } = group[0]!;
      const alike = groups.filter((one) => one[0]!.practice === practice);
      const place = alike.indexOf(group) + 1;
      const title = practice ? words.practice_of(place, alike.length) : words.motion_of(place, alike.length);
      const left = group.filter(({ number }) => !this.has(`trial-${number}`));
      for (const trial of left) {
        if (guesses.of(trial)) continue;
        const said = trial === group[0] ? this.before_motion(practice, place, alike.length) : [];
        await this.before_step(title, trial, [...said, words.guess_with(words.interfaces[trial.interface])]);
        guesses.keep(trial,
          await run_guess(root(), trial, title, attempt_at(experiment, store, trial, "guess-"), around));
      }
      for (const trial of left) {
        const guess = guesses.of(trial)!;
        await this.before_step(title, trial, [words.match_with(words.interfaces[trial.interface])]);
        const attempt = guess.attempt - 1 + attempt_at(experiment, store, trial);
        await this.keep(await run_trial(root(), trial, title, attempt, around, guess), root());
      }
    }
  }

  /** What is said where another motion begins. */
  private before_motion(practice: boolean, place: number, all: number): string[] {
    const { texts, words, store } = this;
    if (practice) return place === 1 ? [texts.practice_begins] : [];
    if (place > 1) return [words.rest_text(place - 1, all)];
    return store.session.trials.some((trial) => trial.practice) ? [texts.main_begins] : [];
  }

  private async before_step(title: string, trial: MatchingTrial, said: string[]): Promise<void> {
    await this.page({ title, texts: [...said, this.words.explains[trial.interface]], buttons: [this.texts.next] });
  }

  /** A rest, and what comes where the interface changes. */
  private async before_trial(trial: MatchingTrial, before: MatchingTrial | undefined): Promise<void> {
    const { texts, words } = this;
    const main = this.store.session.trials.filter(({ practice }) => !practice);
    const done = main.indexOf(trial);
    const title = trial.practice ? texts.practice : before && !before.practice ? words.rest : this.experiment.title;
    const said: string[] = [];
    if (trial.practice && !before) said.push(texts.practice_begins);
    if (!trial.practice && before?.practice) said.push(texts.main_begins);
    if (done > 0) said.push(words.rest_text(done, main.length));
    if (!before || before.interface !== trial.interface || before.practice !== trial.practice)
      said.push(words.next_are(words.interfaces[trial.interface]), words.explains[trial.interface]);
    await this.page({ title, texts: said, buttons: [texts.next] });
  }
}

/** Saves what was recorded. */
function saved_files(experiment: MatchingExperiment, store: Store<MatchingSession>): SavedFile[] {
  const { session, records, name } = store;
  const begin = `subject-${session.participant}_session-${name.slice(0, 8)}`;
  const everything = { format: "mien-matching-session-1", study: experiment.study, design: experiment.design,
    participant: session.participant, session: name, seed: session.seed, trials: session.trials, records };
  const csv_of = (what: string, text: string) =>
    ({ name: `${begin}_description-${what}_data.csv`, type: "text/csv", text });
  return save_once([
    csv_of("trials", trials_csv(experiment, session, records)),
    csv_of("changes", changes_csv(experiment, session, records)),
    csv_of("participant", participants_csv(experiment, session, records)),
    { name: `${begin}_records.json`, type: "application/json", text: JSON.stringify(everything, null, 1) },
  ], store);
}

async function main(): Promise<void> {
  const mode = mode_of_page();
  const experiment = await experiment_of(mode, checked_matching);
  const texts = shared_texts(experiment.language);
  if (!may_begin(experiment, texts)) return;
  const store = await store_of(mode, experiment, texts, {
    results: (session, records) => trials_csv(experiment, session, records),
    files: (session, records) => ({
      "changes.csv": changes_csv(experiment, session, records),
      "participants.csv": participants_csv(experiment, session, records),
    }),
  });
  if (!names_of(experiment, store.session).every((name) => store.kept.has(name))) {
    expect_own(experiment, store);
    await new Session(mode, experiment, store, texts).run();
  }
  show_ending(mode, experiment, store, texts, () => saved_files(experiment, store));
}


main().catch((error: unknown) => show_closed(error, shared_texts(document.documentElement.lang)));
