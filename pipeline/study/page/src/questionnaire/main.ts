import { initJsPsych } from "jspsych";
import { Tracks } from "./adaptive/tracks";
import { distanceOf, measureDistance } from "./blind_spot";
import { calibrate, calibration, neededWindow, needsCalibration, rowsOfSet } from "./display";
import {
  checked, recordsOf, type Destination, type Experiment, type PageRecord, type Trial,
} from "./experiment";
import type { EarlyEnds } from "./early_ends";
import { isForExperimenter, showExperimenterPage } from "./experimenter_page";
import { filesOf, saveOnce } from "./files";
import { jatosIds, leaveJatos } from "./jatos";
import { LoadPage } from "./load_page";
import { isTouched, refreshRate } from "./measures";
import { fill, type Stock } from "./media";
import { completedEnd, destinationOf, keptParameters, parametersOf, rememberedParameters,
  rememberParameters, type Parameters } from "./recruitment";
import { answersCsv, participantRow, participantsCsv } from "./rows";
import { loadTurnView } from "./screen";
import { RunPage } from "./run_page";
import { enlargedWindow, runScreening, screeningFault } from "./screening";
import { debrief, experimentOf, expectOwn, mayBegin, mayWithdraw, showEarlyEnd, showEnding, showFormerEnd } from "./session_page";
import { namedSession, SessionClosed, type Store } from "./store";
import { changedScale } from "./trials/continuous";
import { earlyEndsOfLink, goOnWhereJoined, linkParameters, modeOfPage, root, showClosed, storeOf, type Mode } from "./surroundings";
import { TextPage } from "./text_page";
import { pageRecord, showTextPage, waitNote, type GivenOnPage } from "./text_view";
import { textsOf, type Texts } from "./texts";
import { TrialPage, type TrialSurroundings } from "./trial_page";
import { endWithdrawalOffer } from "./withdrawal";

/** What the pages of a session share. */
interface Session {
  mode: Mode;
  experiment: Experiment;
  store: Store;
  texts: Texts;
  parameters: Parameters;
  /** Where no server knows how sessions ended. */
  ends: EarlyEnds | undefined;
  /** Returns once the record is kept; where nothing more is accepted, it says why and does not return. */
  keep(record: PageRecord, page: HTMLElement): Promise<void>;
}

const forever = () => new Promise<never>(() => {});

function sessionOf(
  mode: Mode, experiment: Experiment, store: Store, texts: Texts, parameters: Parameters, ends: EarlyEnds | undefined): Session {
  return { mode, experiment, store, texts, parameters, ends,
    async keep(record, page) {
      try {
        await store.keep(record, waitNote(page, texts));
      } catch (error) {
        showClosed(error, texts);
        await forever();
      }
    } };
}

/** A page of texts and questions; with a name, what is given there is kept. */
const textPage = ({ store, texts, keep }: Session, name: string, more: object) => ({
  type: TextPage, words: texts, buttons: [texts.next],
  keep: name
    ? (given: GivenOnPage, page: HTMLElement) => keep(pageRecord(name, store.name, given), page)
    : null,
  ...more,
});

/** Keeps the answer to the consent; for whoever refuses, the session ends here. */
async function keepConsent(own: Session, given: GivenOnPage, page: HTMLElement): Promise<void> {
  const { mode, experiment, store, texts, parameters, ends } = own;
  const agreed = given.pressed === 0;
  const responses = [{ item: "consent", value_raw: agreed ? "agreed" : "refused", rt_ms: 0 }];
  const record = pageRecord("consent", store.name, { ...given, responses });
  record.language = experiment.language;
  if (experiment.consent) record.consent = experiment.consent;
  if (agreed && mode === "jatos") record.jatos = jatosIds();
  if (agreed && experiment.recruitment) {
    rememberParameters(experiment, store.name, parameters);
    record.url_parameters = await keptParameters(experiment, parameters, mode === "served");
  }
  if (agreed || mode === "served") await own.keep(record, page);
  if (agreed) return mayWithdraw(experiment, store, texts, parameters, ends);
  if (mode === "served") store.clear?.();
  const destination = destinationOf(experiment.recruitment, "refused");
  showEarlyEnd(texts, [destination || store.leave ? texts.refusedHere : texts.refused],
    { parameters, destination }, store.leave);
  await forever();
}

