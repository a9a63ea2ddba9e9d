import { initJsPsych } from "jspsych";
import { element, heading, paragraphs, button } from "./elements";
import { checked, records_of, type Experiment, type PageRecord } from "./experiment";
import { save_files } from "./files";
import { jatos_store } from "./jatos";
import { LoadPage } from "./load_page";
import { is_phone, is_touched, refresh_rate } from "./measures";
import { fill, run_script, type Stock } from "./media";
import { load_turn_view } from "./screen";
import { folder_store, joining_store, served_store, SessionClosed, unsent_record, type Store } from "./store";
import { page_record, TextPage, wait_note, type GivenOnPage } from "./text_page";
import { texts_of, type Texts } from "./texts";
import { TrialPage, type TrialSurroundings } from "./trial_page";

type Mode = "static" | "served" | "jatos";

const root = (): HTMLElement => document.getElementById("page")!;

function mode_of_page(): Mode {
  const meta = document.querySelector<HTMLMetaElement>('meta[name="mien-mode"]');
  return meta?.content === "served" || meta?.content === "jatos" ? meta.content : "static";
}

/** Where the page lies, with a slash at its end. */
const base = (): string => location.pathname.replace(/[^/]*$/, "");

async function experiment_of(mode: Mode): Promise<Experiment> {
  if (mode === "served") {
    const answer = await fetch(`${base()}session.json`, { cache: "no-store" });
    if (!answer.ok) throw new Error(`The server gives no questionnaire (${answer.status}).`);
    return checked(await answer.json());
  }
  await run_script("experiment.js");
  return checked((globalThis as { mienExperiment?: unknown }).mienExperiment);
}

async function store_of(mode: Mode, experiment: Experiment, texts: Texts): Promise<Store> {
  if (mode === "jatos") return jatos_store(experiment);
  if (mode === "static")
    return folder_store(experiment, new URLSearchParams(location.search).get("participant"));
  if (experiment.joining) return joining_store(experiment, base());
  const unsent = unsent_record(experiment, base());
  const store = served_store(experiment, base());
  if (unsent) await store.keep(unsent, wait_note(root(), texts));
  return store;
}

/** The last page, which nothing follows. */
function show(title: string, texts: string[], ...more: HTMLElement[]): void {
  const head = heading(title);
  root().replaceChildren(element("article", { class: "page" }, head, ...paragraphs(texts), ...more));
  head.focus();
}

/** Where nothing more can be taken, and why. */
function show_closed(error: unknown, texts: Texts): void {
  if (!(error instanceof SessionClosed)) {
    console.error(error);
    show(texts.trouble, [error instanceof Error ? error.message : String(error)]);
  } else if (error.why === "elsewhere") {
    show(texts.elsewhere, [texts.go_on_there]);
  } else {
    show(texts.thanks, [error.why === "refused" ? texts.refused : texts.enough]);
  }
}

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

function show_ending(mode: Mode, experiment: Experiment, store: Store, texts: Texts): void {
  if (mode !== "static") {
    show(texts.thanks, [...experiment.texts.ending, texts.finished]);
    return;
  }
  const files = save_files(experiment, store);
  const again = files.map(({ name, save }) => button(texts.save_file(name), save));
  const next = button(texts.next_participant, () => {
    store.clear?.();
    // The next one gets a plan of his own.
    location.replace(location.pathname);
  });
  show(texts.thanks, [...experiment.texts.ending, texts.finished_files],
    element("div", { class: "buttons column" }, ...again), element("div", { class: "buttons" }, next));
}

async function main(): Promise<void> {
  const mode = mode_of_page();
  const experiment = await experiment_of(mode);
  const texts = texts_of(experiment.language);
  document.documentElement.lang = experiment.language;
  document.title = experiment.title;
  if (experiment.settings.phones === "refused" && is_phone()) {
    show(experiment.title, [texts.phone]);
    return;
  }
  const store = await store_of(mode, experiment, texts);
  const names = records_of(experiment, store.session);
  if (names.every((name) => store.kept.has(name))) {
    show_ending(mode, experiment, store, texts);
    return;
  }
  if (experiment.refused) throw new SessionClosed("refused");
  if (experiment.browser && experiment.browser !== store.name) throw new SessionClosed("elsewhere");
  const jsPsych = initJsPsych({ display_element: root(), override_safe_mode: true });
  const running = jsPsych.run(timeline_of(mode, experiment, store, texts) as never);
  root().removeAttribute("tabindex");  // jsPsych's own keyboard is not used
  await running;
  await store.finish();
  show_ending(mode, experiment, store, texts);
}

main().catch((error: unknown) => show_closed(error, texts_of(document.documentElement.lang)));
