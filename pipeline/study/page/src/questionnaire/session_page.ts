// What the pages of all experiments begin and end with.

import { forgetDistance } from "./blind_spot";
import { button, element } from "./elements";
import type { Destination, Recruitment, SessionEnd } from "./experiment";
import type { SavedFile } from "./files";
import { inLanguage, type InLanguages } from "./language";
import { isPhone } from "./measures";
import { runScript } from "./media";
import { showTextPage } from "./text_view";
import { forgetDrawers, SessionClosed, type Store } from "./store";
import type { EarlyEnds } from "./early_ends";
import { destinationOf, forgetParameters, keepForWindow, keptForWindow, returnElements, type Parameters } from "./recruitment";
import { base, root, show, type Mode } from "./surroundings";
import { directionOf, type Texts } from "./texts";
import { endWithdrawalOffer, offerWithdrawal } from "./withdrawal";

type WithdrawnFrom = Pick<Store, "name" | "withdraw"> & { session: { participant: string } };

/** Of any experiment. */
export interface Frame {
  design: string;
  title: string;
  language: string;
  page_texts?: InLanguages["page_texts"];
  texts: { debriefing?: string[]; ending: string[] };
  settings: { phones: "refused" | "served" };
  recruitment?: Recruitment;
  browser?: string;
  ended?: SessionEnd;
  destination?: Destination;
}

/** The parameters of the participant's link, and the destination at the end of the session. */
export interface Referral {
  parameters: Parameters;
  destination?: Destination;
}

/** The experiment that the server gives, or a script beside the page, in the language that the browser prefers;
    `checked` refuses what is none. */
export async function experimentOf<Own extends InLanguages>(
  mode: Mode, checked: (given: unknown) => Own): Promise<Own> {
  return inLanguage(await givenExperiment(mode, checked), navigator.languages);
}

async function givenExperiment<Own>(mode: Mode, checked: (given: unknown) => Own): Promise<Own> {
  if (mode === "served") {
    const answer = await fetch(`${base()}session.json`, { cache: "no-store" });
    if (!answer.ok) throw new Error(`The server gives no experiment (${answer.status}).`);
    return checked(await answer.json());
  }
  await runScript("experiment.js");
  return checked((globalThis as { mienExperiment?: unknown }).mienExperiment);
}

/** Sets the language, direction and title of the page. False on a phone if phones are refused: the page then says so. */
export function mayBegin(experiment: Frame, texts: Texts, parameters: Parameters = {}): boolean {
  const { language } = experiment;
  document.documentElement.lang = language;
  document.documentElement.dir = directionOf(language, experiment.page_texts?.[language]);
  document.title = experiment.title;
  const isRefused = experiment.settings.phones === "refused" && isPhone();
  const destination = destinationOf(experiment.recruitment, "screened_out");
  if (isRefused)
    show(experiment.title, [texts.phone], ...returnElements(texts, destination, parameters, false));
  return !isRefused;
}

/** Throws where another browser has the session. */
export function expectOwn(experiment: Frame, store: { name: string }): void {
  if (experiment.browser && experiment.browser !== store.name) throw new SessionClosed("elsewhere");
}

/** What follows when the session ended early: thanks, a reason, and the way back. */
export function showEarlyEnd(
  texts: Texts, said: string[], { parameters, destination }: Referral, leave?: Store["leave"]): void {
  endWithdrawalOffer();
  show(texts.thanks, said, ...returnElements(texts, destination, parameters, false, leave));
}

/** What is said to whoever has withdrawn. */
const saidOfWithdrawal = (experiment: Frame, texts: Texts): string[] =>
  [texts.withdrawn, ...(experiment.texts.debriefing ?? [])];

/** From now on, the participant may withdraw; where no server knows that, `ends` remembers it. */
export function mayWithdraw(
  experiment: Frame, store: WithdrawnFrom, texts: Texts, parameters: Parameters, ends?: EarlyEnds): void {
  if (!store.withdraw) return;
  offerWithdrawal(texts, () => store.withdraw!(), (told) => {
    const { design } = experiment;
    forgetParameters(experiment, store.name);
    forgetDrawers(design, store.name);
    forgetDistance(store.name);
    ends?.note("withdrawn", { participant: store.session.participant, design, ended: "withdrawn" });
    const destination = told ?? destinationOf(experiment.recruitment, "withdrawn");
    if (destination) keepForWindow(experiment, destination.address, parameters);
    showEarlyEnd(texts, saidOfWithdrawal(experiment, texts), { parameters, destination });
  });
}

