"use strict";
// The experimenter's page. Texts of participants and manifests come in as text, never as HTML.

const refresh_ms = 3000;
const states = {
  waiting: "not come yet", opened: "opened, not agreed", here: "here", away: "away", done: "done", refused: "refused",
};

const at = (id) => document.getElementById(id);

function element(name, text, css) {
  const made = document.createElement(name);
  if (text !== undefined) made.textContent = text;
  if (css) made.className = css;
  return made;
}

function drawn(name, attributes, text) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

/** Without touching the page where nothing has changed: what is selected or focused stays. */
function set_text(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

const whole_link = (link) => new URL(link, location.href).href;

async function copy(text, button) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const field = element("textarea", text, "hidden");
    document.body.append(field);
    field.select();
    document.execCommand("copy");  // where the page is not from this machine and not over TLS
    field.remove();
    button.focus();
  }
  const before = button.textContent;
  button.textContent = "Copied";
  at("said").textContent = "Copied";
  setTimeout(() => { button.textContent = before; at("said").textContent = ""; }, 1500);
}

function seen_text(seconds) {
  if (seconds === null) return "";
  if (seconds < 60) return "just now";
  if (seconds < 3600) return `${Math.floor(seconds / 60)} min ago`;
  return `${Math.floor(seconds / 3600)} h ago`;
}

const page_names = { consent: "consent", demographics: "questions about the person", ending: "end" };
const page_text = (name) => page_names[name] ?? name.replace("trial-", "trial ");

function show_overview(status) {
  const count = (state) => status.participants.filter((one) => one.state === state).length;
  const answers = status.histograms.reduce((sum, one) => sum + one.answers, 0);
  const numbers = [["Planned", status.planned], ["Here now", count("here")], ["Done", count("done")],
    ["Away", count("away")], ["Refused", count("refused")],
    ...(status.is_matching ? [] : [["Answers", answers]])];
  const list = at("overview");
  if (list.children.length !== numbers.length)
    list.replaceChildren(...numbers.map(() => {
      const pair = element("div");
      pair.append(element("dt"), element("dd"));
      return pair;
    }));
  numbers.forEach(([name, number], index) => {
    const [term, value] = list.children[index].children;
    set_text(term, name);
    set_text(value, String(number));
  });
}

function new_row(participant) {
  const row = element("tr");
  const name = element("th", participant.participant);
  name.scope = "row";
  const state = element("td");
  state.append(element("span"));
  const progress = element("td");
  const bar = element("progress");
  bar.setAttribute("aria-label", `Progress of ${participant.participant}`);
  progress.append(bar, element("span", "", "count"));
  const link = element("td");
  const button = element("button", "Copy");
  button.type = "button";
  button.setAttribute("aria-label", `Copy the link of ${participant.participant}`);
  button.addEventListener("click", () => copy(whole_link(participant.link), button));
  link.append(button);
  row.append(name, state, progress, element("td"), element("td"), link);
  return row;
}

const rows = new Map();
const order = ["here", "away", "opened", "waiting", "done", "refused"];

function show_participant(participant) {
  const row = rows.get(participant.participant) ?? new_row(participant);
  rows.set(participant.participant, row);
  const [, state, progress, now, seen] = row.children;
  set_text(state.firstChild, states[participant.state] ?? participant.state);
  state.firstChild.className = `state ${participant.state}`;
  const [bar, count] = progress.children;
  bar.max = participant.records;
  bar.value = participant.kept;
  set_text(count, `${participant.kept} of ${participant.records}`);
  const is_under_way = participant.state === "here" || participant.state === "away";
  set_text(now, is_under_way ? page_text(participant.next) : "");
  set_text(seen, seen_text(participant.seen_seconds_ago));
  return row;
}

/** Those who are here come first. */
function show_participants(participants) {
  const place = ({ state }) => order.indexOf(state);
  const sorted = [...participants].sort((one, other) => place(one) - place(other));
  const body = at("participants");
  sorted.map(show_participant).forEach((row, index) => {
    if (body.children[index] !== row) body.insertBefore(row, body.children[index] ?? null);
  });
}

function histogram(one) {
  const figure = element("figure");
  const caption = element("figcaption", one.is_pair ? `${one.item} (which of two)` : one.item);
  const mean = one.mean === null ? "" : `, mean ${one.mean.toFixed(2)}`;
  caption.append(element("small", `${one.answers} ${one.answers === 1 ? "answer" : "answers"}${mean}`));
  figure.append(caption);
  if (!one.bins.length) return figure;
  const width = 260, height = 110, base = 92, top = 16;
  const most = Math.max(1, ...one.bins.map(({ count }) => count));
  const step = width / one.bins.length;
  const told = one.bins.map(({ label, count }) => `${label}: ${count}`).join(", ");
  const picture = drawn("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": told });
  one.bins.forEach(({ label, count }, index) => {
    const tall = (count / most) * (base - top);
    const middle = (index + 0.5) * step;
    picture.append(
      drawn("rect", { x: index * step + step * 0.1, y: base - tall, width: step * 0.8,
        height: Math.max(tall, 1), rx: 2 }),
      drawn("text", { x: middle, y: base - tall - 4 }, String(count)));
    if (one.bins.length <= 10) {
      const short = label.length > step / 6 ? `${label.slice(0, Math.floor(step / 6) - 1)}…` : label;
      picture.append(drawn("text", { x: middle, y: height - 4, class: "label" }, short));
    }
  });
  figure.append(picture);
  if (one.low || one.high) {
    const poles = element("div", undefined, "poles");
    poles.append(element("span", one.low), element("span", one.high));
    figure.append(poles);
  }
  return figure;
}

let drawn_histograms = "";

function show_answers(status) {
  const { passed, failed } = status.checks;
  set_text(at("checks"), passed + failed === 0
    ? "Practice, warm-up and checks are not counted here."
    : `Practice, warm-up and checks are not counted here. Attention checks: ${passed} passed, ${failed} failed.`);
  const now = JSON.stringify(status.histograms);
  if (now === drawn_histograms) return;
  drawn_histograms = now;
  at("histograms").replaceChildren(...status.histograms.map(histogram));
}

function show(status) {
  document.title = `${status.study}: laboratory`;
  set_text(at("title"), status.title);
  set_text(at("about"), `Study ${status.study}, design ${status.design.slice(0, 8)}`);
  const link = whole_link(status.join);
  if (at("join").value !== link) at("join").value = link;
  for (const part of document.querySelectorAll(".of-matching")) part.hidden = !status.is_matching;
  for (const part of document.querySelectorAll(".of-questionnaire")) part.hidden = status.is_matching;
  show_overview(status);
  show_participants(status.participants);
  show_answers(status);
}

async function refresh() {
  const trouble = at("trouble");
  try {
    const answer = await fetch("status.json", { cache: "no-store" });
    if (!answer.ok) throw new Error(`the server answers ${answer.status}`);
    const status = await answer.json();
    show(status);
    set_text(trouble, `Answers cannot be kept; participants' pages try again: ${status.trouble}`);
    trouble.hidden = status.trouble === "";
  } catch (error) {
    set_text(trouble, "The server cannot be reached; what is below may be old. " +
      "Answers that were given are kept; start mien study serve again to go on.");
    trouble.hidden = false;
  }
  setTimeout(refresh, refresh_ms);
}

at("copy-join").addEventListener("click", () => copy(at("join").value, at("copy-join")));
at("join").addEventListener("focus", () => at("join").select());
refresh();
