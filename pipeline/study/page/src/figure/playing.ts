import type { LiveMotion } from "../live/core";

// When figures that play together are where in their motions. A phase runs from 0 to 1, once through.

/** How motions that play together keep together. */
export type Step =
  /** Moments that correspond fall together; the first motion's tempo is that of all. */
  | "keytimes"
  /** Each in its own tempo. */
  | "time";

/** How long a motion is that does not loop stands still before it begins again. */
const pauseSeconds = 0.7;

export const secondsOf = (motion: LiveMotion): number =>
  Math.max(1e-3, (motion.loops ? motion.frames : motion.frames - 1) / motion.fps);

/** Seconds from one beginning to the next. */
export const roundSeconds = (motion: LiveMotion): number =>
  secondsOf(motion) + (motion.loops ? 0 : pauseSeconds);

/** How far the motion is at a part of its round: that part, but for the pause. */
export const phaseInRound = (motion: LiveMotion, part: number): number =>
  Math.min(1, part * roundSeconds(motion) / secondsOf(motion));

/** The phase of a motion that corresponds to another's. */
export function correspondingPhase(from: LiveMotion, phase: number, to: LiveMotion): number {
  const marks = from.keytimes;
  const others = to.keytimes;
  if (marks.length < 2 || marks.length !== others.length) return phase;
  const at = marks[0]! + phase * (marks[marks.length - 1]! - marks[0]!);
  let k = 1;
  while (k + 1 < marks.length && at > marks[k]!) k += 1;
  const length = marks[k]! - marks[k - 1]!;
  const share = length > 0 ? (at - marks[k - 1]!) / length : 0;
  const found = others[k - 1]! + share * (others[k]! - others[k - 1]!);
  const whole = others[others.length - 1]! - others[0]!;
  return whole > 0 ? (found - others[0]!) / whole : phase;
}

/** Two frames of a motion and the way from one to the other, 0 to 1. */
export interface Between {
  frame: number;
  next: number;
  share: number;
  /** `next` is of the following round: that many displacements lie before it. */
  rounds: number;
}

export function betweenFrames(motion: LiveMotion, phase: number): Between {
  const last = motion.loops ? motion.frames : motion.frames - 1;
  const at = Math.min(Math.max(phase, 0), 1) * last;
  const frame = Math.min(Math.floor(at), motion.frames - 1);
  const ends = frame + 1 >= motion.frames;
  if (!ends) return { frame, next: frame + 1, share: at - frame, rounds: 0 };
  return motion.loops
    ? { frame, next: 0, share: at - frame, rounds: 1 }
    : { frame, next: frame, share: 0, rounds: 0 };
}

/** What a motion would have moved by evenly up to that phase, and where its root is on the average. */
export interface Place {
  x: number;
  z: number;
}

/** The middle of the root's way once the even travel is taken off it. */
export function middleOf(motion: LiveMotion): Place {
  const stride = motion.positions.length / motion.frames;
  const [alongX, , alongZ] = motion.displacement;
  let x = 0;
  let z = 0;
  for (let frame = 0; frame < motion.frames; frame += 1) {
    x += motion.positions[frame * stride]! - alongX * frame / motion.frames;
    z += motion.positions[frame * stride + 2]! - alongZ * frame / motion.frames;
  }
  return { x: x / motion.frames, z: z / motion.frames };
}
