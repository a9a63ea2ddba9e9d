import { is_map, map_of, with_member, type Json, type JsonMap, type Stimulus } from "./document";
import { slider, type SliderSettings } from "./fields";
import type { Studio } from "./studio";

/** What is done to a stimulus's motion, step by step. */
export function steps_of(stimulus: Stimulus): JsonMap[] {
  const modify = stimulus["modify"];
  if (Array.isArray(modify)) return modify.map(map_of);
  return is_map(modify) ? [modify] : [];
}

/** One step stays a map where it was one. */
export function set_steps(studio: Studio, steps: JsonMap[], gesture = ""): void {
  const stimulus = studio.stimulus();
  if (!stimulus) return;
  const was_list = Array.isArray(stimulus["modify"]);
  const value: Json | undefined = steps.length === 0 ? undefined : steps.length === 1 && !was_list ? steps[0]! : steps;
  studio.change_stimulus(with_member(stimulus, "modify", value), gesture);
}

export function set_in_step(studio: Studio, index: number, key: string, value: Json | undefined, gesture = ""): void {
  const steps = steps_of(studio.stimulus()!);
  const made = with_member(steps[index]!, key, value);
  set_steps(studio, steps.map((one, i) => (i === index ? made : one)), gesture && `modify ${index} ${gesture}`);
}

/** The value in a step at "tempo" or "gains.low". */
export const value_at = (step: JsonMap, path: string): Json | undefined =>
  path.split(".").reduce<Json | undefined>((value, key) => map_of(value)[key], step);

/** Sets it there; undefined takes it away, and a map with it that would be left empty. */
export function set_at(studio: Studio, index: number, path: string, value: Json | undefined, gesture = ""): void {
  const [key, part] = path.split(".") as [string, string | undefined];
  if (part === undefined) return set_in_step(studio, index, key, value, gesture);
  const map = with_member(map_of(steps_of(studio.stimulus()!)[index]?.[key]), part, value);
  set_in_step(studio, index, key, Object.keys(map).length > 0 ? map : undefined, gesture);
}

/** A number of a step: `usual` is what it is when nobody has set it. */
export interface Amount extends Pick<SliderSettings, "least" | "most"> {
  path: string;
  title: string;
  usual: number;
  step?: number;
  unit?: string;
}

export function amount_slider(studio: Studio, index: number, amount: Amount): HTMLElement {
  const { path, usual, step, unit, ...rest } = amount;
  const given = value_at(steps_of(studio.stimulus()!)[index]!, path);
  const is_given = typeof given === "number";
  const made = slider({
    ...rest, name: path.split(".").at(-1)!, step: step ?? 0.01, value: is_given ? given : usual,
    moved: (value) => set_at(studio, index, path, value, path),
    settled: () => studio.history.end_gesture(),
    ...(unit ? { unit } : {}),
    ...(is_given ? { removed: () => set_at(studio, index, path, undefined) } : {}),
  });
  Object.assign(made.dataset, { step: String(index), path, usual: String(usual) });
  made.classList.toggle("unset", !is_given);
  return made;
}
