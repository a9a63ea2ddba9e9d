import { button, element } from "../questionnaire/elements";
import type { ManifestState } from "./document";
import { Refusal } from "./refusal";
import type { Studio } from "./studio";

const noWalker = "The walker steered by arrow keys or a gamepad needs the motion core compiled for browsers, "
  + "which is missing. Stop the studio and start it with ./mien studio --walk: this compiles it once, which takes "
  + "some minutes; afterwards it opens from here.";

/** The way to the walker, or why there is none. */
function walkerLink(studio: Studio, tell: (text: string) => void): HTMLElement {
  if (!studio.hasWalker) return button("Walker…", () => tell(noWalker), "small walker");
  return element("a", { class: "button small walker", href: "walk.html", target: "_blank", rel: "noopener",
    title: "a walker steered by arrow keys or a gamepad, with sliders for moods" }, "Walker");
}

/** The manifest's name, the way back and forth, and saving. */
export function topBar(studio: Studio): { element: HTMLElement; save: () => Promise<void> } {
  const state = element("span", { class: "state", role: "status" });
  const undo = button("Undo", () => studio.undo(), "small");
  const redo = button("Redo", () => studio.redo(), "small");
  const keep = button("Save", () => void save(), "small main");
  undo.title = "Ctrl+Z";
  redo.title = "Ctrl+Shift+Z";
  keep.title = "Ctrl+S";
  const refusal = element("div", { class: "refusal", role: "alert" });
  refusal.hidden = true;

  const tell = (): void => {
    undo.disabled = !studio.history.canUndo();
    redo.disabled = !studio.history.canRedo();
    keep.disabled = !studio.hasChanges();
    state.textContent = studio.hasChanges() ? (studio.is_on_disk ? "not saved yet" : "not saved yet (new file)") : "saved";
  };
  const refuse = (text: string, ...ways: HTMLElement[]): void => {
    const close = button("Close", () => {
      refusal.hidden = true;
    }, "small");
    refusal.replaceChildren(element("p", {}, text), element("div", { class: "row" }, ...ways, close));
    refusal.hidden = false;
  };
  const walker = walkerLink(studio, refuse);
  const save = async (base?: ManifestState): Promise<void> => {
    if (!studio.hasChanges() && !base) return;
    refusal.hidden = true;
    try {
      await studio.save(base);
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      if (error.status !== 409) return refuse(`Not saved. ${error.message}`);
      const { manifest } = error.answer as { manifest: ManifestState };
      refuse(`Not saved. ${error.message}`,
        button("Overwrite it", () => void save(manifest), "small"),
        button("Reload it", () => {
          refusal.hidden = true;
          void studio.reload().catch((told: Error) => refuse(told.message));
        }, "small"));
    }
    tell();
  };
  studio.on((change) => (change === "document" || change === "saved") && tell());
  tell();
  const bar = element("header", { class: "top" },
    element("h1", { title: studio.place }, studio.file), state,
    element("div", { class: "row" }, walker, undo, redo, keep));
  return { element: element("div", { class: "head" }, bar, refusal), save: () => save() };
}
