import type { LevelAnswer, QuestGrid } from "../experiment";

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

  constructor(ease: number[], { location, width, guess, lapse }: QuestGrid) {
    const grid = location.flatMap((alpha) => width.flatMap((beta) => guess.flatMap((gamma) =>
      lapse.map((lambda) => [alpha, beta, gamma, lambda] as const))));
    this.points = grid.length;
    const table = (value: (level: number, point: (typeof grid)[number]) => number) =>
      ease.map((level) => Float64Array.from(grid, (point) => value(level, point)));
    this.positive = table((level, [alpha, beta, gamma, lambda]) =>
      gamma + (1 - gamma - lambda) / (1 + Math.exp(-(level - alpha) / beta)));
    this.negative = table((level, [alpha, beta, gamma, lambda]) =>
      lambda + (1 - gamma - lambda) / (1 + Math.exp((level - alpha) / beta)));
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
