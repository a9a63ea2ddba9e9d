import type { PageRecord, Planned } from "./experiment";
import { leastTaken, namedSession, pause, randomName, type Remembered, type Store, type Wait } from "./store";

/** What is used of jatos.js. */
interface Jatos {
  onLoad(ready: () => void): void;
  studySessionData: { mien?: Remembered };
  urlQueryParameters?: Record<string, string>;
  workerId?: string | number;
  batchId?: string | number;
  studyResultId?: string | number;
  batchSession?: {
    get(name: string): Record<string, number> | undefined;
    set(name: string, value: unknown): Promise<unknown>;
  };
  setStudySessionData(value: unknown): Promise<unknown>;
  submitResultData(text: string): Promise<unknown>;
  uploadResultFile?(text: string, name: string): Promise<unknown>;
  /** Leads to the study's own End Redirect URL, where it has one. */
  endStudy(): Promise<unknown>;
  endStudyAndRedirect?(address: string): Promise<unknown>;
  /** Deletes all result data of this run. */
  abortStudyWithoutRedirect?(message: string): Promise<unknown>;
  /** Its name before JATOS 3.9.7. */
  abortStudyAjax?(message: string): Promise<unknown>;
}

const jatosOfWindow = (): Jatos | undefined => (globalThis as { jatos?: Jatos }).jatos;

/** Once jatos.js has loaded what JATOS knows of this run. */
function loadedJatos(): Promise<Jatos> {
  const jatos = jatosOfWindow();
  if (!jatos) throw new Error("This questionnaire must be opened through JATOS.");
  return new Promise((ready) => jatos.onLoad(() => ready(jatos)));
}

/** The parameters of the study link, which JATOS takes away from the page's own address. */
export const jatosParameters = async (): Promise<Record<string, string>> =>
  (await loadedJatos()).urlQueryParameters ?? {};

/** The ids of worker, batch and result, where JATOS tells them. */
export function jatosIds(): Record<string, string> {
  const jatos = jatosOfWindow();
  const ids = { worker: jatos?.workerId, batch: jatos?.batchId, result: jatos?.studyResultId };
  return Object.fromEntries(Object.entries(ids)
    .flatMap(([name, id]) => (id === undefined || id === null ? [] : [[name, String(id)]])));
}

/** Ends the run, and leads to the address. */
export function leaveJatos(address: string | undefined): void {
  const jatos = jatosOfWindow()!;
  if (!address) void jatos.endStudy();
  else if (jatos.endStudyAndRedirect) void jatos.endStudyAndRedirect(address);
  else void jatos.endStudy().then(() => location.assign(address));
}

/**
 * Counts the session that is taken in the batch session, which all participants of a batch share.
 * JATOS refuses a change that was made on an old state; then another one is chosen.
 */
async function leastTakenOfBatch(experiment: Planned<{ participant: string }>, jatos: Jatos): Promise<string> {
  for (let tries = 0; ; tries += 1) {
    const taken = jatos.batchSession?.get("mien_taken") ?? {};
    const { participant } = leastTaken(experiment.sessions, taken);
    if (!jatos.batchSession || tries === 8) return participant;
    try {
      await jatos.batchSession.set("mien_taken",
        { ...taken, [participant]: (taken[participant] ?? 0) + 1 });
      return participant;
    } catch {
      await pause(100 + 300 * Math.random());
    }
  }
}

/** Tables of a session, as they are handed in. */
export interface Tables<Own> {
  /** Complete after every record. */
  results(session: Own, records: Record<string, PageRecord>): string;
  /** Name → text, at the end. */
  files(session: Own, records: Record<string, PageRecord>): Record<string, string>;
}

/** The result data is a table of what was given so far; a reload goes on from the study session. Which plan it is, is
    chosen with the first record, the consent: who does not agree takes none. */
export async function jatosStore<Own extends { participant: string }>(
  experiment: Planned<Own>, tables: Tables<Own>): Promise<Store<Own>> {
  const jatos = await loadedJatos();
  let own = jatos.studySessionData?.mien;
  let mustChoose = false;
  if (!own) {
    const wanted = jatos.urlQueryParameters?.participant;
    const { participant } = wanted ? namedSession(experiment.sessions, wanted) : experiment.sessions[0]!;
    own = { participant, name: randomName(), records: {} };
    mustChoose = !wanted;
  }
  const kept = own;
  /** Whether it was done, in one try. */
  const isSent = async (does: () => Promise<unknown>, wait: Wait) => {
    const slow = setTimeout(() => wait("saving"), 400);
    try {
      await does();
      return true;
    } catch {
      return false;
    } finally {
      clearTimeout(slow);
    }
  };
  const send = async (does: () => Promise<unknown>, wait: Wait) => {
    for (let tries = 0; !(await isSent(does, wait)); tries += 1) {
      wait("failed");
      await pause(Math.min(500 * 1.6 ** tries, 10000));
    }
  };
  /** A file is refused if that fails again and again while JATOS can be reached. */
  const isUploaded = async (text: string, name: string, wait: Wait) => {
    for (let refusals = 0; refusals < 3; refusals += 1) {
      if (await isSent(() => jatos.uploadResultFile!(text, name), wait)) return true;
      wait("failed");
      await pause(1000);
      await send(() => jatos.setStudySessionData({ ...jatos.studySessionData, mien: kept }), wait);
    }
    return false;
  };
  const store: Store<Own> = {
    session: namedSession(experiment.sessions, kept.participant),
    name: kept.name,
    records: kept.records,
    kept: new Set(Object.keys(kept.records)),
    async keep(record: PageRecord, wait) {
      if (mustChoose) {
        mustChoose = false;
        kept.participant = await leastTakenOfBatch(experiment, jatos);
        store.session = namedSession(experiment.sessions, kept.participant);
      }
      kept.records[record.record] = record;
      store.kept.add(record.record);
      await send(() => jatos.setStudySessionData({ ...jatos.studySessionData, mien: kept }), wait);
      await send(() => jatos.submitResultData(tables.results(store.session, kept.records)), wait);
    },
    mustFinish: () => !kept.is_handed_in,
    // A JATOS that takes no files, or no more, keeps nobody from the last page. Answers are in its result data.
    async finish(wait) {
      const files: [string, string][] = [
        ...Object.entries(tables.files(store.session, kept.records)),
        ["records.json", JSON.stringify(kept)],
      ];
      if (jatos.uploadResultFile)
        for (const [name, text] of files)
          if (!await isUploaded(text, `${store.session.participant}-${name}`, wait)) break;
      kept.is_handed_in = true;
      await send(() => jatos.setStudySessionData({ ...jatos.studySessionData, mien: kept }), wait);
    },
    async withdraw() {
      if (jatos.abortStudyWithoutRedirect) await jatos.abortStudyWithoutRedirect("withdrawn");
      else if (jatos.abortStudyAjax) await jatos.abortStudyAjax("withdrawn");
      else throw new Error("This JATOS cannot delete the answers of a run.");
      return undefined;
    },
    leave: leaveJatos,
  };
  return store;
}