/**
 * Whether the session of this link ended early before, as a server says or this browser remembers; then its last page is
 * shown again. Of a server, whoever was screened out is recognized later, by the session. `leave` is for those who were
 * screened out.
 */
export function showFormerEnd(
  experiment: Frame, texts: Texts, given: Parameters, ends: EarlyEnds | undefined, leave?: Store["leave"]): boolean {
  const ended = ends ? ends.former()?.ended : experiment.ended;
  const destination = ended && (experiment.destination ?? destinationOf(experiment.recruitment, ended));
  const parameters = { ...keptForWindow(experiment), ...given };
  if (ended === "withdrawn")
    showEarlyEnd(texts, saidOfWithdrawal(experiment, texts), { parameters, destination });
  else if (ended === "refused")
    showEarlyEnd(texts, [destination ? texts.refusedHere : texts.refused], { parameters, destination });
  else if (ends && ended === "screened_out")
    showEarlyEnd(texts, [texts.screenedOut], { parameters, destination }, leave);
  else if (ended === "failed_attention")
    showEarlyEnd(texts, [texts.failedAttention], { parameters, destination });
  else return false;
  return true;
}

/** The debriefing, if the study has one. */
export async function debrief(experiment: Frame, texts: Texts): Promise<void> {
  const { debriefing } = experiment.texts;
  if (debriefing?.length)
    await showTextPage(root(), { title: texts.debriefing, texts: debriefing, buttons: [texts.next], words: texts });
}

/** The study's own last words, without those that only repeat the heading. */
function ownEnding(experiment: Frame, texts: Texts): string[] {
  const bare = (text: string) => text.trim().replace(/[.!。！ ]+$/u, "").toLowerCase();
  return experiment.texts.ending.filter((text) => bare(text) !== bare(texts.thanks));
}

/** Whether a page without a server is on the participant's own computer, and not on that of the experimenter. */
const isTakenElsewhere = ({ recruitment }: Frame): boolean => location.protocol !== "file:" || !!recruitment;

/** Thanks; where no server keeps the answers, with their files, which `save` gives: on the
    participant's own computer, they have to be sent; on that of the experimenter, the next participant follows. */
export function showEnding(
  mode: Mode, experiment: Frame, store: Pick<Store, "name" | "clear" | "leave">, texts: Texts, save: () => SavedFile[],
  { parameters, destination }: Referral = { parameters: {} }): void {
  const back = returnElements(texts, destination, parameters, mode !== "static", store.leave,
    texts.completionCode);
  const code = element("section", { class: "later" }, element("h2", {}, texts.deletionCode),
    element("p", {}, texts.withdrawLater), element("p", {}, element("code", {}, store.name)));
  if (mode !== "static")
    return show(texts.thanks,
      [...ownEnding(experiment, texts), back.length ? texts.finishedHere : texts.finished], ...back, code);
  const files = save();
  if (isTakenElsewhere(experiment)) {
    const again = button(texts.saveAgain, () => files.forEach((file, index) => setTimeout(file.save, 300 * index)));
    return show(texts.thanks, [...ownEnding(experiment, texts), texts.finishedSend],
      element("ul", { class: "files" }, ...files.map(({ name }) => element("li", {}, element("code", { dir: "ltr" }, name)))),
      element("div", { class: "buttons column" }, again), ...back, code);
  }
  const again = files.map((file) => button(texts.saveFile({ name: file.name }), file.save));
  const next = button(texts.nextParticipant, () => {
    store.clear?.();
    // The next one gets a plan of his own.
    location.replace(location.pathname);
  });
  show(texts.thanks, [...ownEnding(experiment, texts), texts.finishedFiles],
    ...back, element("div", { class: "buttons column" }, ...again), element("div", { class: "buttons" }, next), code);
}
