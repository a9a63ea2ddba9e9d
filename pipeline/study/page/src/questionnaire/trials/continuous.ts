// A film, rated on one scale while it plays: the answer is the trace of a marker.

import { polesOf, type Asked } from "../answers";
import { element } from "../elements";
import type { Experiment, Trial } from "../experiment";
import { Marker } from "../marker";
import type { Texts } from "../texts";
import { meanOfTrace, TraceNotes } from "../trace";
import type { Asking, TraceFilm, TrialKind } from "./trial_kind";

/** Notes the marker at every frame of the screen while the film plays. */
function traceOf(item: string, flipped: boolean, film: TraceFilm, { trial, experiment, answered }: Asking): Asked {
  const { low, high, continuous } = experiment.items[item]!;
  const { seconds } = experiment.media[trial.media[0]!]!;
  const [left, right] = flipped ? [high, low] : [low, high];
  const lowEnd = flipped ? 100 : 0;
  const start = continuous!.start === "low" ? lowEnd : 50;
  const notes = new TraceNotes();
  let beganAt = 0;
  let firstMove: number | null = null;
  let trace: string | null = null;
  const marker = new Marker(`${left} – ${right}`, { ...continuous!, start }, () => {
    if (film.isPlaying()) firstMove ??= performance.now();
  });
  const mark = element("span", { class: "start-mark", "aria-hidden": "true" });
  mark.style.setProperty("--place", String(start));
  const root = element("div", { class: "asked marked" }, polesOf(left, right),
    element("div", { class: "marker-track" }, mark, marker.input));

  const keep = () => {
    notes.note(seconds, marker.value);
    trace = notes.text(seconds);
    marker.stop();
    answered(asked, false);
  };
  const follow = (now: number) => {
    if (trace !== null) return;
    if (!root.isConnected) return marker.stop();
    marker.tick(now);
    if (film.hasEnded()) return keep();
    if (film.isPlaying()) notes.note(Math.min(film.time(), seconds), marker.value);
    requestAnimationFrame(follow);
  };
  film.onBegin(() => {
    notes.clear();
    marker.reset();
    notes.note(0, start);
    beganAt = performance.now();
    firstMove = null;
    marker.input.focus({ preventScroll: true });
  });
  requestAnimationFrame(() => requestAnimationFrame(follow));  // once the page is shown

  const asked: Asked = {
    root,
    focus: () => marker.input.focus(),
    answer: () => {
      if (trace === null && film.hasEnded()) keep();
      return trace === null ? null : { item, value_raw: trace, at: performance.now(),
        rt_ms: firstMove === null ? null : Math.max(0, Math.round(firstMove - beganAt)) };
    },
    lack: () => (film.hasEnded() ? null : "play"),
  };
  return asked;
}

/** Says which scale is rated from this trial on; "" where it is that of the trials before. */
export function changedScale(
  earlier: Trial[], { kind, items: [asked] }: Trial, experiment: Experiment, texts: Texts): string {
  const former = [...earlier].reverse().find((one) => one.kind === kind)?.items[0]?.item;
  if (kind !== "continuous" || !asked || former === undefined || former === asked.item) return "";
  const { low, high } = experiment.items[asked.item]!;
  return texts.scaleNow(asked.flipped ? { low: high, high: low } : { low, high });
}

export const continuous: TrialKind = {
  ask: (asking) => asking.trial.items.map(({ item, flipped }) => traceOf(item, flipped, asking.film!, asking)),

  question({ items: [first] }, experiment, texts) {
    const { low = "", high = "" } = experiment.items[first?.item ?? ""] ?? {};
    return texts.rateContinuous(first?.flipped ? { low: high, high: low } : { low, high });
  },

  missingText: (_missing, texts, stage) => (stage?.isPlaying?.(0) ? texts.rateNow : texts.rateWhilePlaying),

  /** The mean after the lead, towards the high end. */
  meaning(trial, { item: id }, raw, experiment) {
    const flipped = trial.items.find(({ item }) => item === id)?.flipped ?? false;
    const mean = meanOfTrace(raw, experiment.items[id]?.continuous?.lead ?? 0);
    const value = mean === null ? "" : String(Number((flipped ? 100 - mean : mean).toFixed(6)));
    return { value, pole_left: flipped ? "high" : "low" };
  },
};
