import type { LevelAnswer, StaircaseRule } from "../experiment";

/**
 * The place of a staircase on the grid after these answers, and whether it has ended
 * (pipeline/base/adaptive/staircase.h): `count` is the number of places.
 */
export function staircaseAfter(
  rule: StaircaseRule, count: number, answers: LevelAnswer[]): { place: number; ended: boolean } {
  const distances = Array.from({ length: count }, (_, place) => Math.abs(place - rule.start));
  let place = distances.indexOf(Math.min(...distances));
  let [positive, negative, direction, reversals] = [0, 0, 0, 0];
  for (const answer of answers) {
    positive = answer.positive ? positive + 1 : 0;
    negative = answer.positive ? 0 : negative + 1;
    const falls = positive >= rule.positive_to_fall;
    if (!falls && negative < rule.negative_to_rise) continue;
    const next = falls ? -1 : 1;
    if (direction === -next) reversals += 1;
    direction = next;
    [positive, negative] = [0, 0];
    const moved = place + (falls ? -rule.step_down : rule.step_up);
    place = Math.min(Math.max(moved, 0), count - 1);
  }
  const isReached = (number: number, most: number) => most > 0 && number >= most;
  return { place, ended: isReached(reversals, rule.most_reversals) || isReached(answers.length, rule.most_trials) };
}