/** Keeps the screening; for whoever is turned away, the session ends here. */
async function keepScreening(own: Session, record: PageRecord, page: HTMLElement): Promise<void> {
  const { mode, experiment, store } = own;
  await own.keep(record, page);
  const isOut = mode === "served" ? store.ended?.() === "screened_out"
    : screeningFault(experiment.screening, record) !== "";
  if (isOut) await turnAway(own);
}

/** The session of a participant who was screened out. */
async function turnAway({ mode, experiment, store, texts, parameters, ends }: Session): Promise<never> {
  if (store.mustFinish?.() ?? true) await store.finish(waitNote(root(), texts));
  ends?.note("screened_out", participantRow(experiment, store.session, store.records));
  if (mode === "static") store.clear?.();
  const destination = store.destination?.() ?? destinationOf(experiment.recruitment, "screened_out");
  showEarlyEnd(texts, [texts.screenedOut], { parameters, destination }, store.leave);
  return forever();
}

/** What a grid shows at a time: a film and the reference. */
const besidesReference = ({ media, reference }: Trial): string[] =>
  [...media.slice(0, 1), ...(reference ? [reference] : [])];

/** Asks for a window in which the stimuli have their size; whoever cannot give one goes on all the same. */
async function fitWindow({ experiment, store, texts }: Session, display: HTMLElement): Promise<void> {
  const { settings, media } = experiment;
  const trials = store.session.trials.flatMap((trial) => (trial.by_level ?? [trial.media]).map((films) => {
    const shown = trial.kind === "grid" ? besidesReference(trial)
      : settings.pairs === "in_turn" ? films.slice(0, 1)
      : trial.reference ? [...films, trial.reference] : films;
    return rowsOfSet(shown.map((token) => media[token]!));
  }));
  await enlargedWindow(display, texts, neededWindow(settings.display, trials));
}

/** Asks for consent. It comes before the timeline, as some stores choose the plan only once it is given. */
async function askConsent(own: Session): Promise<void> {
  const { experiment, texts } = own;
  const { consent } = experiment.texts;
  await showTextPage(root(), { title: experiment.title || texts.welcome, texts: consent, words: texts,
    buttons: consent.length ? [texts.agree, texts.refuse] : [texts.next],
    keep: (given, page) => keepConsent(own, given, page) });
  root().replaceChildren();  // jsPsych would put its pages below this one
}

/** What is said before a trial: that the question changes, that practice begins or is over. */
function pagesBetween(own: Session, before: Trial | undefined, trial: Trial): object[] {
  const { experiment, texts, store } = own;
  const earlier = store.session.trials.filter(({ number }) => number < trial.number);
  const hasMain = earlier.some(({ practice }) => !practice);
  const isNew = trial.practice && !before?.practice;
  const changed = changedScale(earlier, trial, experiment, texts);
  if (changed)
    return [textPage(own, "", { title: texts.questionChanges,
      texts: [changed, ...(isNew ? [texts.practiceAgain] : [])] })];
  if (isNew)
    return [textPage(own, "", { title: texts.practice, texts: [hasMain ? texts.practiceAgain : texts.practiceBegins] })];
  if (!trial.practice && before?.practice)
    return [textPage(own, "", { title: experiment.title, texts: [hasMain ? texts.mainGoesOn : texts.mainBegins] })];
  return [];
}

