// index.html?experimenter: what this browser keeps of a study without a server, and how the next participant begins.
// In English, as all pages for experimenters.

import { admitNext, earlyEndsOf, forgetEarlyEnds, type EarlyEnd } from "./early_ends";
import { button, element } from "./elements";
import { download, type TextFile } from "./files";
import { csv } from "./rows";
import { forgetSharedSession, keptSessions, type Remembered } from "./store";
import { show } from "./surroundings";

/** Whether the experimenter opened the page. */
export const isForExperimenter = (link: URLSearchParams): boolean => link.has("experimenter");

/** The table of participants, of those whose sessions ended early. */
function tableOf(ends: EarlyEnd[]): TextFile {
  const columns = [...new Set(ends.flatMap(({ row }) => Object.keys(row)))];
  return { name: "ended-early_description-participants_data.csv", type: "text/csv",
    text: csv(columns, ends.map(({ row }) => row)) };
}

const lineOf = ({ ended, at, row }: EarlyEnd): string => {
  const how = ended === "withdrawn" ? "withdrew" : `was screened out (${row.screening_fault})`;
  return `${row.participant} ${how}, ${at.slice(0, 16).replace("T", " ")} UTC`;
};

/** Shows it; `filesOf` makes the files of a session. */
export function showExperimenterPage(
  { study, design }: { study: string; design: string }, filesOf: (kept: Remembered) => TextFile[]): void {
  document.documentElement.lang = "en";
  document.documentElement.dir = "ltr";
  const sessions = keptSessions(design);
  const ends = earlyEndsOf(study);
  const save = (files: TextFile[]) => files.forEach((file, index) => setTimeout(() => download(file), 300 * index));
  const begin = () => location.replace(location.pathname);
  const rows = sessions.filter(({ kept }) => kept.records.consent).map(({ kept }) => {
    const count = Object.keys(kept.records).length - 1;
    const state = kept.records.ending ? "completed"
      : count ? `agreed, ${count} ${count === 1 ? "page" : "pages"} answered` : "agreed, nothing answered";
    return element("li", {}, `${kept.participant}, session ${kept.name}: ${state} `,
      button("Save the answers", () => save(filesOf(kept))));
  });
  const next = button("Start for the next participant", () => {
    forgetSharedSession(design);
    admitNext(study);
    begin();
  }, "main");
  const forget = button("Forget everything", () => {
    if (!confirm("Forget all answers and ended sessions of this study in this browser? Save the answers first.")) return;
    for (const session of sessions) session.forget();
    forgetEarlyEnds(study);
    begin();
  });
  show("For the experimenter", [`What this browser keeps of the study ${study}. Participants do not see this page.`],
    element("h2", {}, "Sessions"), ...(rows.length ? [element("ul", {}, ...rows)] : [element("p", {}, "None.")]),
    element("h2", {}, "Ended early"),
    ...(ends.length ? [element("ul", {}, ...ends.map((end) => element("li", {}, lineOf(end)))),
      button("Save this list", () => save([tableOf(ends)]))] : [element("p", {}, "None.")]),
    element("p", { class: "later" }, "The next participant begins anew, also after somebody who was screened out or has "
      + "withdrawn. Those whose link names them (such as PROLIFIC_PID) stay remembered until everything is forgotten, "
      + "for instance after a trial run with a test link."),
    element("div", { class: "buttons" }, next, forget));
}
