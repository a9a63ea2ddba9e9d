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
const headRadius = 0.092;

const thicknessOf = (joint: string, style: BodyStyle): [number, number] =>
  style === "stick" ? stick : thickness[joint.replace(/^(Left|Right)/, "")] ?? plain;

/** "left", "right" or neither: figures are shaded by it. */
export const sideOf = (joint: string): string =>
  joint.startsWith("Left") ? "left" : joint.startsWith("Right") ? "right" : "";

/** A body as big as its legs say, beside the one that the radii are of. */
function scaleOf(body: Body): number {
  const length = (joint: string): number => {
    const at = body.names.indexOf(joint);
    return at < 0 ? 0 : Math.hypot(...body.offsets[at]!);
  };
  const legs = length("LeftKnee") + length("LeftAnkle");
  return legs > 0 ? Math.min(4, Math.max(0.2, legs / 0.84)) : 1;
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

/** What a joint carries, in its own frame: its ball and the bones to its children or its tip. */
export function jointShape(body: Body, joint: number, style: BodyStyle = "mannequin"): BufferGeometry {
  const scale = scaleOf(body);
  const radii = (of: number) =>
    thicknessOf(body.names[of]!, style).map((radius) => radius * scale) as [number, number];
  const [near, far] = radii(joint);
  const parent = body.parents[joint]!;
  const here = new Vector3();
  // Its ball closes the bone that ends in it, too.
  const parts = [ball(Math.max(near, parent < 0 ? 0 : radii(parent)[1]))];
  body.parents.forEach((other, child) => {
    if (other === joint)
      parts.push(...bone(here, new Vector3(...body.offsets[child]!), style === "stick" ? far : near, far));
  });
  if (body.tips[joint]) {
    const tip = new Vector3(...body.tips[joint]!);
    if (body.names[joint] === "Head") parts.push(...head(tip, scale));
    else parts.push(...bone(here, tip, near, 0.8 * far), ball(0.8 * far, tip));
  }
  const shape = mergeGeometries(parts.map((part) => {
    part.deleteAttribute("uv");
    return part;
  }));
  if (!shape) throw new Error("a joint without a shape");
  return shape;
}
