import { button, element } from "../questionnaire/elements";
import { choice, labelled } from "./fields";
import { Refusal } from "./refusal";
import { beginJob, cancelJob, jobResult, jobTold, type Job } from "./server";
import { secondsOf } from "../figure/playing";
import type { StageView } from "./stage_view";
import type { Studio } from "./studio";

/** Stills and videos by the real renderer. */
export function renderPanel(studio: Studio, stage: StageView): HTMLElement {
  const panel = element("section", { class: "panel", "aria-label": "Render" });
  let quality = "draft";
  let running: Job | null = null;
  const bar = element("progress", { max: "1", value: "0" });
  const told = element("p", { class: "told", role: "status" });
  const shown = element("div", { class: "result" });
  const stop = button("Stop", () => running && void cancelJob(running.job));
  stop.hidden = bar.hidden = true;

  const watch = async (job: Job): Promise<void> => {
    running = job;
    stop.hidden = bar.hidden = false;
    while (running.state === "running") {
      bar.value = running.share;
      told.textContent = `${running.kind} of ${running.stimulus}: ${Math.round(100 * running.share)} %`;
      await new Promise((resolve) => setTimeout(resolve, 250));
      running = await jobTold(job.job);
    }
    stop.hidden = bar.hidden = true;
    showResult(running, told, shown);
  };
  const watched = async (begun: () => Promise<Job>): Promise<void> => {
    told.textContent = "";
    try {
      await watch(await begun());
    } catch (error) {
      stop.hidden = bar.hidden = true;
      told.textContent = error instanceof Refusal ? error.message : String(error);
    }
  };
  const begin = (kind: "still" | "video"): Promise<void> => watched(() => {
    const motion = studio.made?.motion;
    return beginJob(studio.document(), {
      kind, stimulus: studio.selected, seconds: motion ? stage.phase() * secondsOf(motion) : 0,
      quality: quality === "manifest" ? "" : quality,
    });
  });
  panel.append(
    labelled("Quality", choice(["draft", "standard", "final", "manifest"], quality, (name) => {
      quality = name;
    }, (name) => (name === "manifest" ? "as in the manifest" : name))),
    element("div", { class: "row" }, button("Still of this frame", () => void begin("still"), "main"),
      button("Video", () => void begin("video"), "main"), stop),
    bar, told, shown,
    element("p", { class: "quiet" }, "Rendered as by mien run, from the current state, saved or not. "
      + "Equalization with the study's other films (equalize) is not applied."));
  const { jobBefore: jobBefore } = studio;
  if (jobBefore) void watched(() => Promise.resolve(jobBefore));
  return panel;
}

function showResult(job: Job, told: HTMLElement, shown: HTMLElement): void {
  if (job.state !== "done") {
    told.textContent = job.state === "cancelled" ? "Stopped." : job.told;
    return;
  }
  told.textContent = `Saved to ${job.told}`;
  const source = jobResult(job.job);
  const made = job.kind === "still"
    ? element("img", { src: source, alt: `still of ${job.stimulus}` })
    : element("video", { src: source, controls: "", loop: "", muted: "" });
  shown.replaceChildren(made);
}
