// Participants of recruitment services: the parameters of their links, and where they go when their
// session has ended.

import { button, element } from "./elements";
import type { Destination, PageRecord, Recruitment, Session, SessionEnd } from "./experiment";
import { Drawer } from "./store";
import type { Texts } from "./texts";

type Recruited = { design: string; recruitment?: Recruitment };
export type Parameters = Record<string, string>;

const longestValue = 200;

/** The value in one line and of limited length, as a record and a table hold it. */
const cleaned = (value: string): string =>
  [...value.replace(/[\x00-\x1f\x7f]/g, " ").trim()].slice(0, longestValue).join("");

/** Those parameters of a link that the study keeps; without empty ones. */
export function parametersOf(experiment: Recruited, given: URLSearchParams): Parameters {
  const found: Parameters = {};
  for (const name of experiment.recruitment?.url_parameters ?? []) {
    const value = cleaned(given.get(name) ?? "");
    if (value) found[name] = value;
  }
  return found;
}

const memoryOf = (experiment: Recruited, session: string): Drawer =>
  new Drawer(`mien/${experiment.design}/${session}/link`);

/**
 * The parameters of the link that the participant of this browser session opened. After a reload, and after
 * the open link has led to a session, the page's own address no longer contains them.
 */
export const rememberedParameters = (experiment: Recruited, session: string, given: Parameters): Parameters =>
  experiment.recruitment ? { ...memoryOf(experiment, session).read<Parameters>(), ...given } : {};

/** Stores them in this browser; called when the participant has agreed. */
export function rememberParameters(experiment: Recruited, session: string, parameters: Parameters): void {
  if (Object.keys(parameters).length) memoryOf(experiment, session).write(parameters);
}

/** Deletes them from this browser; called when the participant has withdrawn. */
export const forgetParameters = (experiment: Recruited, session: string): void =>
  memoryOf(experiment, session).clear();

/** By these, recruitment services name a person. */
const ofPerson = ["PROLIFIC_PID", "workerId", "participantId", "survey_code"];

/** By these, they name a person or one participation of a person. Links without them may be opened by several people
    at the same computer. */
const personal = new Set([...ofPerson, "SESSION_ID", "assignmentId"]);

/** Tells values apart without showing them: FNV-1a of 32 bits from two beginnings. */
function markOf(text: string): string {
  const bytes = new TextEncoder().encode(text);
  return [0x811c9dc5, 0x9747b28c].map((begin) => {
    let hash = begin;
    for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193) >>> 0;
    return hash.toString(16).padStart(8, "0");
  }).join("");
}

const markOfAll = (parameters: [string, string][]): string =>
  parameters.length ? markOf(new URLSearchParams(parameters.sort()).toString()) : "";

/**
 * What tells the person of a link from others who use the same browser, as a hash: by what names the person there or,
 * where nothing does, by all parameters that the study keeps. "" for links that several people may open.
 */
export function personOf(experiment: Recruited, given: URLSearchParams): string {
  const valuesOf = (names: Iterable<string>) => [...new Set(names)].flatMap((name): [string, string][] => {
    const value = cleaned(given.get(name) ?? "");
    return value ? [[name, value]] : [];
  });
  const named = valuesOf(ofPerson);
  return markOfAll(named.length ? named : valuesOf([...personal, ...(experiment.recruitment?.url_parameters ?? [])]));
}

const joinedOf = (experiment: Recruited): Drawer => new Drawer(`mien/${experiment.design}/joined`);

/** What stands for the person in the link; empty without. */
const keyOf = (parameters: Parameters): string =>
  markOfAll(Object.entries(parameters).filter(([name]) => personal.has(name)));

/** The path of the session that this person began in this browser from the open link. */
export const joinedSession = (experiment: Recruited, parameters: Parameters): string | undefined =>
  joinedOf(experiment).read<Record<string, string>>()?.[keyOf(parameters)];

/** From now on, the open link with these parameters leads to the session at this path. */
export function rememberJoined(experiment: Recruited, parameters: Parameters, path: string): void {
  if (!keyOf(parameters)) return;
  joinedOf(experiment).write({ ...joinedOf(experiment).read<Record<string, string>>(), [keyOf(parameters)]: path });
}

/** The session at this path is gone. */
export function forgetJoined(experiment: Recruited, path: string): void {
  const others = Object.entries(joinedOf(experiment).read<Record<string, string>>() ?? {})
    .filter(([, kept]) => kept !== path);
  joinedOf(experiment).write(Object.fromEntries(others));
}

