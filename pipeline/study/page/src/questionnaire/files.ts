import type { Experiment } from "./experiment";
import { answersCsv, participantsCsv } from "./rows";
import type { Store } from "./store";

export interface SavedFile {
  name: string;
  save(): void;
}

export interface TextFile {
  name: string;
  type: string;
  text: string;
}

/** Saves a file among the downloads. */
export function download({ name, type, text }: TextFile): void {
  const link = document.createElement("a");
  const url = URL.createObjectURL(new Blob([text], { type }));
  link.href = url;
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 60000);
}

/** Saves files among the downloads, by itself only once; says how to do so again. */
export function saveOnce(files: TextFile[], store: Pick<Store, "isSaved" | "noteSaved">): SavedFile[] {
  const saved = files.map((file) => ({ name: file.name,
    save: () => download(file) }));
  if (!store.isSaved?.()) {
    saved.forEach(({ save }, index) => setTimeout(save, 300 * index));
    setTimeout(() => store.noteSaved?.(), 300 * (saved.length - 1));
  }
  return saved;
}

/** The files of a session. */
export function filesOf(
  experiment: Experiment, { session, records, name }: Pick<Store, "session" | "records" | "name">): TextFile[] {
  // As Psych-DS likes its files to be named.
  const begin = `subject-${session.participant}_session-${name.slice(0, 8)}`;
  const everything = { format: "mien-session-1", study: experiment.study, design: experiment.design,
    participant: session.participant, session: name, seed: String(session.seed), trials: session.trials,
    records };
  return [
    { name: `${begin}_description-answers_data.csv`, type: "text/csv", text: answersCsv(experiment, session, records) },
    { name: `${begin}_description-participant_data.csv`, type: "text/csv", text: participantsCsv(experiment, session, records) },
    { name: `${begin}_records.json`, type: "application/json", text: JSON.stringify(everything, null, 1) },
  ];
}
