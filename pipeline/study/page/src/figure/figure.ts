import {
  Color, Group, Mesh, MeshLambertMaterial, Quaternion, Vector3, type Material, type Object3D,
} from "three";
import type { LiveMotion } from "../live/core";
import { jointShape, sideOf, type Body, type BodyStyle } from "./body_shape";
import { betweenFrames, middleOf, type Place } from "./playing";
import type { Skin } from "./skin";

/** Where joints of a skin's own are in the frames of a motion. */
export interface JointPoses {
  /** frames × joints × 3, world, metres. */
  positions: Float32Array;
  /** frames × joints × 4 (x, y, z, w). */
  rotations: Float32Array;
}

/** The left side is darker and the right one lighter, so that legs can be told apart. */
function shade(colour: string, side: string): Color {
  const made = new Color(colour);
  if (side === "left") made.multiplyScalar(0.7);
  if (side === "right") made.lerp(new Color("#ffffff"), 0.14);
  return made;
}

/** Where surfaces fall together, this one counts as the nearer. */
function letComeFirst(material: Material): void {
  material.polygonOffset = true;
  material.polygonOffsetFactor = -1;
  material.polygonOffsetUnits = -4;
}

/** A body of balls and bones in one colour that takes the poses of a motion, walking in place. */
export class Figure {
  readonly group = new Group();
  private joints: Group[] = [];
  private materials: MeshLambertMaterial[] = [];
  private veils: Mesh[] = [];
  private motion: LiveMotion | null = null;
  private middle: Place = { x: 0, z: 0 };
  private skin: Skin | null = null;
  private poses: JointPoses | null = null;
  private opacity = 1;
  private colours: string[] | null = null;

  constructor(private body: Body, private colour: string, style: BodyStyle = "mannequin") {
    const depthAlone = new MeshLambertMaterial({ colorWrite: false });
    letComeFirst(depthAlone);
    body.names.forEach((name, joint) => {
      const material = new MeshLambertMaterial({ color: shade(colour, sideOf(name)) });
      letComeFirst(material);
      material.polygonOffset = false;
      const shape = jointShape(body, joint, style);
      const solid = new Mesh(shape, material);
      solid.renderOrder = 2;
      // Drawn before what shines through, so that only the nearest surface does.
      const veil = new Mesh(shape, depthAlone);
      veil.renderOrder = 1;
      veil.visible = false;
      const group = new Group();
      group.add(veil, solid);
      for (const part of group.children) part.frustumCulled = false;
      this.group.add(group);
      this.joints.push(group);
      this.materials.push(material);
      this.veils.push(veil);
    });
    this.group.visible = false;
  }

  shows(): LiveMotion | null {
    return this.motion;
  }

  /** `poses`: of a skin's own joints, where they are not the body's. */
  show(motion: LiveMotion | null, poses: JointPoses | null = null): void {
    this.motion = motion;
    this.poses = poses;
    this.group.visible = motion !== null;
    if (motion) this.middle = middleOf(motion);
    this.dress();
  }

  /** Draws it as that from now on, as long as it fits what is shown; null: as balls and bones. */
  wear(skin: Skin | null): void {
    if (skin === this.skin) return;
    if (this.skin) {
      this.group.remove(this.skin.group);
      this.skin.release();
    }
    this.skin = skin;
    if (skin) {
      this.group.add(skin.group);
      skin.setOpacity(this.opacity);
      skin.paint(this.colours);
    }
    this.dress();
  }

  /** Of the skin that is worn, metres; 0: a body of about the usual height. */
  height(): number {
    return this.isDressed() ? this.skin!.height : 0;
  }

  /** Whether the skin has the joints whose places are known. */
  private isDressed(): boolean {
    const count = this.motion && this.poses
      ? this.poses.positions.length / 3 / this.motion.frames : this.joints.length;
    return this.skin !== null && this.skin.joints.length === count;
  }

  private dress(): void {
    const isDressed = this.isDressed();
    for (const joint of this.joints) joint.visible = !isDressed;
    if (this.skin) this.skin.group.visible = isDressed;
  }

  /** 1: solid. Less shines through, and is drawn after what is solid. */
  setOpacity(opacity: number): void {
    if (opacity === this.opacity) return;
    this.opacity = opacity;
    this.skin?.setOpacity(opacity);
    for (const material of this.materials) {
      material.transparent = opacity < 1;
      material.opacity = opacity;
      material.polygonOffset = opacity < 1;
      material.needsUpdate = true;
    }
    for (const veil of this.veils) veil.visible = opacity < 1;
  }

  /** Of the joints in order; null: the figure's own colour again. */
  paint(colours: string[] | null): void {
    if (!colours && !this.colours) return;
    this.colours = colours;
    this.skin?.paint(colours);
    this.materials.forEach((material, joint) => {
      const own = shade(this.colour, sideOf(this.body.names[joint]!));
      material.color.copy(colours ? new Color(colours[joint]) : own);
    });
  }

  /** How far it would have walked by then, were it not in place; metres along +Z. */
  travelled(phase: number): number {
    return this.motion ? this.motion.displacement[2] * phase : 0;
  }

  pose(phase: number): void {
    const { motion } = this;
    if (!motion) return;
    const isDressed = this.isDressed();
    this.poseJoints(motion, phase, isDressed ? this.skin!.joints : this.joints,
      (isDressed && this.poses) || motion);
  }

  private poseJoints(motion: LiveMotion, phase: number, joints: Object3D[], poses: JointPoses): void {
    const count = joints.length;
    const { frame, next, share, rounds } = betweenFrames(motion, phase);
    const [dx, dy, dz] = motion.displacement;
    const here = new Vector3();
    const there = new Vector3();
    const turn = new Quaternion();
    const turned = new Quaternion();
    joints.forEach((joint, j) => {
      here.fromArray(poses.positions, (frame * count + j) * 3);
      there.fromArray(poses.positions, (next * count + j) * 3);
      there.set(there.x + rounds * dx, there.y + rounds * dy, there.z + rounds * dz);
      joint.position.lerpVectors(here, there, share);
      joint.position.x -= dx * phase + this.middle.x;
      joint.position.z -= dz * phase + this.middle.z;
      turn.fromArray(poses.rotations, (frame * count + j) * 4);
      turned.fromArray(poses.rotations, (next * count + j) * 4);
      joint.quaternion.slerpQuaternions(turn, turned, share);
    });
  }

  /** Poses it by places and rotations in the world (joints × 3, joints × 4), of whatever motion. */
  standAs(positions: ArrayLike<number>, rotations: ArrayLike<number>): void {
    this.group.visible = true;
    this.joints.forEach((joint, j) => {
      joint.position.fromArray(positions, 3 * j);
      joint.quaternion.fromArray(rotations, 4 * j);
    });
  }

  release(): void {
    this.wear(null);
    for (const group of this.joints)
      for (const part of group.children) (part as Mesh).geometry.dispose();
    for (const material of this.materials) material.dispose();
  }
}