/** The values as records hold them: hashed, if the study asks for that; a server hashes them itself. */
export async function keptParameters(
  experiment: Recruited, values: Parameters, byServer: boolean): Promise<Parameters> {
  if (!experiment.recruitment?.pseudonymise || byServer) return values;
  const kept: Parameters = {};
  for (const [name, value] of Object.entries(values)) {
    const text = new TextEncoder().encode(`${experiment.design}\n${name}\n${value}`);
    // Browsers offer no hashes on pages loaded by plain http from another machine; nothing is kept then.
    const hash = await globalThis.crypto.subtle?.digest("SHA-256", text);
    if (hash) kept[name] = Array.from(new Uint8Array(hash).slice(0, 16),
      (byte) => byte.toString(16).padStart(2, "0")).join("");
  }
  return kept;
}

/** How a completed session ended, by its attention checks outside practice. */
export function completedEnd(
  recruitment: Recruitment, session: Session, records: Record<string, PageRecord>): SessionEnd {
  let failed = 0;
  for (const trial of session.trials) {
    if (!trial.expected || trial.practice) continue;
    for (const { value_raw: given } of records[`trial-${trial.number}`]?.responses ?? [])
      failed += String(given) === trial.expected ? 0 : 1;
  }
  return failed > recruitment.most_failed_checks ? "failed_attention" : "completed";
}

/** The destination of an end, if it has one. */
export function destinationOf(recruitment: Recruitment | undefined, end: SessionEnd): Destination | undefined {
  const ends = recruitment?.ends;
  return ends?.[end] ?? (end === "failed_attention" ? ends?.completed : undefined);
}

const placeholder = /\{([^{}]*)\}/g;

/** The address with the values of the participant's link. */
const filledAddress = (address: string, values: Parameters): string =>
  address.replace(placeholder, (_, name: string) => encodeURIComponent(values[name] ?? ""));

const windowKey = ({ design }: Recruited): string => `mien/${design}/leaving`;

/** Keeps those values of the link that the address needs, until this window is closed: after a withdrawal nothing else
    holds them, and the page may be loaded again. */
export function keepForWindow(experiment: Recruited, address: string, values: Parameters): void {
  const names = [...address.matchAll(placeholder)].map(([, name]) => name!);
  const needed = Object.fromEntries(names.flatMap((name) => (values[name] ? [[name, values[name]]] : [])));
  try {
    if (Object.keys(needed).length) sessionStorage.setItem(windowKey(experiment), JSON.stringify(needed));
  } catch { /* a browser that keeps nothing */ }
}

/** The values that were kept for this window. */
export function keptForWindow(experiment: Recruited): Parameters {
  try {
    return JSON.parse(sessionStorage.getItem(windowKey(experiment)) ?? "{}") as Parameters;
  } catch {
    return {};
  }
}

const leaveAfterSeconds = 15;

/**
 * The code of this end as text, and a button that leaves the page. With `leavesSoon`, the page leaves by itself
 * after a while, unless the participant chooses to stay. `leave` replaces going to the address.
 */
export function returnElements(
  texts: Texts, destination: Destination | undefined, values: Parameters, leavesSoon: boolean,
  leave?: (address: string | undefined) => void, codeLabel = texts.code,
): HTMLElement[] {
  if (!destination && !leave) return [];
  const address = destination && filledAddress(destination.address, values);
  let timer: ReturnType<typeof setTimeout> | undefined;
  const go = () => {
    clearTimeout(timer);
    if (leave) leave(address);
    else location.assign(address!);
  };
  const isProlific = !!address && /^https:\/\/app\.prolific\.com\//.test(address);
  const parts: HTMLElement[] = [];
  if (destination?.code)
    parts.push(element("p", {}, codeLabel, " ", element("code", { class: "completion-code" }, destination.code)));
  const label = isProlific ? texts.backToProlific : address ? texts.goOn : texts.finish;
  const buttons = element("div", { class: "buttons" }, button(label, go, "leave"));
  if (leavesSoon) {
    timer = setTimeout(go, 1000 * leaveAfterSeconds);
    const soon = isProlific ? texts.returnsSoon : address ? texts.leavesSoon : texts.endsSoon;
    const note = element("p", { role: "status" }, soon({ seconds: leaveAfterSeconds }));
    const stay = button(texts.stayHere, () => {
      clearTimeout(timer);
      note.remove();
      stay.remove();
    }, "quiet");
    parts.push(note);
    buttons.append(stay);
  }
  return [...parts, buttons];
}
