import { answerColumns, participantColumns } from "./columns";
import { shownIn } from "./adaptive/tracks";
import { screeningFault } from "./screening";
import type { Experiment, PageRecord, Response, Session, Trial } from "./experiment";
import { toneAttempts, toneItem } from "./tone_count";
import type { Meaning } from "./trials/trial_kind";
import { kindOf } from "./trials/trial_kinds";

export type Row = Record<(typeof answerColumns)[number], string>;

const truth = (is: boolean): string => (is ? "1" : "0");
const numberText = (value: number | null | undefined): string =>
  value === null || value === undefined ? "" : String(value);

/** What a table cannot hold is a space there. */
const tableText = (text: string): string =>
  text.replace(/[\x00-\x08\x0b-\x1f\x7f]/g, " ");

/** One row a response, in the order of the responses. */
function rowsOf(
  experiment: Experiment, session: Session, planned: Trial, record: PageRecord,
): Row[] {
  if (record.track_ended) return [];
  const trial = shownIn(planned, record, experiment);
  const stimulus = (token: string | undefined) => (token && experiment.stimuli?.[token]) ?? "";
  const [shown, ...others] = trial.media;
  const kind = kindOf(trial);
  const expected = trial.expected ?? "";
  const isLeftOut = !!record.play_fault;
  const responses: Response[] = isLeftOut
    ? trial.items.map(({ item }) => ({ item, value_raw: "", rt_ms: 0 })) : record.responses;
  return responses.map((response, index) => {
    const raw = tableText(String(response.value_raw));
    const isKnown = !isLeftOut || trial.kind === "grid";  // what each row of a grid is about
    const meant: Meaning | null = isKnown ? kind.meaning(trial, response, raw, experiment, stimulus) : null;
    const means: Meaning = isLeftOut ? { ...meant, value: "", pole_left: "" } : meant!;
    return {
      participant: session.participant,
      session: record.session,
      trial: String(trial.number),
      block: trial.block,
      kind: trial.kind,
      stimulus: means.stimulus ?? stimulus(shown),
      stimulus_sha256: record.media_sha256?.[means.shown ?? 0] ?? "",
      against: means.against ?? (others.length ? others.map(stimulus).join(" ") : stimulus(trial.reference)),
      level: trial.level ?? "",
      track: numberText(trial.track),
      item: means.item ?? response.item,
      value_raw: raw,
      value: means.value,
      pole_left: means.pole_left,
      rt_ms: isLeftOut ? "" : numberText(response.rt_ms),
      is_practice: truth(trial.practice),
      is_warmup: truth(trial.warm_up),
      is_check: truth(trial.check || !!kind.isCheck),
      expected,
      passed: expected === "" || isLeftOut ? "" : truth(String(response.value_raw) === expected),
      replays: numberText(record.replays),
      attempt: numberText(record.attempt),
      plays_before: numberText(record.plays_before),
      watched_before_ms: numberText(record.watched_before_ms),
      play_fault: record.play_fault ?? "",
      trial_ms: numberText(record.trial_ms),
      play_start_ms: numberText(record.play_start_ms),
      ended_ms: numberText(record.ended_ms),
      stalls: numberText(record.stalls),
      stall_ms: numberText(record.stall_ms),
      dropped_frames: numberText(record.dropped_frames),
      volume_events: record.volume_events ?? "",
      blurs: numberText(record.blurs),
      blur_ms: numberText(record.blur_ms),
      viewport_width: numberText(record.viewport_width),
      viewport_height: numberText(record.viewport_height),
      refresh_hz: numberText(record.refresh_hz),
      shown_width: numberText(record.shown_width),
      shown_height: numberText(record.shown_height),
      pixel_ratio: numberText(record.pixel_ratio),
      shown_cm: numberText(record.shown_cm),
      shown_degrees: numberText(record.shown_degrees),
      viewing_cm: numberText(record.viewing_cm),
      comment: index === 0 ? tableText(record.comment) : "",
      seed: String(session.seed),
      design: experiment.design,
      simulated: truth(experiment.simulated),
    };
  });
}

