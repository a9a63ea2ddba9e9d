import { element, heading, paragraphs } from "./elements";
import type { Planned } from "./experiment";
import { jatos_store, type Tables } from "./jatos";
import { folder_store, joining_store, served_store, SessionClosed, unsent_record, type Store } from "./store";
import { wait_note } from "./text_view";
import type { Texts } from "./texts";

/** Where a page of participants stands: in a folder, behind mien study serve, or in JATOS. */
export type Mode = "static" | "served" | "jatos";

export const root = (): HTMLElement => document.getElementById("page")!;

export function mode_of_page(): Mode {
  const meta = document.querySelector<HTMLMetaElement>('meta[name="mien-mode"]');
  return meta?.content === "served" || meta?.content === "jatos" ? meta.content : "static";
}

/** Where the page lies, with a slash at its end. */
export const base = (): string => location.pathname.replace(/[^/]*$/, "");

export async function store_of<Own extends { participant: string }>(
  mode: Mode, experiment: Planned<Own>, texts: Texts, tables: Tables<Own>): Promise<Store<Own>> {
  if (mode === "jatos") return jatos_store(experiment, tables);
  if (mode === "static")
    return folder_store(experiment, new URLSearchParams(location.search).get("participant"));
  if (experiment.joining) return joining_store(experiment, base());
  const unsent = unsent_record(experiment, base());
  const store = served_store(experiment, base());
  if (unsent) await store.keep(unsent, wait_note(root(), texts));
  return store;
}

/** The last page, which nothing follows. */
export function show(title: string, texts: string[], ...more: HTMLElement[]): void {
  const head = heading(title);
  root().replaceChildren(element("article", { class: "page" }, head, ...paragraphs(texts), ...more));
  head.focus();
}

/** Where nothing more can be taken, and why. */
export function show_closed(error: unknown, texts: Texts): void {
  if (!(error instanceof SessionClosed)) {
    console.error(error);
    show(texts.trouble, [error instanceof Error ? error.message : String(error)]);
  } else if (error.why === "elsewhere") {
    show(texts.elsewhere, [texts.go_on_there]);
  } else {
    show(texts.thanks, [error.why === "refused" ? texts.refused : texts.enough]);
  }
}