/** The timeline after consent; what is kept already is left out. */
function timelineOf(own: Session) {
  const { experiment, store, texts, keep } = own;
  const { session } = store;
  const stock: Stock = new Map();
  const kept = (name: string) => store.kept.has(name);
  const tracks = experiment.adaptive && new Tracks(experiment.adaptive, session, store.records, experiment.answered);
  const around: TrialSurroundings = { experiment, session, texts, stock, name: store.name,
    refresh_hz: null, tracks, async keep(record, page) {
      await keep(record, page);
      tracks?.note(record);
    } };
  const timeline: object[] = [];
  const { instructions } = experiment.texts;

  const { screening } = experiment;
  if (screening && !kept("screening"))
    timeline.push({ type: RunPage, run: (display: HTMLElement) =>
      runScreening(display, screening, store.name, texts, (record, page) => keepScreening(own, record, page)) });
  const calibrating = { type: RunPage, run: async (display: HTMLElement) => {
    const { display: asked } = experiment.settings;
    if (needsCalibration(asked)) await calibrate(display, texts, asked!.distance_cm);
    if (!asked?.blind_spot) return;
    if (distanceOf(store.name) === undefined) await measureDistance(display, texts, store.name, calibration()!);
    asked.measured_cm = distanceOf(store.name) ?? undefined;
  } };
  if (experiment.settings.display)
    timeline.push(calibrating,
      { type: RunPage, run: (display: HTMLElement) => fitWindow(own, display) });
  const isGrid = session.trials.some(({ kind }) => kind === "grid");
  const isContinuous = session.trials.some(({ kind }) => kind === "continuous");
  const keys = [...(isContinuous ? [texts.continuousHow] : []),
    ...(isTouched() ? [] : [isContinuous ? texts.continuousKeys : isGrid ? texts.gridKeys : texts.keys]),
    ...(experiment.settings.view === "turn" ? [texts.turnKeys] : [])];
  const isResumed = kept("consent") && session.trials.some(({ number }) => kept(`trial-${number}`));
  timeline.push(textPage(own, "", { title: texts.instructions,
    texts: [...(isResumed ? [texts.resumed] : []), ...instructions, ...keys] }));
  if (experiment.demographics.length && !kept("demographics"))
    timeline.push(textPage(own, "demographics", { title: texts.aboutYou, questions: experiment.demographics }));
  timeline.push({ type: LoadPage, words: texts, load: async (told: (done: number, all: number) => void) => {
    if (experiment.settings.view === "turn") await loadTurnView();
    const measured = refreshRate();
    await fill(stock, experiment, session, told);
    around.refresh_hz = await measured;
  } });
  const trials = session.trials.filter(({ number }) => !kept(`trial-${number}`));
  trials.forEach((trial, index) => {
    const before = index > 0 ? trials[index - 1] : undefined;
    timeline.push(...pagesBetween(own, before, trial));
    // The window may have been moved to another screen, or zoomed.
    if (experiment.settings.display) timeline.push(calibrating);
    timeline.push({ type: TrialPage, asked: trial, shownIn: around });
  });
  if (!kept("ending"))
    timeline.push(textPage(own, "ending", { title: texts.almost, comment: texts.lastWords,
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
  const texts = textsOf(experiment.language, experiment.page_texts?.[experiment.language]);
  const link = await linkParameters(mode);
  if (mode === "static" && isForExperimenter(link))
    return showExperimenterPage(experiment, (kept) => filesOf(experiment,
      { ...kept, session: namedSession(experiment.sessions, kept.participant) }));
  const given = parametersOf(experiment, link);
  if (!mayBegin(experiment, texts, given)) return;
  const ends = earlyEndsOfLink(mode, experiment, link);
  if (showFormerEnd(experiment, texts, given, ends, mode === "jatos" ? leaveJatos : undefined)) return;
  await goOnWhereJoined(experiment, given, texts);
  if (experiment.enough) return showClosed(new SessionClosed("enough"), texts);
  const store = await storeOf(mode, experiment, texts, {
    results: (session, records) => answersCsv(experiment, session, records),
    files: (session, records) => ({ "participants.csv": participantsCsv(experiment, session, records) }),
  });
  const parameters = rememberedParameters(experiment, store.name, given);
  const own = sessionOf(mode, experiment, store, texts, parameters, ends);
  const isTurnedAway = experiment.ended === "screened_out" ||
    (mode !== "served" && screeningFault(experiment.screening, store.records.screening) !== "");
  if (isTurnedAway) await turnAway(own);
  const isOwn = !experiment.browser || experiment.browser === store.name;
  if (isOwn && store.kept.has("consent")) mayWithdraw(experiment, store, texts, parameters, ends);
  if (!recordsOf(experiment, store.session).every((name) => store.kept.has(name))) {
    expectOwn(experiment, store);
    if (!store.kept.has("consent")) await askConsent(own);
    if (experiment.joining) await forever();
    const jsPsych = initJsPsych({ display_element: root(), override_safe_mode: true });
    const running = jsPsych.run(timelineOf(own) as never);
    root().removeAttribute("tabindex");  // jsPsych's own keyboard is not used
    await running;
    await store.finish(waitNote(root(), texts));
  } else if (store.mustFinish?.()) {
    await store.finish(waitNote(root(), texts));
  }
  if (mode === "static") endWithdrawalOffer();  // the files are the participant's or the experimenter's now
  await debrief(experiment, texts);
  showEnding(mode, experiment, store, texts, () => saveOnce(filesOf(experiment, store), store),
    { parameters, destination: destinationAtEnd(mode, experiment, store) });
}

main().catch((error: unknown) => showClosed(error, textsOf(document.documentElement.lang)));
