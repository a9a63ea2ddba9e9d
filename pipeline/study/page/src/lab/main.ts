// The experimenter's page. Texts of participants and manifests come in as text, never as HTML.
import { element } from "../questionnaire/elements";
import { histogramFigure } from "./histogram";
import type { LabStatus, Participant } from "./status";

const refreshMilliseconds = 3000;

/** Words of states, in the order in which participants are listed. */
const states: Record<Participant["state"], string> = {
  here: "here", away: "away", opened: "opened, not agreed", waiting: "personal link not opened", done: "done", refused: "refused",
  screened_out: "screened out", failed_attention: "failed attention checks", withdrawn: "withdrawn",
};
const order = Object.keys(states);

const at = (id: string): HTMLElement => document.getElementById(id)!;
const join = at("join") as HTMLInputElement;

/** Without touching the page where nothing has changed: what is selected or focused stays. */
function setText(node: Element, text: string): void {
  if (node.textContent !== text) node.textContent = text;
}

const wholeLink = (link: string): string => new URL(link, location.href).href;

async function copy(text: string, button: HTMLElement): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const field = element("textarea", { class: "hidden" }, text);
    document.body.append(field);
    field.select();
    document.execCommand("copy"); // where the page is not from this machine and not over TLS
    field.remove();
    button.focus();
  }
  const before = button.textContent;
  button.textContent = at("said").textContent = "Copied";
  setTimeout(() => {
    button.textContent = before;
    at("said").textContent = "";
  }, 1500);
}

function seenText(seconds: number | null): string {
  if (seconds === null) return "";
  if (seconds < 60) return "just now";
  if (seconds < 3600) return `${Math.floor(seconds / 60)} min ago`;
  return `${Math.floor(seconds / 3600)} h ago`;
}

const pageNames: Record<string, string> = { consent: "consent", screening: "screening", demographics: "questions about the person", ending: "end" };
const pageText = (name: string): string => pageNames[name] ?? name.replace("trial-", "trial ");

const isQuestionnaire = (status: LabStatus): boolean => !status.is_matching && !status.is_adaptive;

function showOverview(status: LabStatus): void {
  const count = (state: Participant["state"]) => status.participants.filter((one) => one.state === state).length;
  const answers = status.histograms.reduce((sum, one) => sum + one.answers, 0);
  const numbers: [string, number | string][] = [["Planned", status.planned], ["Here now", count("here")], ["Done", count("done")],
    ["Away", count("away")], ["Refused", count("refused") + status.refused_at_join], ["Screened out", count("screened_out")],
    ["Withdrawn", count("withdrawn")]];
  if (status.is_adaptive) numbers.push(["Failed checks", count("failed_attention")]);
  if (isQuestionnaire(status)) numbers.push(["Answers", answers]);
  if (status.steps[1] > 0) numbers.push(["Steps of chains", `${status.steps[0]} of ${status.steps[1]}`]);
  const list = at("overview");
  if (list.children.length !== numbers.length)
    list.replaceChildren(...numbers.map(() => element("div", {}, element("dt"), element("dd"))));
  numbers.forEach(([name, number], index) => {
    const [term, value] = list.children[index]!.children;
    setText(term!, name);
    setText(value!, String(number));
  });
}

/** What of a participant's row changes. */
interface Row {
  row: HTMLElement;
  state: HTMLElement;
  bar: HTMLProgressElement;
  count: HTMLElement;
  now: HTMLElement;
  seen: HTMLElement;
}

function newRow({ participant, link }: Participant): Row {
  const state = element("span");
  const bar = element("progress", { "aria-label": `Progress of ${participant}` });
  const count = element("span", { class: "count" });
  const now = element("td"), seen = element("td");
  const button = element("button", { type: "button", "aria-label": `Copy the link of ${participant}` }, "Copy");
  button.addEventListener("click", () => void copy(wholeLink(link), button));
  const row = element("tr", {}, element("th", { scope: "row" }, participant), element("td", {}, state),
    element("td", {}, bar, count), now, seen, element("td", {}, button));
  return { row, state, bar, count, now, seen };
}

const rows = new Map<string, Row>();

function showParticipant(participant: Participant): HTMLElement {
  const shown = rows.get(participant.participant) ?? newRow(participant);
  rows.set(participant.participant, shown);
  setText(shown.state, states[participant.state]);
  shown.state.className = `state ${participant.state}`;
  shown.bar.max = participant.records;
  shown.bar.value = participant.kept;
  setText(shown.count, `${participant.kept} of ${participant.records} pages`);
  const isUnderWay = participant.state === "here" || participant.state === "away";
  setText(shown.now, isUnderWay ? pageText(participant.next) : "");
  setText(shown.seen, seenText(participant.seen_seconds_ago));
  return shown.row;
}

