import type { LiveSetting } from "../live/core";
import type { PageRecord } from "../questionnaire/experiment";
import type { ChainSession, ChainSettings, ChainTrial, CheckSide, Dimension, SliderStart } from "./experiment";
import type { ChainRecord } from "./record";

/** What a trial shows. */
export interface Step {
  word: string;
  chain: number;
  step: number;
  person: number;
  point: number[];
  /** Of Gibbs sampling: the dimension that is free, and its slider. */
  dimension?: number;
  slider?: SliderStart;
  /** Of MCMC. */
  proposal?: number[];
  proposal_first?: boolean;
  /** Of an attention check: what it asks for. */
  expected?: CheckSide;
}

/** What the participant did. */
export type StepAnswer = Pick<ChainRecord, "value" | "chose_proposal" | "moves">;

/** A value of the real line folded into a range by reflection at both ends, as often as needed
    (pipeline/base/adaptive/choice_chain.h). */
function reflected(value: number, { low, high }: Dimension): number {
  const width = high - low;
  let place = (value - low) % (2 * width);
  if (place < 0) place += 2 * width;
  return low + (place > width ? 2 * width - place : place);
}

/** The proposal near a point, from standard normal deviates. */
const proposalAt = (point: number[], normals: number[], { dimensions, deviation }: ChainSettings): number[] =>
  dimensions.map((dimension, d) =>
    reflected(point[d]! + normals[d]! * deviation * (dimension.high - dimension.low), dimension));

/** The coordinate at a share of a range. */
export const coordinateAt = (share: number, { low, high }: Dimension): number => low + share * (high - low);

/** The point after a step. */
function pointAfter({ point, dimension, value, proposal, chose_proposal: isChosen }: ChainRecord): number[] {
  if (dimension !== undefined) return point.map((one, d) => (d === dimension ? value! : one));
  return isChosen ? proposal! : point;
}

/** The setting of the motion core for a point. */
export const settingAt = (point: number[], { kind, dimensions }: ChainSettings): LiveSetting =>
  ({ kind, sliders: dimensions.map(({ name }) => name), values: point });

/** Of the slider in attention checks, as a share of its range. */
const checkTolerance = 0.05;

/** Whether the answer to an attention check is what it asks for. */
export function passesCheck(record: ChainRecord, expected: CheckSide, { dimensions }: ChainSettings): boolean {
  const { dimension, value, reversed, chose_proposal: isChosen, proposal_first: isFirst } = record;
  if (dimension === undefined) return (isChosen === isFirst) === (expected === "left");
  const { low, high } = dimensions[dimension]!;
  const share = (value! - low) / (high - low);
  const fromLeft = reversed ? 1 - share : share;
  return (expected === "left" ? fromLeft : 1 - fromLeft) <= checkTolerance;
}

/** The step of a trial that is fixed in the plan: after the answers to earlier trials of the same chain, by the
    names of their records. */
export function plannedStep(
  settings: ChainSettings, session: ChainSession, trial: ChainTrial, records: Record<string, Pick<PageRecord, "chain">>,
): Step {
  const { word = "", chain = 1, step = 0 } = trial;
  const start = session.starts[`${trial.practice ? "practice" : word}/${chain}`];
  if (!start) throw new Error(`The plan has no start of chain ${chain} of "${word}".`);
  const [last] = trial.expected ? [] : session.trials
    .filter((one) => one.number < trial.number && one.practice === trial.practice && one.word === word && one.chain === chain)
    .sort((a, b) => b.number - a.number)
    .flatMap(({ number }) => records[`trial-${number}`]?.chain ?? []);
  const point = last ? pointAfter(last) : start;
  const shown = { word, chain, step, person: 0, point, ...(trial.expected ? { expected: trial.expected } : {}) };
  if (settings.method === "gibbs") return { ...shown, dimension: trial.dimension!, slider: trial.slider! };
  return { ...shown, proposal: proposalAt(point, trial.normals!, settings), proposal_first: trial.proposal_first! };
}

/** What is kept of a step. */
export const recordOf = (step: Step, answer: StepAnswer, attempt: number): ChainRecord => {
  const { slider, expected: _, ...shown } = step;
  return { ...shown, ...(slider ? { start: slider.start, reversed: slider.reversed } : {}), ...answer, attempt };
};
