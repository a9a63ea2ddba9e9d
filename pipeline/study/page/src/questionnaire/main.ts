import { initJsPsych } from "jspsych";
import { checked, records_of, type Experiment, type PageRecord } from "./experiment";
import { save_files } from "./files";
import { LoadPage } from "./load_page";
import { is_touched, refresh_rate } from "./measures";
import { fill, type Stock } from "./media";
import { answers_csv, participants_csv } from "./rows";
import { load_turn_view } from "./screen";
import { experiment_of, expect_own, may_begin, show_ending } from "./session_page";
import type { Store } from "./store";
import { mode_of_page, root, show, show_closed, store_of, type Mode } from "./surroundings";
import { TextPage } from "./text_page";
import { page_record, wait_note, type GivenOnPage } from "./text_view";
import { texts_of, type Texts } from "./texts";
import { TrialPage, type TrialSurroundings } from "./trial_page";

/** The timeline: what is kept already is left out. */
function timeline_of(mode: Mode, experiment: Experiment, store: Store, texts: Texts) {
  const { session } = store;
  const stock: Stock = new Map();
  const keep = async (record: PageRecord, page: HTMLElement) => {
    try {
      await store.keep(record, wait_note(page, texts));
    } catch (error) {
      show_closed(error, texts);
      await new Promise(() => {});  // nothing follows
    }
  };
  const kept = (name: string) => store.kept.has(name);
  const around: TrialSurroundings = { experiment, session, texts, stock, name: store.name,
    refresh_hz: null, keep };
  const text_page = (name: string, more: object) => ({
    type: TextPage, words: texts, buttons: [texts.next],
    keep: name ? async (given: GivenOnPage, page: HTMLElement) => {
      await keep(page_record(name, store.name, given), page);
    } : null,
    ...more,
  });
  const timeline: object[] = [];
  const { consent, instructions } = experiment.texts;

  if (!kept("consent")) {
    timeline.push({
      ...text_page("consent", { title: experiment.title || texts.welcome, texts: consent,
        buttons: consent.length ? [texts.agree, texts.refuse] : [texts.next],
        keep: async (given: GivenOnPage, page: HTMLElement) => {
          const agreed = given.pressed === 0;
          const responses = [{ item: "consent", value_raw: agreed ? "agreed" : "refused", rt_ms: 0 }];
          if (agreed || mode !== "static")
            await keep(page_record("consent", store.name, { ...given, responses }), page);
          if (agreed) return;
          if (mode === "static") store.clear?.();
          show(texts.thanks, [texts.refused]);
          await new Promise(() => {});  // nothing follows
        } }),
    });
  }
  if (experiment.joining) return timeline;
  const keys = [...(is_touched() ? [] : [texts.keys]),
    ...(experiment.settings.view === "turn" ? [texts.turn_keys] : [])];
  const is_resumed = kept("consent") && session.trials.some(({ number }) => kept(`trial-${number}`));
  timeline.push(text_page("", { title: texts.instructions,
    texts: [...(is_resumed ? [texts.resumed] : []), ...instructions, ...keys] }));
  if (experiment.demographics.length && !kept("demographics"))
    timeline.push(text_page("demographics", { title: texts.about_you, questions: experiment.demographics }));
  timeline.push({ type: LoadPage, words: texts, load: async (told: (done: number, all: number) => void) => {
    if (experiment.settings.view === "turn") await load_turn_view();
    const measured = refresh_rate();
    await fill(stock, experiment, session, told);
    around.refresh_hz = await measured;
  } });
  const trials = session.trials.filter(({ number }) => !kept(`trial-${number}`));
  trials.forEach((trial, index) => {
    const before = index > 0 ? trials[index - 1] : undefined;
    if (trial.practice && !before?.practice)
      timeline.push(text_page("", { title: texts.practice, texts: [texts.practice_begins] }));
    if (!trial.practice && before?.practice)
      timeline.push(text_page("", { title: experiment.title, texts: [texts.main_begins] }));
    timeline.push({ type: TrialPage, asked: trial, shown_in: around });
  });
  if (!kept("ending"))
    timeline.push(text_page("ending", { title: texts.almost, comment: texts.last_words,
      buttons: [texts.finish] }));
  return timeline;
}

async function main(): Promise<void> {
  const mode = mode_of_page();
  const experiment = await experiment_of(mode, checked);
  const texts = texts_of(experiment.language);
  if (!may_begin(experiment, texts)) return;
  const store = await store_of(mode, experiment, texts, {
    results: (session, records) => answers_csv(experiment, session, records),
    files: (session, records) => ({ "participants.csv": participants_csv(experiment, session, records) }),
  });
  if (!records_of(experiment, store.session).every((name) => store.kept.has(name))) {
    expect_own(experiment, store);
    const jsPsych = initJsPsych({ display_element: root(), override_safe_mode: true });
    const running = jsPsych.run(timeline_of(mode, experiment, store, texts) as never);
    root().removeAttribute("tabindex");  // jsPsych's own keyboard is not used
    await running;
    await store.finish();
  }
  show_ending(mode, experiment, store, texts, () => save_files(experiment, store));
}

main().catch((error: unknown) => show_closed(error, texts_of(document.documentElement.lang)));
