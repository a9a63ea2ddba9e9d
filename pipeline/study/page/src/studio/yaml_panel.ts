import { button, element } from "../questionnaire/elements";
import type { Studio } from "./studio";
import { yamlElement } from "./yaml_text";

/** The lines of the stimulus, and the manifest as it would be saved. */
export function yamlPanel(studio: Studio): HTMLElement {
  const panel = element("section", { class: "panel yaml", "aria-label": "YAML" });
  const lines = element("pre", { class: "lines", tabindex: "0", "aria-label": "lines of the stimulus" });
  const whole = element("pre", { class: "whole", tabindex: "0", "aria-label": "the manifest" });
  const told = element("span", { role: "status", class: "quiet" });
  const copy = async (of: HTMLElement): Promise<void> => {
    try {
      await navigator.clipboard.writeText(of.textContent ?? "");
      told.textContent = "Copied.";
    } catch {
      getSelection()?.selectAllChildren(of);
      told.textContent = "Selected: copy it with Ctrl+C.";
    }
  };
  panel.append(
    element("div", { class: "row" }, element("h2", {}, "This stimulus"), button("Copy", () => void copy(lines), "small"), told),
    lines,
    element("div", { class: "row" }, element("h2", {}, "Manifest, when saved"),
      button("Copy", () => void copy(whole), "small")),
    whole);
  let asked = 0;
  const load = async (): Promise<void> => {
    const turn = (asked += 1);
    await new Promise((resolve) => setTimeout(resolve, 150));
    if (turn !== asked || panel.hidden || !panel.isConnected) return;
    told.textContent = "";
    const stimulus = studio.stimulus();
    lines.textContent = stimulus ? `  ${yamlElement(stimulus, 2)}\n` : "";
    try {
      whole.textContent = studio.text();
    } catch (error) {
      whole.textContent = error instanceof Error ? error.message : String(error);
    }
  };
  studio.on((change) => (change === "document" || change === "selection" || change === "saved") && void load());
  panel.addEventListener("shown", () => void load());
  return panel;
}
