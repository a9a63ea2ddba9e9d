import { isMap, mapOf, withMember, type Json, type JsonMap, type Stimulus } from "./document";
import { slider, type SliderSettings } from "./fields";
import type { Studio } from "./studio";

/** What is done to a stimulus's motion, step by step. */
export function stepsOf(stimulus: Stimulus): JsonMap[] {
  const modify = stimulus["modify"];
  if (Array.isArray(modify)) return modify.map(mapOf);
  return isMap(modify) ? [modify] : [];
}

/** One step stays a map where it was one. */
export function setSteps(studio: Studio, steps: JsonMap[], gesture = ""): void {
  const stimulus = studio.stimulus();
  if (!stimulus) return;
  const wasList = Array.isArray(stimulus["modify"]);
  const value: Json | undefined = steps.length === 0 ? undefined : steps.length === 1 && !wasList ? steps[0]! : steps;
  studio.changeStimulus(withMember(stimulus, "modify", value), gesture);
}

export function setInStep(studio: Studio, index: number, key: string, value: Json | undefined, gesture = ""): void {
  const steps = stepsOf(studio.stimulus()!);
  const made = withMember(steps[index]!, key, value);
  setSteps(studio, steps.map((one, i) => (i === index ? made : one)), gesture && `modify ${index} ${gesture}`);
}

/** The value in a step at "tempo" or "gains.low". */
export const valueAt = (step: JsonMap, path: string): Json | undefined =>
  path.split(".").reduce<Json | undefined>((value, key) => mapOf(value)[key], step);

/** Sets it there; undefined takes it away, and a map with it that would be left empty. */
export function setAt(studio: Studio, index: number, path: string, value: Json | undefined, gesture = ""): void {
  const [key, part] = path.split(".") as [string, string | undefined];
  if (part === undefined) return setInStep(studio, index, key, value, gesture);
  const map = withMember(mapOf(stepsOf(studio.stimulus()!)[index]?.[key]), part, value);
  setInStep(studio, index, key, Object.keys(map).length > 0 ? map : undefined, gesture);
}

/** A number of a step: `usual` is what it is when nobody has set it. */
export interface Amount extends Pick<SliderSettings, "least" | "most"> {
  path: string;
  title: string;
  usual: number;
  step?: number;
  unit?: string;
}

export function amountSlider(studio: Studio, index: number, amount: Amount): HTMLElement {
  const { path, usual, step, unit, ...rest } = amount;
  const given = valueAt(stepsOf(studio.stimulus()!)[index]!, path);
  const isGiven = typeof given === "number";
  const made = slider({
    ...rest, name: path.split(".").at(-1)!, step: step ?? 0.01, value: isGiven ? given : usual,
    moved: (value) => setAt(studio, index, path, value, path),
    settled: () => studio.history.endGesture(),
    ...(unit ? { unit } : {}),
    ...(isGiven ? { removed: () => setAt(studio, index, path, undefined) } : {}),
  });
  Object.assign(made.dataset, { step: String(index), path, usual: String(usual) });
  made.classList.toggle("unset", !isGiven);
  return made;
}
