import { button, element } from "../questionnaire/elements";
import { free_id, parts_naming, source_of, with_new_id, type Document, type Stimulus } from "./document";
import { keep_built } from "./kept";
import type { Studio } from "./studio";

/** The manifest's stimuli, of which one is shown. */
export function list_panel(studio: Studio): HTMLElement {
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
    const document = with_new_id(studio.document(), studio.selected, wanted);
    studio.selected = wanted;
    studio.change(document);
  });
  const remove = button("Remove", () => {
    const gone = studio.selected;
    take_away(studio);
    const where = parts_naming(studio.document(), gone);
    if (where.length)
      say(`${gone} is still named by ${where.join(" and ")}: take it out there, or undo (Ctrl+Z)`);
  }, "small");
  const build = (): void => {
    if (note.dataset["of"] !== studio.selected) say("");
    id.removeAttribute("aria-invalid");
    list.replaceChildren(...studio.document().stimuli.map((stimulus) => entry(studio, stimulus)));
    id.value = studio.selected;
    remove.disabled = studio.document().stimuli.length < 2;
    list.querySelector(".chosen")?.scrollIntoView({ block: "nearest" });
  };
  keep_built(studio, () => [studio.selected, studio.document().stimuli.map((one) => [one.id, text_of(one), one["role"]])], build);
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
    return "an id begins with a letter or digit and holds letters, digits, '.', '_' and '-': files are named after it";
  return document.stimuli.some((one) => one.id === wanted) ? `there is another ${wanted}` : "";
}

const text_of = (stimulus: Stimulus): string => source_of(stimulus) + ("modify" in stimulus ? ", modified" : "");

function entry(studio: Studio, stimulus: Stimulus): HTMLLIElement {
  const is_chosen = stimulus.id === studio.selected;
  const chosen = element("button", { type: "button", class: is_chosen ? "stimulus chosen" : "stimulus" },
    element("span", {}, stimulus.id),
    element("span", { class: "quiet" }, text_of(stimulus)));
  if (is_chosen) chosen.setAttribute("aria-current", "true");
  chosen.addEventListener("click", () => studio.select(stimulus.id));
  return element("li", { class: `role-${String(stimulus["role"] ?? "created")}` }, chosen);
}

function duplicate(studio: Studio): void {
  const document = studio.document();
  const stimulus = studio.stimulus();
  if (!stimulus) return;
  const made: Stimulus = { ...stimulus, id: free_id(document, stimulus.id) };
  const at = document.stimuli.indexOf(stimulus) + 1;
  const stimuli = [...document.stimuli.slice(0, at), made, ...document.stimuli.slice(at)];
  studio.selected = made.id;
  studio.change({ ...document, stimuli } as Document);
}

function take_away(studio: Studio): void {
  const document = studio.document();
  const at = document.stimuli.findIndex((one) => one.id === studio.selected);
  const stimuli = document.stimuli.filter((_, i) => i !== at);
  if (stimuli.length === 0) return;
  studio.selected = stimuli[Math.min(at, stimuli.length - 1)]!.id;
  studio.change({ ...document, stimuli } as Document);
}
