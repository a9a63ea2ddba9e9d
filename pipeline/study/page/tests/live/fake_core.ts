// A motion core that needs neither WebAssembly nor a server: a body of rigid bones that swings its arms
// and legs as its sliders say. For trying pages; its motions are no walks of mien's, its D is its own.
import { Matrix4, Quaternion, Vector3 } from "three";
import type { LiveCore, LiveDistance, LiveInfo, LiveMotion, LiveSetting, Slider } from "../../src/live/core";

type Row = [name: string, parent: number, offset: number[], tip?: number[]];
const rows: Row[] = [
  ["Pelvis", -1, [0, 0, 0]], ["Spine", 0, [0, 0.11, 0]], ["Chest", 1, [0, 0.17, 0]],
  ["Neck", 2, [0, 0.24, 0]], ["Head", 3, [0, 0.1, 0], [0, 0.17, 0]],
  ["LeftClavicle", 2, [0.02, 0.18, 0]], ["LeftShoulder", 5, [0.165, 0, 0]],
  ["LeftElbow", 6, [0, -0.285, 0]], ["LeftWrist", 7, [0, -0.265, 0], [0, -0.17, 0]],
  ["RightClavicle", 2, [-0.02, 0.18, 0]], ["RightShoulder", 9, [-0.165, 0, 0]],
  ["RightElbow", 10, [0, -0.285, 0]], ["RightWrist", 11, [0, -0.265, 0], [0, -0.17, 0]],
  ["LeftHip", 0, [0.09, -0.03, 0]], ["LeftKnee", 13, [0, -0.43, 0]], ["LeftAnkle", 14, [0, -0.42, 0]],
  ["LeftToe", 15, [0, -0.06, 0.13], [0, 0, 0.06]],
  ["RightHip", 0, [-0.09, -0.03, 0]], ["RightKnee", 17, [0, -0.43, 0]], ["RightAnkle", 18, [0, -0.42, 0]],
  ["RightToe", 19, [0, -0.06, 0.13], [0, 0, 0.06]],
];

const body: LiveInfo["body"] = {
  names: rows.map(([name]) => name),
  parents: rows.map(([, parent]) => parent),
  offsets: rows.map(([, , offset]) => offset),
  tips: rows.map(([, , , tip]) => tip ?? null),
};

const slider = (name: string, primary: boolean, low: string, high: string): Slider => ({
  name, primary, low, high, mean: 0.5, texts: { ja: [`低${name}`, `高${name}`] },
});

/** Stride, arms, bow, tempo. */
const kinds = ["stride", "arms", "bow", "tempo"];
const adjectives = [
  ...["quickness", "softness", "happiness", "strength"].map((name) =>
    slider(name, true, `not ${name}`, name)),
  ...["dryness", "maleness"].map((name) => slider(name, false, `not ${name}`, name)),
];
const features = kinds.map((name) => slider(name, true, "less", "more"));
const examples = ["normal", "long", "swinging", "bowed", "quick"];

/** The four numbers behind a setting, 0 to 1. */
function numbersOf({ kind, sliders, values }: LiveSetting): number[] {
  const of = (name: string, otherwise: number) => {
    const at = sliders.indexOf(name);
    return at < 0 ? otherwise : values[at]!;
  };
  if (kind === "features") return kinds.map((name) => of(name, 0.5));
  if (kind === "adjectives") return adjectives.slice(0, 4).map(({ name }) => of(name, 0.5));
  const all = values.reduce((sum, value) => sum + value, 0) || 1;
  return examples.slice(1).map((name) => 0.2 + 0.8 * of(name, 0) / all);
}

function motionOf([stride, arms, bow, tempo]: number[]): LiveMotion {
  const fps = 30;
  const frames = Math.round(fps * (1.5 - 0.8 * tempo!));
  const walked = 0.5 + stride!;
  const positions = new Float32Array(frames * rows.length * 3);
  const rotations = new Float32Array(frames * rows.length * 4);
  const contacts = new Uint8Array(frames * 2);
  const across = new Vector3(1, 0, 0);
  for (let f = 0; f < frames; f += 1) {
    const wave = Math.sin(2 * Math.PI * f / frames);
    const bend = (side: number) => Math.max(0, Math.cos(2 * Math.PI * f / frames) * side);
    const turns: Record<string, number> = {
      Spine: 0.7 * bow!, LeftHip: -0.6 * stride! * wave, RightHip: 0.6 * stride! * wave,
      LeftKnee: 0.8 * bend(1), RightKnee: 0.8 * bend(-1),
      LeftShoulder: 0.8 * arms! * wave, RightShoulder: -0.8 * arms! * wave,
      LeftElbow: -0.4 * arms! - 0.2, RightElbow: -0.4 * arms! - 0.2,
    };
    const world: Matrix4[] = [];
    rows.forEach(([name, parent, offset], j) => {
      const turn = new Quaternion().setFromAxisAngle(across, turns[name] ?? 0);
      const at = new Vector3(...offset);
      if (parent < 0) at.set(0, 0.96 - 0.02 * Math.abs(wave), walked * f / frames);
      world[j] = new Matrix4().compose(at, turn, new Vector3(1, 1, 1));
      if (parent >= 0) world[j]!.premultiply(world[parent]!);
      new Vector3().setFromMatrixPosition(world[j]!).toArray(positions, (f * rows.length + j) * 3);
      new Quaternion().setFromRotationMatrix(world[j]!).toArray(rotations, (f * rows.length + j) * 4);
    });
    contacts[2 * f + (f < frames / 2 ? 0 : 1)] = 1;
  }
  const seconds = frames / fps;
  return {
    frames, fps, loops: true, displacement: [0, 0, walked], positions, rotations,
    keytimes: Float64Array.from([0, 0.5 * seconds, seconds]), weights: new Float64Array(), contacts,
  };
}

function distanceOf(a: LiveMotion, b: LiveMotion): LiveDistance {
  const byJoint = new Float64Array(20);
  const byTime = new Float64Array(11);
  for (let t = 0; t < 11; t += 1) {
    const at = (motion: LiveMotion, joint: number, axis: number) => {
      const frame = Math.round(t / 10 * motion.frames) % motion.frames * rows.length;
      return motion.positions[(frame + joint) * 3 + axis]! - (axis === 1 ? 0 : motion.positions[frame * 3 + axis]!);
    };
    for (let j = 1; j < 21; j += 1) {
      const apart = Math.hypot(...[0, 1, 2].map((axis) => at(a, j, axis) - at(b, j, axis)));
      byJoint[j - 1]! += apart / 11;
      byTime[t]! += apart / 20;
    }
  }
  const DSum = byJoint.reduce((sum, one) => sum + 11 * one, 0);
  return { D: DSum / 220, D_sum: DSum, by_joint: byJoint, by_time: byTime };
}

/** `targets`: their four numbers by name. */
export function openFake(targets: Record<string, number[]>): LiveCore {
  const target = (name: string): LiveMotion => {
    const numbers = targets[name];
    if (!numbers) throw new Error(`no target is called "${name}"`);
    return motionOf(numbers);
  };
  return {
    info: {
      body, examples, sliders: { adjectives, features }, targets: Object.keys(targets), foot_lock: false,
      method: "fake", fps: 30,
    },
    example: async (name) => motionOf(examples.slice(1).map((one) => (one === name ? 1 : 0.2))),
    target: async (name) => target(name),
    make: async (setting) => motionOf(numbersOf(setting)),
    distance: async (name, setting) => distanceOf(target(name), motionOf(numbersOf(setting))),
  };
}
