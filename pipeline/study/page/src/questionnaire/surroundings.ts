import { element, heading, paragraphs } from "./elements";
import type { Planned, Recruitment } from "./experiment";
import { jatosIds, jatosParameters, jatosStore, type Tables } from "./jatos";
import { EarlyEnds } from "./early_ends";
import { forgetJoined, joinedSession, personOf, rememberJoined, type Parameters } from "./recruitment";
import { Declined, folderStore, isPassing, joiningStore, pause, servedStore, SessionClosed, unsentRecord,
  type Store, type Wait } from "./store";
import { waitNote } from "./text_view";
import type { Texts } from "./texts";

/** Where a page of participants stands: in a folder, behind mien study serve, or in JATOS. */
export type Mode = "static" | "served" | "jatos";

export const root = (): HTMLElement => document.getElementById("page")!;

export function modeOfPage(): Mode {
  const meta = document.querySelector<HTMLMetaElement>('meta[name="mien-mode"]');
  return meta?.content === "served" || meta?.content === "jatos" ? meta.content : "static";
}

/** The parameters of the participant's link. */
export const linkParameters = async (mode: Mode): Promise<URLSearchParams> =>
  new URLSearchParams(mode === "jatos" ? await jatosParameters() : location.search);

/**
 * How sessions of this link ended early, where no server knows: by study, by what names the person, and by the plan
 * that the link chooses. On JATOS, links that name nobody may be opened by several people; there it is by the run.
 */
export function earlyEndsOfLink(
  mode: Mode, experiment: { study: string; design: string; recruitment?: Recruitment }, link: URLSearchParams,
): EarlyEnds | undefined {
  if (mode === "served") return undefined;
  const person = personOf(experiment, link) || (mode === "jatos" ? `run-${jatosIds().result ?? ""}` : "");
  const plan = link.get("participant");
  return new EarlyEnds(experiment.study, plan ? `${person}/${plan}` : person);
}

/** Where the page lies, with a slash at its end. */
export const base = (): string => location.pathname.replace(/[^/]*$/, "");

export async function storeOf<Own extends { participant: string }>(
  mode: Mode, experiment: Planned<Own>, texts: Texts, tables: Tables<Own>): Promise<Store<Own>> {
  if (mode === "jatos") return jatosStore(experiment, tables);
  if (mode === "static") {
    const link = new URLSearchParams(location.search);
    return folderStore(experiment, link.get("participant"), personOf(experiment, link));
  }
  if (experiment.joining)
    return joiningStore(experiment, base(), ({ url_parameters: given = {} }, path) =>
      rememberJoined(experiment, given, path));
  const unsent = unsentRecord(experiment, base());
  const store = servedStore(experiment, base());
  if (unsent) {
    try {
      await store.keep(unsent, waitNote(root(), texts));
      store.records[unsent.record] = unsent;
    } catch (error) {
      if (!(error instanceof Declined)) throw error;  // else the page asks once more
    }
  }
  return store;
}

/** Goes on in the session that the person of this link began before, if it is still there. */
export async function goOnWhereJoined(
  experiment: { design: string; joining?: boolean }, parameters: Parameters, texts: Texts): Promise<void> {
  const path = experiment.joining && joinedSession(experiment, parameters);
  if (!path) return;
  if (!(await isThere(path, waitNote(root(), texts)))) return forgetJoined(experiment, path);
  location.replace(path);
  await new Promise(() => {});  // the other page goes on
}

/** Whether the session has not gone; asked until the server can tell. */
async function isThere(path: string, wait: Wait): Promise<boolean> {
  for (let tries = 0; ; tries += 1) {
    const answer = await fetch(`${path}session.json`, { cache: "no-store" }).catch(() => undefined);
    if (answer?.ok) return true;
    if (answer && !isPassing(answer.status)) return false;
    wait("failed");
    await pause(Math.min(500 * 1.6 ** tries, 10000));
  }
}

/** The last page, which nothing follows. */
export function show(title: string, texts: string[], ...more: HTMLElement[]): void {
  const head = heading(title);
  root().replaceChildren(element("article", { class: "page" }, head, ...paragraphs(texts), ...more));
  head.focus();
}

/** Where nothing more can be taken, and why. Where the session has ended, the page is loaded again: the server then tells
    how, and where the participant is sent to. */
export function showClosed(error: unknown, texts: Texts): void {
  if (!(error instanceof SessionClosed)) {
    console.error(error);
    show(texts.trouble, [error instanceof Error ? error.message : String(error)]);
  } else if (error.why === "elsewhere") {
    show(texts.elsewhere, [texts.goOnThere]);
  } else if (error.why === "enough") {
    show(texts.thanks, [texts.enough]);
  } else {
    location.reload();
  }
}
