import {
  CapsuleGeometry, CylinderGeometry, Matrix4, Quaternion, SphereGeometry, Vector3, type BufferGeometry,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { LiveInfo } from "../live/core";

export type Body = LiveInfo["body"];

/** Radii at a stature of 1.75 m, metres: of the joint, and of its bone at the far end. */
const thickness: Record<string, [number, number]> = {
  Pelvis: [0.062, 0.058], Spine: [0.058, 0.062], Chest: [0.064, 0.036], Neck: [0.034, 0.034],
  Head: [0.036, 0.036], Clavicle: [0.036, 0.042], Shoulder: [0.044, 0.033], Elbow: [0.035, 0.025],
  Wrist: [0.027, 0.024], Hip: [0.06, 0.043], Knee: [0.046, 0.031], Ankle: [0.034, 0.026],
};
const plain: [number, number] = [0.027, 0.02];
const headRadius = 0.092;
/** From the knuckle to the tip: of each joint, and of the tip. */
const thumbRadii = [0.0125, 0.011, 0.0098, 0.008];
const fingerRadii = [0.0108, 0.0093, 0.0084, 0.0072];
const palmBoneRadius = 0.014;
const statureOfRadii = 1.75;

const fingerName = /^(?:Left|Right)(Thumb|Index|Middle|Ring|Little)([123])$/;

/** Of a finger's joint: the radii of the joint and of the next one, or the tip; null for other joints. */
function fingerThickness(joint: string): [number, number] | null {
  const found = fingerName.exec(joint);
  if (!found) return null;
  const segment = Number(found[2]) - 1;
  const radii = found[1] === "Thumb" ? thumbRadii : fingerRadii;
  return [radii[segment]!, radii[segment + 1]!];
}

const thicknessOf = (joint: string): [number, number] =>
  fingerThickness(joint) ?? thickness[joint.replace(/^(Left|Right)/, "")] ?? plain;

/** Hips and clavicles branch off the trunk: the bone to them has their own thickness. */
const branches = (joint: string): boolean => /(Hip|Clavicle)$/.test(joint);

/** "left", "right" or neither: figures are shaded by it. */
export const sideOf = (joint: string): string =>
  joint.startsWith("Left") ? "left" : joint.startsWith("Right") ? "right" : "";

/** Beside the body that the radii are of, as in films (motion::standing_height). */
function scaleOf(body: Body): number {
  const heights: number[] = [];
  let lowest = 0;
  let highest = 0;
  body.offsets.forEach((offset, joint) => {
    const parent = body.parents[joint]!;
    heights.push(parent < 0 ? 0 : heights[parent]! + offset[1]!);
    if (fingerName.test(body.names[joint]!)) return;
    const tip = heights[joint]! + (body.tips[joint]?.[1] ?? 0);
    lowest = Math.min(lowest, heights[joint]!, tip);
    highest = Math.max(highest, heights[joint]!, tip);
  });
  return highest > lowest ? Math.min(4, Math.max(0.2, (highest - lowest) / statureOfRadii)) : 1;
}

const up = new Vector3(0, 1, 0);

const ball = (radius: number, at = new Vector3()): BufferGeometry =>
  new SphereGeometry(radius, 12, 9).translate(at.x, at.y, at.z);

/** Open at both ends, which lie at `from` and `to`; nothing where these are one. */
function bone(from: Vector3, to: Vector3, near: number, far: number): BufferGeometry[] {
  const way = to.clone().sub(from);
  const length = way.length();
  if (length < 1e-4) return [];
  const turn = new Quaternion().setFromUnitVectors(up, way.clone().divideScalar(length));
  const middle = from.clone().addScaledVector(way, 0.5);
  return [new CylinderGeometry(far, near, length, 12, 1, true)
    .applyMatrix4(new Matrix4().compose(middle, turn, new Vector3(1, 1, 1)))];
}

/** A head under its tip, with a bar before the eyes that tells where it looks. */
function head(tip: Vector3, scale: number): BufferGeometry[] {
  const radius = Math.min(headRadius * scale, 0.6 * tip.length());
  const along = tip.clone().normalize();
  const from = along.clone().multiplyScalar(0.4 * radius);
  const to = tip.clone().addScaledVector(along, -radius);
  const eyes = to.clone().add(new Vector3(0, 0, 0.84 * radius));
  const visor = new CapsuleGeometry(0.24 * radius, 0.88 * radius, 4, 10);
  visor.rotateZ(Math.PI / 2).translate(eyes.x, eyes.y, eyes.z);
  return [...bone(from, to, 0.82 * radius, radius), ball(radius, to), visor];
}

/** The tip of a finger's last bone, which ends where its surface does. */
const bluntTip = (tip: Vector3, radius: number): Vector3 =>
  tip.clone().addScaledVector(tip.clone().normalize(), -radius);

/** The bones to a joint's children: what is thick is scaled. */
function bonesOf(body: Body, joint: number, scale: number): BufferGeometry[] {
  const here = new Vector3();
  const [near, far] = thicknessOf(body.names[joint]!);
  const bones: BufferGeometry[] = [];
  body.parents.forEach((parent, child) => {
    if (parent !== joint) return;
    const name = body.names[child]!;
    const [own] = thicknessOf(name);
    let radii = [near, far];
    if (branches(name)) radii = [own, own];
    if (fingerName.test(name)) radii = [fingerName.test(body.names[joint]!) ? near : palmBoneRadius, own];
    bones.push(...bone(here, new Vector3(...body.offsets[child]!), radii[0]! * scale, radii[1]! * scale));
  });
  return bones;
}

/** What a joint carries at its tip, if it has one. */
function endOf(body: Body, joint: number, scale: number): BufferGeometry[] {
  const name = body.names[joint]!;
  const hasFingers = body.parents.some((parent, child) => parent === joint && fingerName.test(body.names[child]!));
  if (!body.tips[joint] || (hasFingers && !fingerName.test(name))) return [];
  const tip = new Vector3(...body.tips[joint]!);
  if (name === "Head") return head(tip, scale);
  const [near, far] = thicknessOf(name).map((radius) => radius * scale) as [number, number];
  const end = fingerName.test(name) ? bluntTip(tip, far) : tip;
  return [...bone(new Vector3(), end, near, far), ball(far, end)];
}

/** What a joint carries, in its own frame: its ball and the bones to its children or its tip, as in films
    (scenes/figures/stick_figure.cpp). */
export function jointShape(body: Body, joint: number): BufferGeometry {
  const scale = scaleOf(body);
  const [near] = thicknessOf(body.names[joint]!);
  const parent = body.parents[joint]!;
  const isBranch = parent < 0 || branches(body.names[joint]!) || fingerName.test(body.names[joint]!);
  // Its ball closes the bone that ends in it, too.
  const radius = Math.max(near, isBranch ? 0 : thicknessOf(body.names[parent]!)[1]);
  const parts = [ball(radius * scale), ...bonesOf(body, joint, scale), ...endOf(body, joint, scale)];
  const shape = mergeGeometries(parts.map((part) => {
    part.deleteAttribute("uv");
    return part;
  }));
  if (!shape) throw new Error("a joint without a shape");
  return shape;
}
