// Participants of recruitment services: the parameters of their links, and where they go when their
// session has ended.

import { button, element } from "./elements";
import type { Destination, PageRecord, Recruitment, Session, SessionEnd } from "./experiment";
import { Drawer } from "./store";
import type { Texts } from "./texts";

type Recruited = { design: string; recruitment?: Recruitment };
export type Parameters = Record<string, string>;

const longestValue = 200;

/** What a table and a record can hold of a value. */
const plain = (value: string): string =>
  [...value.replace(/[\x00-\x1f\x7f]/g, " ").trim()].slice(0, longestValue).join("");

/** The parameters of a link that the study keeps, where they have a value. */
export function parametersOf(experiment: Recruited, given: URLSearchParams): Parameters {
  const found: Parameters = {};
  for (const name of experiment.recruitment?.url_parameters ?? []) {
    const value = plain(given.get(name) ?? "");
    if (value) found[name] = value;
  }
  return found;
}

const memoryOf = (experiment: Recruited, session: string): Drawer =>
  new Drawer(`mien/${experiment.design}/${session}/link`);

/**
 * The parameters of the link by which the participant of this browser session came: a reload, and
 * the session that a link of all leads to, have them no more in their own addresses.
 */
export const rememberedParameters = (experiment: Recruited, session: string, given: Parameters): Parameters =>
  experiment.recruitment ? { ...memoryOf(experiment, session).read<Parameters>(), ...given } : {};

/** Of whoever agrees. */
export function rememberParameters(experiment: Recruited, session: string, parameters: Parameters): void {
  if (Object.keys(parameters).length) memoryOf(experiment, session).write(parameters);
}

/** As they are kept: where values are hashed, a server does that, and elsewhere this page. */
export async function keptParameters(
  experiment: Recruited, values: Parameters, byServer: boolean): Promise<Parameters> {
  if (!experiment.recruitment?.pseudonymise || byServer) return values;
  const kept: Parameters = {};
  for (const [name, value] of Object.entries(values)) {
    const text = new TextEncoder().encode(`${experiment.design}\n${name}\n${value}`);
    // Browsers hash nothing on pages that came by plain http; then nothing is kept.
    const hash = await globalThis.crypto.subtle?.digest("SHA-256", text);
    if (hash) kept[name] = Array.from(new Uint8Array(hash).slice(0, 16),
      (byte) => byte.toString(16).padStart(2, "0")).join("");
  }
  return kept;
}

/** How a session ended that was completed: by the attention checks outside practice. */
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

/** Where that end leads, if anywhere. */
export function destinationOf(recruitment: Recruitment | undefined, end: SessionEnd): Destination | undefined {
  const ends = recruitment?.ends;
  return ends?.[end] ?? (end === "failed_attention" ? ends?.completed : undefined);
}

/** The address with the values of the participant's link. */
const filledAddress = (address: string, values: Parameters): string =>
  address.replace(/\{([^{}]*)\}/g, (_, name: string) => encodeURIComponent(values[name] ?? ""));

const leaveAfterSeconds = 10;

/**
 * The code as text, and the way back; by itself after a while where `leavesSoon`. `leave` is another
 * way than going to the address.
 */
export function wayBack(
  texts: Texts, destination: Destination | undefined, values: Parameters, leavesSoon: boolean,
  leave?: (address: string | undefined) => void,
): HTMLElement[] {
  if (!destination && !leave) return [];
  const address = destination && filledAddress(destination.address, values);
  const go = () => (leave ? leave(address) : location.assign(address!));
  const isProlific = !!address && /^https:\/\/app\.prolific\.com\//.test(address);
  const parts: HTMLElement[] = [];
  if (destination?.code)
    parts.push(element("p", {}, texts.completionCode, " ", element("code", { class: "completion-code" }, destination.code)));
  const label = isProlific ? texts.backToProlific : address ? texts.goOn : texts.finish;
  const buttons = element("div", { class: "buttons" }, button(label, go, "leave"));
  if (leavesSoon) {
    const timer = setTimeout(go, 1000 * leaveAfterSeconds);
    const note = element("p", { role: "status" }, texts.leavesSoon(leaveAfterSeconds));
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