/** Whether personal links that nobody has opened are listed; undefined until somebody asks. */
let listsUnopened: boolean | undefined;
let shownLast: Participant[] = [];

/** Those who are here come first. Where people come by the open link, personal links that nobody has opened are listed on
    request: they are not missing participants. */
function showParticipants(participants: Participant[]): void {
  shownLast = participants;
  const unopened = participants.filter(({ state }) => state === "waiting").length;
  const isOpenLinkUsed = participants.some(({ came_by: route }) => route === "join");
  const lists = listsUnopened ?? !isOpenLinkUsed;
  const toggle = at("unopened");
  toggle.hidden = unopened === 0 || !isOpenLinkUsed;
  const links = unopened === 1 ? "1 personal link that nobody has opened" : `${unopened} personal links that nobody has opened`;
  setText(toggle, `${lists ? "Hide" : "List"} ${links}`);
  const sorted = participants.filter(({ state }) => lists || state !== "waiting")
    .sort((one, other) => order.indexOf(one.state) - order.indexOf(other.state));
  const hidden = new Set(rows.keys());
  for (const { participant } of sorted) hidden.delete(participant);
  for (const participant of hidden) rows.get(participant)!.row.remove();
  const body = at("participants");
  sorted.map(showParticipant).forEach((row, index) => {
    if (body.children[index] !== row) body.insertBefore(row, body.children[index] ?? null);
  });
}

let drawnHistograms = "";

function showAnswers(status: LabStatus): void {
  const { passed, failed } = status.checks;
  const checks = passed + failed === 0 ? "" : ` Attention checks: ${passed} passed, ${failed} failed.`;
  setText(at("checks"), `Practice, warm-up and checks are not counted here.${checks}`);
  const now = JSON.stringify(status.histograms);
  if (now === drawnHistograms) return;
  drawnHistograms = now;
  at("histograms").replaceChildren(...status.histograms.map(histogramFigure));
}

function show(status: LabStatus): void {
  document.title = `${status.study}: laboratory`;
  setText(at("title"), status.title);
  setText(at("about"), `Study ${status.study}, design ${status.design.slice(0, 8)}`);
  const link = wholeLink(status.join);
  if (join.value !== link) join.value = link;
  for (const part of document.querySelectorAll<HTMLElement>(".of-matching")) part.hidden = !status.is_matching;
  for (const part of document.querySelectorAll<HTMLElement>(".of-questionnaire")) part.hidden = !isQuestionnaire(status);
  for (const part of document.querySelectorAll<HTMLElement>(".of-adaptive")) part.hidden = !status.is_adaptive;
  for (const part of document.querySelectorAll<HTMLElement>(".of-traces")) part.hidden = !status.has_traces;
  showOverview(status);
  showParticipants(status.participants);
  showAnswers(status);
}

async function refresh(): Promise<void> {
  const trouble = at("trouble");
  try {
    const answer = await fetch("status.json", { cache: "no-store" });
    if (!answer.ok) throw new Error(`the server answers ${answer.status}`);
    const status = (await answer.json()) as LabStatus;
    show(status);
    setText(trouble, status.trouble !== ""
      ? `Answers cannot be kept; participants' pages try again: ${status.trouble}`
      : "The disk is full: deleted answers are still in the log of the file of answers (-wal). "
        + "They are overwritten when the next answer can be stored.");
    trouble.hidden = status.trouble === "" && !status.has_erased_log;
  } catch {
    setText(trouble, "The server cannot be reached; what is below may be old. "
      + "Answers that were given are kept; start mien study serve again to go on.");
    trouble.hidden = false;
  }
  setTimeout(refresh, refreshMilliseconds);
}

/** Deletes the answers of a participant, after asking once more. */
async function withdraw(): Promise<void> {
  const field = at("withdrawn") as HTMLInputElement;
  const participant = field.value.trim();
  if (!participant || !confirm(`Delete all answers of ${participant}? This cannot be undone.`)) return;
  const note = at("withdrawal-said");
  try {
    const answer = await fetch("withdrawal", { method: "POST", headers: { "Content-Type": "application/json" },
      body: JSON.stringify({ participant }) });
    const said = (await answer.json()) as { participant?: string; erased?: number; wrong?: string };
    note.textContent = answer.ok ? `${said.participant}: ${said.erased} ${said.erased === 1 ? "record" : "records"} deleted.` : `Not deleted: ${said.wrong}.`;
    if (answer.ok) field.value = "";
  } catch {
    note.textContent = "Not deleted: the server cannot be reached.";
  }
}

at("withdrawal").addEventListener("submit", (event) => {
  event.preventDefault();
  void withdraw();
});
at("unopened").addEventListener("click", () => {
  listsUnopened = !(listsUnopened ?? false);
  showParticipants(shownLast);
});
at("copy-join").addEventListener("click", () => void copy(join.value, at("copy-join")));
join.addEventListener("focus", () => join.select());
void refresh();
