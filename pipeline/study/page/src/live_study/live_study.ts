import { isForExperimenter, showExperimenterPage } from "../questionnaire/experimenter_page";
import type { PageRecord } from "../questionnaire/experiment";
import { saveOnce, type TextFile } from "../questionnaire/files";
import { participantsCsv } from "../questionnaire/rows";
import { experimentOf, expectOwn, mayBegin, mayWithdraw, showEnding, showFormerEnd } from "../questionnaire/session_page";
import { namedSession, SessionClosed, type Store } from "../questionnaire/store";
import { earlyEndsOfLink, linkParameters, modeOfPage, root, showClosed, storeOf } from "../questionnaire/surroundings";
import { waitNote } from "../questionnaire/text_view";
import { endWithdrawalOffer } from "../questionnaire/withdrawal";
import { recordsOf, type LiveExperiment, type LivePlan } from "./experiment";
import type { LiveSession, SessionParts } from "./live_session";
import { sharedTexts } from "./texts";

type Records = Record<string, PageRecord>;

/** A kind of experiment with live motions. */
export interface LiveStudy<Plan extends LivePlan, Own extends LiveExperiment<Plan>> {
  /** Of the files of complete sessions. */
  format: string;
  /** Throws with words for whoever runs the study. */
  checked(given: unknown): Own;
  /** Tables of a session as CSV by their names; the first is the result data on JATOS. */
  tables(experiment: Own, session: Plan, records: Records): Record<string, string>;
  session(parts: SessionParts<Plan, Own>): LiveSession<Plan, Own>;
}

/** The files of a session. */
function filesOf<Plan extends LivePlan, Own extends LiveExperiment<Plan>>(
  study: LiveStudy<Plan, Own>, experiment: Own,
  { session, records, name }: Pick<Store<Plan>, "session" | "records" | "name">): TextFile[] {
  const begin = `subject-${session.participant}_session-${name.slice(0, 8)}`;
  const everything = { format: study.format, study: experiment.study, design: experiment.design,
    participant: session.participant, session: name, seed: session.seed, trials: session.trials, records };
  const tables = { ...study.tables(experiment, session, records),
    participant: participantsCsv(experiment, session, records) };
  return [
    ...Object.entries(tables).map(([what, text]) =>
      ({ name: `${begin}_description-${what}_data.csv`, type: "text/csv", text })),
    { name: `${begin}_records.json`, type: "application/json", text: JSON.stringify(everything, null, 1) },
  ];
}

async function run<Plan extends LivePlan, Own extends LiveExperiment<Plan>>(study: LiveStudy<Plan, Own>): Promise<void> {
  const mode = modeOfPage();
  const experiment = await experimentOf(mode, study.checked);
  const texts = sharedTexts(experiment.language, experiment.page_texts?.[experiment.language]);
  const link = await linkParameters(mode);
  if (mode === "static" && isForExperimenter(link))
    return showExperimenterPage(experiment, (kept) => filesOf(study, experiment,
      { ...kept, session: namedSession(experiment.sessions, kept.participant) }));
  if (!mayBegin(experiment, texts)) return;
  const ends = earlyEndsOfLink(mode, experiment, link);
  if (showFormerEnd(experiment, texts, {}, ends)) return;
  if (experiment.enough) return showClosed(new SessionClosed("enough"), texts);
  const store = await storeOf<Plan>(mode, experiment, texts, {
    results: (session, records) => Object.values(study.tables(experiment, session, records))[0]!,
    files: (session, records) => ({
      ...Object.fromEntries(Object.entries(study.tables(experiment, session, records)).slice(1)
        .map(([name, text]) => [`${name}.csv`, text])),
      "participants.csv": participantsCsv(experiment, session, records),
    }),
  });
  const isOwn = !experiment.browser || experiment.browser === store.name;
  if (isOwn && store.kept.has("consent")) mayWithdraw(experiment, store, texts, {}, ends);
  if (!recordsOf(experiment, store.session).every((name) => store.kept.has(name))) {
    expectOwn(experiment, store);
    await study.session({ mode, experiment, store, texts, ends }).run();
  } else if (store.mustFinish?.()) {
    await store.finish(waitNote(root(), texts));
  }
  if (mode === "static") endWithdrawalOffer();
  showEnding(mode, experiment, store, texts, () => saveOnce(filesOf(study, experiment, store), store));
}

/** The whole page, from the first to the last. */
export const runLiveStudy = <Plan extends LivePlan, Own extends LiveExperiment<Plan>>(study: LiveStudy<Plan, Own>): void => {
  run(study).catch((error: unknown) => showClosed(error, sharedTexts(document.documentElement.lang)));
};
