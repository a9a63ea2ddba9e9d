// What the motion core answers, as bytes (motion/live/live_message.h), read.

import type { LiveDistance, LiveMotion } from "./core";

const broken = () => new Error("the motion core gave an answer that cannot be read");

function labelOf(bytes: ArrayBuffer): string {
  return String.fromCharCode(...new Uint8Array(bytes, 0, Math.min(4, bytes.byteLength)));
}

export function readMotion(bytes: ArrayBuffer): LiveMotion {
  if (bytes.byteLength < 56 || labelOf(bytes) !== "MOVE") throw broken();
  const [frames, joints, loops, keyCount, weightCount] =
    [...new Int32Array(bytes, 4, 5)] as [number, number, number, number, number];
  const places = frames * joints;
  const size = 56 + 8 * (keyCount + weightCount + 7 * places) + 2 * frames;
  if (bytes.byteLength !== size) throw broken();
  let at = 24;
  const doubles = (count: number) => {
    const part = new Float64Array(bytes, at, count);
    at += 8 * count;
    return part;
  };
  const [fps] = doubles(1) as unknown as [number];
  const displacement = [...doubles(3)] as [number, number, number];
  const keytimes = doubles(keyCount).slice();
  const weights = doubles(weightCount).slice();
  const positions = Float32Array.from(doubles(3 * places));
  const rotations = Float32Array.from(doubles(4 * places));
  const contacts = new Uint8Array(bytes, at, 2 * frames).slice();
  return { frames, fps, loops: loops === 1, displacement, positions, rotations, keytimes, weights, contacts };
}

export function readDistance(bytes: ArrayBuffer): LiveDistance {
  if (bytes.byteLength !== 8 + 8 * 33 || labelOf(bytes) !== "DIST") throw broken();
  const numbers = new Float64Array(bytes, 8, 33);
  return {
    D: numbers[0]!,
    D_sum: numbers[1]!,
    by_joint: numbers.slice(2, 22),
    by_time: numbers.slice(22),
  };
}
