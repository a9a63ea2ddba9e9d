import { initJsPsych } from "jspsych";
import { checked, recordsOf, type Destination, type Experiment, type PageRecord } from "./experiment";
import { saveFiles } from "./files";
import { jatosIds } from "./jatos";
import { LoadPage } from "./load_page";
import { isTouched, refreshRate } from "./measures";
import { fill, type Stock } from "./media";
import { completedEnd, destinationOf, keptParameters, parametersOf, rememberedParameters,
  rememberParameters, returnElements, type Parameters } from "./recruitment";
import { answersCsv, participantsCsv } from "./rows";
import { loadTurnView } from "./screen";
import { experimentOf, expectOwn, mayBegin, showEnding } from "./session_page";
import type { Store } from "./store";
import { linkParameters, modeOfPage, root, show, showClosed, storeOf, type Mode } from "./surroundings";
import { TextPage } from "./text_page";
import { pageRecord, waitNote, type GivenOnPage } from "./text_view";
import { textsOf, type Texts } from "./texts";
import { TrialPage, type TrialSurroundings } from "./trial_page";

/** The timeline: what is kept already is left out. */
function timelineOf(
  mode: Mode, experiment: Experiment, store: Store, texts: Texts, parameters: Parameters) {
  const { session } = store;
  const stock: Stock = new Map();
  const keep = async (record: PageRecord, page: HTMLElement) => {
    try {
      await store.keep(record, waitNote(page, texts));
    } catch (error) {
      showClosed(error, texts);
      await new Promise(() => {});  // nothing follows
    }
  };
  const kept = (name: string) => store.kept.has(name);
  const around: TrialSurroundings = { experiment, session, texts, stock, name: store.name,
    refresh_hz: null, keep };
  const textPage = (name: string, more: object) => ({
    type: TextPage, words: texts, buttons: [texts.next],
    keep: name ? async (given: GivenOnPage, page: HTMLElement) => {
      await keep(pageRecord(name, store.name, given), page);
    } : null,
    ...more,
  });
  const timeline: object[] = [];
  const { consent, instructions } = experiment.texts;

  if (!kept("consent")) {
    timeline.push({
      ...textPage("consent", { title: experiment.title || texts.welcome, texts: consent,
        buttons: consent.length ? [texts.agree, texts.refuse] : [texts.next],
        keep: async (given: GivenOnPage, page: HTMLElement) => {
          const agreed = given.pressed === 0;
          const responses = [{ item: "consent", value_raw: agreed ? "agreed" : "refused", rt_ms: 0 }];
          const record = pageRecord("consent", store.name, { ...given, responses });
          if (agreed && mode === "jatos") record.jatos = jatosIds();
          if (agreed && experiment.recruitment) {
            rememberParameters(experiment, store.name, parameters);
            record.url_parameters = await keptParameters(experiment, parameters, mode === "served");
          }
          if (agreed || mode !== "static") await keep(record, page);
          if (agreed) return;
          if (mode === "static") store.clear?.();
          const back = returnElements(texts, destinationOf(experiment.recruitment, "refused"), parameters, false, store.leave);
          show(texts.thanks, [back.length ? texts.refusedHere : texts.refused], ...back);
          await new Promise(() => {});  // nothing follows
        } }),
    });
  }
  if (experiment.joining) return timeline;
  const keys = [...(isTouched() ? [] : [texts.keys]),
    ...(experiment.settings.view === "turn" ? [texts.turnKeys] : [])];
  const isResumed = kept("consent") && session.trials.some(({ number }) => kept(`trial-${number}`));
  timeline.push(textPage("", { title: texts.instructions,
    texts: [...(isResumed ? [texts.resumed] : []), ...instructions, ...keys] }));
  if (experiment.demographics.length && !kept("demographics"))
    timeline.push(textPage("demographics", { title: texts.aboutYou, questions: experiment.demographics }));
  timeline.push({ type: LoadPage, words: texts, load: async (told: (done: number, all: number) => void) => {
    if (experiment.settings.view === "turn") await loadTurnView();
    const measured = refreshRate();
    await fill(stock, experiment, session, told);
    around.refresh_hz = await measured;
  } });
  const trials = session.trials.filter(({ number }) => !kept(`trial-${number}`));
  trials.forEach((trial, index) => {
    const before = index > 0 ? trials[index - 1] : undefined;
    if (trial.practice && !before?.practice)
      timeline.push(textPage("", { title: texts.practice, texts: [texts.practiceBegins] }));
    if (!trial.practice && before?.practice)
      timeline.push(textPage("", { title: experiment.title, texts: [texts.mainBegins] }));
    timeline.push({ type: TrialPage, asked: trial, shownIn: around });
  });
  if (!kept("ending"))
    timeline.push(textPage("ending", { title: texts.almost, comment: texts.lastWords,
      buttons: [texts.finish] }));
  return timeline;
}

/** Where the participant of a completed session is sent to: a server tells that itself. */
function destinationAtEnd(mode: Mode, experiment: Experiment, store: Store): Destination | undefined {
  if (mode === "served" || !experiment.recruitment) return store.destination?.();
  const { recruitment } = experiment;
  return destinationOf(recruitment, completedEnd(recruitment, store.session, store.records));
}

async function main(): Promise<void> {
  const mode = modeOfPage();
  const experiment = await experimentOf(mode, checked);
  const texts = textsOf(experiment.language);
  const given = parametersOf(experiment, await linkParameters(mode));
  if (!mayBegin(experiment, texts, given)) return;
  const store = await storeOf(mode, experiment, texts, {
    results: (session, records) => answersCsv(experiment, session, records),
    files: (session, records) => ({ "participants.csv": participantsCsv(experiment, session, records) }),
  });
  const parameters = rememberedParameters(experiment, store.name, given);
  if (!recordsOf(experiment, store.session).every((name) => store.kept.has(name))) {
    expectOwn(experiment, store);
    const jsPsych = initJsPsych({ display_element: root(), override_safe_mode: true });
    const running = jsPsych.run(timelineOf(mode, experiment, store, texts, parameters) as never);
    root().removeAttribute("tabindex");  // jsPsych's own keyboard is not used
    await running;
    await store.finish();
  }
  showEnding(mode, experiment, store, texts, () => saveFiles(experiment, store),
    { parameters, destination: destinationAtEnd(mode, experiment, store) });
}

main().catch((error: unknown) => showClosed(error, textsOf(document.documentElement.lang)));
