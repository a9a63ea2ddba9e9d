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
/** A mannequin's limbs, or balls and thin sticks. */
export type BodyStyle = "mannequin" | "stick";
const stick: [number, number] = [0.026, 0.014];
const head_radius = 0.092;

const thickness_of = (joint: string, style: BodyStyle): [number, number] =>
  style === "stick" ? stick : thickness[joint.replace(/^(Left|Right)/, "")] ?? plain;

/** "left", "right" or neither: figures are shaded by it. */
export const side_of = (joint: string): string =>
  joint.startsWith("Left") ? "left" : joint.startsWith("Right") ? "right" : "";

/** A body as big as its legs say, beside the one that the radii are of. */
function scale_of(body: Body): number {
  const length = (joint: string): number => {
    const at = body.names.indexOf(joint);
    return at < 0 ? 0 : Math.hypot(...body.offsets[at]!);
  };
  const legs = length("LeftKnee") + length("LeftAnkle");
  return legs > 0 ? Math.min(4, Math.max(0.2, legs / 0.84)) : 1;
}

const up = new Vector3(0, 1, 0);

/** Round at both ends, which lie at `from` and `to`. */
function rounded(from: Vector3, to: Vector3, near: number, far: number): BufferGeometry[] {
  const way = to.clone().sub(from);
  const length = way.length();
  const ends = [new SphereGeometry(far, 14, 10).translate(to.x, to.y, to.z)];
  if (length < 1e-4) return ends;
  const turn = new Quaternion().setFromUnitVectors(up, way.clone().divideScalar(length));
  const middle = from.clone().addScaledVector(way, 0.5);
  const bone = new CylinderGeometry(far, near, length, 14, 1, true);
  bone.applyMatrix4(new Matrix4().compose(middle, turn, new Vector3(1, 1, 1)));
  return [bone, ...ends];
}

/** A head under its tip, with a bar before the eyes that tells where it looks. */
function head(tip: Vector3, scale: number): BufferGeometry[] {
  const radius = Math.min(head_radius * scale, 0.6 * tip.length());
  const along = tip.clone().normalize();
  const from = along.clone().multiplyScalar(0.4 * radius);
  const to = tip.clone().addScaledVector(along, -radius);
  const eyes = to.clone().add(new Vector3(0, 0, 0.84 * radius));
  const visor = new CapsuleGeometry(0.24 * radius, 0.88 * radius, 4, 10);
  visor.rotateZ(Math.PI / 2).translate(eyes.x, eyes.y, eyes.z);
  return [...rounded(from, to, 0.82 * radius, radius), visor];
}

/** What a joint carries, in its own frame: its ball and the bones to its children or its tip. */
export function joint_shape(body: Body, joint: number, style: BodyStyle = "mannequin"): BufferGeometry {
  const scale = scale_of(body);
  const [near, far] = thickness_of(body.names[joint]!, style).map((radius) => radius * scale) as [number, number];
  const here = new Vector3();
  const parts: BufferGeometry[] = [new SphereGeometry(near, 14, 10)];
  body.parents.forEach((parent, child) => {
    if (parent === joint) parts.push(...rounded(here, new Vector3(...body.offsets[child]!), style === "stick" ? far : near, far));
  });
  const tip = body.tips[joint];
  if (tip && body.names[joint] === "Head") parts.push(...head(new Vector3(...tip), scale));
  else if (tip) parts.push(...rounded(here, new Vector3(...tip), near, 0.8 * far));
  const shape = mergeGeometries(parts.map((part) => {
    part.deleteAttribute("uv");
    return part;
  }));
  if (!shape) throw new Error("a joint without a shape");
  return shape;
}