/** What a spreadsheet would run gets an apostrophe before it (pipeline/base/documents/formula_mark.cpp). */
const marked = (text: string): string => {
  const bare = text.replace(/^'*/, "").replace(/^ */, "");
  const number = "[+-]?(inf|nan|(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?)";
  const isNumber = new RegExp(`^${number}(–${number})?$`).test(bare);
  return /^[=+\-@\t\r\n\uFF1D\uFF0B\uFF0D\uFF20]/.test(bare) && !isNumber ? `'${text}` : text;
};

/** Quoted where it must be. */
const field = (plain: string): string => {
  const text = marked(plain);
  return /[",\r\n]|^ | $/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
};

export const csv = (columns: readonly string[], rows: Record<string, string>[]): string =>
  [columns, ...rows.map((row) => columns.map((column) => row[column] ?? ""))]
    .map((fields) => fields.map(field).join(",") + "\n")
    .join("");

/** The answers of a session as CSV: the trials that are kept, in their order. */
export function answersCsv(
  experiment: Experiment, session: Session, records: Record<string, PageRecord>,
): string {
  const rows = session.trials.flatMap((trial) => {
    const record = records[`trial-${trial.number}`];
    return record ? rowsOf(experiment, session, trial, record) : [];
  });
  const own = parameterFields(experiment, records);
  return csv([...answerColumns, ...Object.keys(own)], rows.map((row) => ({ ...row, ...own })));
}

/** What is kept of the participant's link, and the ids of JATOS, by column. */
function parameterFields(
  experiment: Pick<Experiment, "recruitment">, records: Record<string, PageRecord>): Record<string, string> {
  const kept = records.consent?.url_parameters ?? {};
  return Object.fromEntries([
    ...(experiment.recruitment?.url_parameters ?? []).map((name) => [`url_${name}`, tableText(kept[name] ?? "")]),
    ...Object.entries(records.consent?.jatos ?? {}).map(([name, id]) => [`jatos_${name}`, tableText(id)]),
  ]);
}

/** How the session ended; empty while it lasts. */
function endOf(experiment: Pick<Experiment, "screening">, records: Record<string, PageRecord>): string {
  if (records.ending) return "completed";
  return screeningFault(experiment.screening, records.screening) ? "screened_out" : "";
}

type AskedOfPeople = Pick<Experiment, "screening" | "demographics" | "design" | "consent" | "recruitment">;

/** Who took part, without answers to questions. */
export function participantRow(
  experiment: Omit<AskedOfPeople, "demographics">, session: { participant: string }, records: Record<string, PageRecord>,
): Record<string, string> {
  const row: Record<(typeof participantColumns)[number], string> = {
    participant: session.participant,
    session: records.consent?.session ?? "",
    design: experiment.design,
    consented_at: records.consent?.started_at ?? "",
    finished: truth(!!records.ending),
    ended: endOf(experiment, records),
    screening_fault: screeningFault(experiment.screening, records.screening),
    language: records.consent?.language ?? "",
    consent_version: experiment.consent?.version ?? "",
    consent_sha256: experiment.consent?.sha256 ?? "",
    closing_comment: tableText(records.ending?.comment ?? ""),
  };
  return { ...row, ...parameterFields(experiment, records) };
}

/** Who took part, as CSV of one row. */
export function participantsCsv(
  experiment: AskedOfPeople, session: { participant: string }, records: Record<string, PageRecord>): string {
  const { screening } = experiment;
  const tones = screening?.sound ? Array.from({ length: toneAttempts }, (_, index) => toneItem(index + 1)) : [];
  const questions = [...tones,
    ...[...(screening?.questions ?? []), ...experiment.demographics].map(({ id }) => id)];
  const row = participantRow(experiment, session, records);
  for (const name of ["screening", "demographics"])
    for (const { item, value_raw: valueRaw } of records[name]?.responses ?? []) row[item] = tableText(String(valueRaw));
  const own = Object.keys(parameterFields(experiment, records));
  return csv([...participantColumns, ...questions, ...own], [row]);
}
