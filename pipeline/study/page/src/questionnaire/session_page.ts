// What the pages of all experiments begin and end with.

import { button, element } from "./elements";
import type { SavedFile } from "./files";
import { is_phone } from "./measures";
import { run_script } from "./media";
import { SessionClosed, type Store } from "./store";
import { base, show, type Mode } from "./surroundings";
import type { Texts } from "./texts";

/** Of any experiment. */
export interface Frame {
  title: string;
  language: string;
  texts: { ending: string[] };
  settings: { phones: "refused" | "served" };
  browser?: string;
  refused?: boolean;
}

/** The experiment that the server gives, or a script beside the page; `checked` refuses what is none. */
export async function experiment_of<Own>(mode: Mode, checked: (given: unknown) => Own): Promise<Own> {
  if (mode === "served") {
    const answer = await fetch(`${base()}session.json`, { cache: "no-store" });
    if (!answer.ok) throw new Error(`The server gives no experiment (${answer.status}).`);
    return checked(await answer.json());
  }
  await run_script("experiment.js");
  return checked((globalThis as { mienExperiment?: unknown }).mienExperiment);
}

/** Gives the page its language and title. False on a phone where none is wanted: it says so. */
export function may_begin(experiment: Frame, texts: Texts): boolean {
  document.documentElement.lang = experiment.language;
  document.title = experiment.title;
  const is_refused = experiment.settings.phones === "refused" && is_phone();
  if (is_refused) show(experiment.title, [texts.phone]);
  return !is_refused;
}

/** Throws where the participant has refused, or another browser has the session. */
export function expect_own(experiment: Frame, store: { name: string }): void {
  if (experiment.refused) throw new SessionClosed("refused");
  if (experiment.browser && experiment.browser !== store.name) throw new SessionClosed("elsewhere");
}

/** Thanks; where no server keeps the answers, with their files, which `save` gives, and the way to the next
    participant. */
export function show_ending(
  mode: Mode, experiment: Frame, store: Pick<Store, "clear">, texts: Texts, save: () => SavedFile[]): void {
  if (mode !== "static") return show(texts.thanks, [...experiment.texts.ending, texts.finished]);
  const again = save().map((file) => button(texts.save_file(file.name), file.save));
  const next = button(texts.next_participant, () => {
    store.clear?.();
    // The next one gets a plan of his own.
    location.replace(location.pathname);
  });
  show(texts.thanks, [...experiment.texts.ending, texts.finished_files],
    element("div", { class: "buttons column" }, ...again), element("div", { class: "buttons" }, next));
}
