import { button, element } from "../questionnaire/elements";
import { charactersOf, figureOfText, figureText } from "./figures";
import { choice, labelled } from "./fields";
import { heat } from "./heat";
import { keepBuilt } from "./kept";
import { listPanel } from "./list_panel";
import { lookPanel } from "./look_panel";
import { modifyPanel } from "./modify_panel";
import { motionPanel } from "./motion_panel";
import { renderPanel } from "./render_panel";
import { Refusal, sentenceOf } from "./refusal";
import { loadStudio } from "./server";
import { StageView } from "./stage_view";
import { Studio } from "./studio";
import { timeline } from "./timeline";
import { topBar } from "./top_bar";
import { yamlPanel } from "./yaml_panel";

/** Panels of which one is shown, with a tab each. */
function tabs(panels: [string, HTMLElement][]): HTMLElement {
  const bar = element("div", { class: "tabs", role: "tablist" });
  const choose = (chosen: string): void => {
    for (const [name, panel] of panels) panel.hidden = name !== chosen;
    for (const tab of bar.children) tab.setAttribute("aria-selected", String(tab.textContent === chosen));
    panels.find(([name]) => name === chosen)?.[1].dispatchEvent(new Event("shown"));
  };
  for (const [name] of panels) {
    const tab = element("button", { type: "button", role: "tab" }, name);
    tab.addEventListener("click", () => choose(name));
    bar.append(tab);
  }
  choose(panels[0]![0]);
  return element("aside", { class: "side" }, bar, ...panels.map(([, panel]) => panel));
}

/** What the motion may be held against. */
const othersOf = (studio: Studio): string[] => studio.names().filter((name) => name !== studio.selected);

/** What the stage shows, and how. */
function stageBar(studio: Studio, stage: StageView): HTMLElement {
  const play = button("Pause", () => stage.toggle(), "small play");
  setInterval(() => {
    const text = stage.plays() ? "Pause" : "Play";
    if (play.textContent !== text) play.textContent = text;
  }, 100);
  play.title = "Space";
  const against = element("span");
  const arrangement = choice(["beside", "over"], "beside", (name) => stage.arrange(name as "beside" | "over"),
    (name) => (name === "over" ? "superimposed" : "side by side"));
  arrangement.setAttribute("aria-label", "arrangement");
  const hot = element("input", { type: "checkbox" });
  hot.checked = true;
  hot.addEventListener("change", () => stage.setHeat(hot.checked));
  const heatField = element("label", { class: "check", title: "joints coloured by distance" }, hot, "heat");
  const distance = element("span", { class: "distance", role: "status" });
  const figure = element("span");
  const offer = (): void => {
    const names = ["", ...studio.words.bodies, ...charactersOf(studio)];
    const select = choice(names, figureText(studio.shownOn), (name) => studio.showOn(figureOfText(name)),
      (name) => (name ? name.replace(/^character (.*\/)?/, "") : "as in the look"));
    select.name = "shown-on";
    figure.replaceChildren(labelled("Figure", select, "for this page only; see Look for what films show"));
  };
  const offerMotions = (): void => {
    const select = choice(["", ...othersOf(studio)], studio.against, (name) => studio.compareWith(name),
      (name) => name || "nothing");
    select.name = "against";
    against.replaceChildren(labelled("Against", select));
    arrangement.hidden = heatField.hidden = !studio.against;
  };
  const tell = (): void => {
    const found = studio.made?.distance;
    distance.textContent = found ? `D ${found.D.toFixed(4)} m` : "";
    distance.style.setProperty("--heat", found ? heat(found.D) : "transparent");
    distance.title = found ? `mean distance of joints; D_sum ${found.D_sum.toFixed(2)} m` : "";
  };
  keepBuilt(studio, () => [charactersOf(studio), studio.shownOn], offer);
  keepBuilt(studio, () => [studio.against, othersOf(studio)], offerMotions);
  studio.on((change) => (change === "motion" || change === "selection") && tell());
  tell();
  return element("div", { class: "stage-bar" }, play, figure, against, arrangement, heatField, distance);
}

/** Faults of the draft, or what is to be said of the motion. */
function findings(studio: Studio): HTMLElement {
  const told = element("div", { class: "findings", "aria-live": "polite" });
  const build = (): void => {
    if (studio.faults.length > 0) {
      told.replaceChildren(...studio.faults.map((fault) => element("p", { class: "wrong" }, sentenceOf(fault))));
      return;
    }
    const { made } = studio;
    const lines = !made ? [] : [
      ...made.findings.map((one) => element("p", { class: one.is_error ? "wrong" : "doubtful" },
        `${one.sentence} (${one.check}${one.joint ? `, ${one.joint}` : ""}, frames ${one.first}–${one.last})`)),
      ...made.warnings.map((text) => element("p", { class: "doubtful" }, text)),
      ...made.notes.map((text) => element("p", { class: "quiet" }, text)),
    ];
    told.replaceChildren(...lines.length > 0 ? lines : [element("p", { class: "quiet" }, "No lint findings.")]);
  };
  studio.on((change) => (change === "motion" || change === "faults") && build());
  return told;
}

/** Keys that work wherever nothing is typed. */
function letKeys(studio: Studio, stage: StageView, save: () => Promise<void>): void {
  const go = (by: number): void => {
    const ids = studio.document().stimuli.map((one) => one.id);
    const at = ids.indexOf(studio.selected) + by;
    if (ids[at] !== undefined) studio.select(ids[at]!);
  };
  addEventListener("keydown", (event) => {
    const isCommand = event.ctrlKey || event.metaKey;
    const key = event.key.toLowerCase();
    const typed = event.target instanceof HTMLElement && event.target.matches("input:not([type=range]):not([type=checkbox]), textarea");
    if (isCommand && key === "s") void save();
    else if (isCommand && key === "z" && !typed) (event.shiftKey ? studio.redo() : studio.undo());
    else if (isCommand && key === "y" && !typed) studio.redo();
    else if (event.altKey && key === "arrowup") go(-1);
    else if (event.altKey && key === "arrowdown") go(1);
    else if (key === " " && !typed && !(event.target as HTMLElement).closest("button, select")) stage.toggle();
    else return;
    event.preventDefault();
  });
  addEventListener("beforeunload", (event) => studio.hasChanges() && event.preventDefault());
}

async function begin(): Promise<void> {
  const place = document.getElementById("studio")!;
  try {
    const studio = new Studio(await loadStudio());
    document.title = `${studio.file} – mien studio`;
    const stage = new StageView(studio);
    const top = topBar(studio);
    place.replaceChildren(top.element,
      element("div", { class: "work" },
        listPanel(studio),
        element("main", {}, stageBar(studio, stage), stage.element, timeline(studio, stage), findings(studio)),
        tabs([["Motion", motionPanel(studio)], ["Modify", modifyPanel(studio)], ["Look", lookPanel(studio)],
          ["Render", renderPanel(studio, stage)], ["YAML", yamlPanel(studio)]])));
    letKeys(studio, stage, top.save);
    (globalThis as { studio?: unknown }).studio = { studio, stage };
    studio.remake();
    await studio.findPlaces();
  } catch (error) {
    const text = error instanceof Refusal ? error.message : String(error);
    place.replaceChildren(element("p", { class: "wrong", role: "alert" }, text));
  }
}

void begin();
