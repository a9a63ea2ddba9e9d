import type { LevelAnswer, QuestEnd, QuestGrid } from "../experiment";

/** Entropies that differ by less are equal; then the first level is shown. */
const tie = 1e-12;

const entropyTerm = (p: number): number => (p > 0 ? -p * Math.log(p) : 0);

/** What QUEST+ computes once, for all levels and all points of its grid (pipeline/base/adaptive/quest_plus.h). */
export class Quest {
  /** Of each level, the probabilities of positive and of negative answers at each point. */
  private positive: Float64Array[];
  private negative: Float64Array[];
  private outcomeEntropy: Float64Array[];
  private points: number;
  /** Of each point the level with the proportion of `end`; NaN if no level has it. */
  private thresholds: Float64Array | undefined;

  constructor(ease: number[], { location, width, guess, lapse }: QuestGrid, private end?: QuestEnd) {
    const grid = location.flatMap((alpha) => width.flatMap((beta) => guess.flatMap((gamma) =>
      lapse.map((lambda) => [alpha, beta, gamma, lambda] as const))));
    this.points = grid.length;
    const table = (value: (level: number, point: (typeof grid)[number]) => number) =>
      ease.map((level) => Float64Array.from(grid, (point) => value(level, point)));
    this.positive = table((level, [alpha, beta, gamma, lambda]) =>
      gamma + (1 - gamma - lambda) / (1 + Math.exp(-(level - alpha) / beta)));
    this.negative = table((level, [alpha, beta, gamma, lambda]) =>
      lambda + (1 - gamma - lambda) / (1 + Math.exp((level - alpha) / beta)));
    if (end) {
      this.thresholds = Float64Array.from(grid, ([alpha, beta, gamma, lambda]) => {
        const share = (end.proportion - gamma) / (1 - gamma - lambda);
        return share > 0 && share < 1 ? alpha + beta * Math.log(share / (1 - share)) : NaN;
      });
    }
    this.outcomeEntropy = this.positive.map((column, level) =>
      column.map((p, point) => entropyTerm(this.negative[level]![point]!) + entropyTerm(p)));
  }

  private posteriorAfter(answers: LevelAnswer[]): Float64Array {
    let posterior: Float64Array = new Float64Array(this.points).fill(1 / this.points);
    for (const { place, positive } of answers) {
      const column = (positive ? this.positive : this.negative)[place]!;
      const product = posterior.map((p, point) => p * column[point]!);
      const sum = product.reduce((all, p) => all + p, 0);
      posterior = product.map((p) => p / sum);
    }
    return posterior;
  }

  /** Whether a track has ended after these answers. */
  hasEnded(answers: LevelAnswer[]): boolean {
    if (!this.end || !answers.length) return false;
    return answers.length >= this.end.most_trials || this.deviationAfter(answers) <= this.end.deviation;
  }

  /** The standard deviation of the threshold, of the functions that have one. */
  private deviationAfter(answers: LevelAnswer[]): number {
    const posterior = this.posteriorAfter(answers);
    const sum = (value: (threshold: number) => number) => this.thresholds!.reduce(
      (all, threshold, point) => (Number.isNaN(threshold) ? all : all + value(threshold) * posterior[point]!), 0);
    const probability = sum(() => 1);
    const mean = sum((threshold) => threshold) / probability;
    return Math.sqrt(sum((threshold) => (threshold - mean) ** 2) / probability);
  }

  /** The place of the level with the least expected entropy after these answers. */
  placeAfter(answers: LevelAnswer[]): number {
    const posterior = this.posteriorAfter(answers);
    const mean = (column: Float64Array) => column.reduce((sum, value, point) => sum + value * posterior[point]!, 0);
    const expected = this.outcomeEntropy.map((column, level) =>
      mean(column) - entropyTerm(mean(this.negative[level]!)) - entropyTerm(mean(this.positive[level]!)));
    const least = Math.min(...expected);
    return expected.findIndex((value) => value <= least + tie);
  }
}
