import { button, element } from "../questionnaire/elements";
import { freeId, partsNaming, sourceOf, withNewId, type Document, type Stimulus } from "./document";
import { keepBuilt } from "./kept";
import type { Studio } from "./studio";

/** The manifest's stimuli, of which one is shown. */
export function listPanel(studio: Studio): HTMLElement {
  const list = element("ul", { class: "stimuli", "aria-label": "Stimuli" });
  const id = element("input", { type: "text", "aria-label": "id of the stimulus", spellcheck: "false", maxlength: "64" });
  const note = element("p", { class: "wrong", role: "status" });
  const say = (text: string): void => {
    note.textContent = text;
    note.dataset["of"] = studio.selected;
  };
  id.addEventListener("change", () => {
    const wanted = id.value.trim();
    say(wanted === studio.selected ? "" : hindrance(studio.document(), wanted));
    id.setAttribute("aria-invalid", String(note.textContent !== ""));
    if (note.textContent || wanted === studio.selected) {
      if (wanted === "") id.value = studio.selected;
      return;
    }
    const document = withNewId(studio.document(), studio.selected, wanted);
    studio.selected = wanted;
    studio.change(document);
  });
  const remove = button("Remove", () => {
    const gone = studio.selected;
    takeAway(studio);
    const where = partsNaming(studio.document(), gone);
    if (where.length)
      say(`${gone} is still used in ${where.join(" and ")}: remove it there, or undo (Ctrl+Z)`);
  }, "small");
  const build = (): void => {
    if (note.dataset["of"] !== studio.selected) say("");
    id.removeAttribute("aria-invalid");
    list.replaceChildren(...studio.document().stimuli.map((stimulus) => entry(studio, stimulus)));
    id.value = studio.selected;
    remove.disabled = studio.document().stimuli.length < 2;
    list.querySelector(".chosen")?.scrollIntoView({ block: "nearest" });
  };
  keepBuilt(studio, () => [studio.selected, studio.document().stimuli.map((one) => [one.id, textOf(one), one["role"]])], build);
  return element("nav", { class: "list" },
    element("h2", {}, "Stimuli"), list,
    element("label", { class: "field" }, element("span", {}, "Id"), id), note,
    element("div", { class: "row" },
      button("Duplicate", () => duplicate(studio), "small"), remove));
}

/** Why a stimulus cannot be called so; nothing where it can. */
function hindrance(document: Document, wanted: string): string {
  if (wanted === "") return "an id is needed";
  if (!/^[A-Za-z0-9][A-Za-z0-9._-]{0,63}$/.test(wanted))
    return "an id begins with a letter or digit and contains only letters, digits, '.', '_' and '-', because files are named after it";
  return document.stimuli.some((one) => one.id === wanted) ? `${wanted} already exists` : "";
}

const textOf = (stimulus: Stimulus): string => sourceOf(stimulus) + ("modify" in stimulus ? ", modified" : "");

function entry(studio: Studio, stimulus: Stimulus): HTMLLIElement {
  const isChosen = stimulus.id === studio.selected;
  const chosen = element("button", { type: "button", class: isChosen ? "stimulus chosen" : "stimulus" },
    element("span", {}, stimulus.id),
    element("span", { class: "quiet" }, textOf(stimulus)));
  if (isChosen) chosen.setAttribute("aria-current", "true");
  chosen.addEventListener("click", () => studio.select(stimulus.id));
  return element("li", { class: `role-${String(stimulus["role"] ?? "created")}` }, chosen);
}

function duplicate(studio: Studio): void {
  const document = studio.document();
  const stimulus = studio.stimulus();
  if (!stimulus) return;
  const made: Stimulus = { ...stimulus, id: freeId(document, stimulus.id) };
  const at = document.stimuli.indexOf(stimulus) + 1;
  const stimuli = [...document.stimuli.slice(0, at), made, ...document.stimuli.slice(at)];
  studio.selected = made.id;
  studio.change({ ...document, stimuli } as Document);
}

function takeAway(studio: Studio): void {
  const document = studio.document();
  const at = document.stimuli.findIndex((one) => one.id === studio.selected);
  const stimuli = document.stimuli.filter((_, i) => i !== at);
  if (stimuli.length === 0) return;
  studio.selected = stimuli[Math.min(at, stimuli.length - 1)]!.id;
  studio.change({ ...document, stimuli } as Document);
}
