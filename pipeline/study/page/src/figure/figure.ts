import {
  Color, Group, Mesh, MeshLambertMaterial, Quaternion, Vector3, type ColorRepresentation, type Material, type Object3D,
} from "three";
import type { LiveMotion } from "../live/core";
import { jointShape, sideOf, type Body } from "./body_shape";
import { weightsAt, type FaceFrames } from "./face";
import { betweenFrames, middleOf, secondsOf, type Place } from "./playing";
import type { Skin } from "./skin";

/** Where joints of a skin's own, or those of the body and its hands, are in the frames of a motion. */
export interface JointPoses {
  /** frames × joints × 3, world, metres. */
  positions: Float32Array;
  /** frames × joints × 4 (x, y, z, w). */
  rotations: Float32Array;
  /** Of the body and its hands. */
  hasHands: boolean;
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

/** A joint with what it carries. */
interface JointPart {
  name: string;
  /** Of the body: the joint that its colour is that of. */
  joint: number;
  group: Group;
  material: MeshLambertMaterial;
  veil: Mesh;
}

/** A body of balls and bones in one colour that takes the poses of a motion, walking in place. */
export class Figure {
  readonly group = new Group();
  private body: JointPart[];
  /** Instead of hands of one piece, where the poses have fingers: the palms, which stay on the wrists, and the joints
      that follow those of the body. */
  private palms: JointPart[] = [];
  private fingers: JointPart[] = [];
  private motion: LiveMotion | null = null;
  private middle: Place = { x: 0, z: 0 };
  private skin: Skin | null = null;
  private poses: JointPoses | null = null;
  private face: FaceFrames | null = null;
  private opacity = 1;
  private colours: ColorRepresentation[] | null = null;

  /** `handed`: the body with the joints of its hands behind its own. */
  constructor(body: Body, private colour: string, handed: Body | null = null) {
    this.body = body.names.map((_, joint) => this.partOf(body, joint, joint));
    if (handed) this.addHands(handed, body.names.length);
    this.group.visible = false;
  }

  private addHands(handed: Body, ownJoints: number): void {
    handed.names.forEach((name, joint) => {
      if (joint < ownJoints) {
        if (name.endsWith("Wrist")) this.palms.push(this.partOf(handed, joint, joint));
        return;
      }
      let own = joint;
      while (own >= ownJoints) own = handed.parents[own]!;
      this.fingers.push(this.partOf(handed, joint, own));
    });
  }

  private partOf(body: Body, shown: number, joint: number): JointPart {
    const depthAlone = new MeshLambertMaterial({ colorWrite: false });
    letComeFirst(depthAlone);
    const name = body.names[shown]!;
    const material = new MeshLambertMaterial({ color: shade(this.colour, sideOf(name)) });
    letComeFirst(material);
    material.polygonOffset = false;
    const shape = jointShape(body, shown);
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
    return { name, joint, group, material, veil };
  }

  private parts(): JointPart[] {
    return [...this.body, ...this.palms, ...this.fingers];
  }

  shows(): LiveMotion | null {
    return this.motion;
  }

  /** `poses`: where joints that are not the body's are; `face`: how the skin's face moves. */
  show(motion: LiveMotion | null, poses: JointPoses | null = null, face: FaceFrames | null = null): void {
    this.motion = motion;
    this.poses = poses;
    this.face = face;
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
      ? this.poses.positions.length / 3 / this.motion.frames : this.body.length;
    return this.skin !== null && this.skin.joints.length === count;
  }

  private showsFingers(): boolean {
    return this.poses !== null && this.poses.hasHands && this.fingers.length > 0;
  }

  private dress(): void {
    this.dressAs(this.isDressed(), this.showsFingers());
  }

  private dressAs(isDressed: boolean, hasFingers: boolean): void {
    for (const { group, name } of this.body)
      group.visible = !isDressed && !(hasFingers && name.endsWith("Wrist"));
    for (const { group } of [...this.palms, ...this.fingers]) group.visible = !isDressed && hasFingers;
    if (this.skin) this.skin.group.visible = isDressed;
  }

  /** 1: solid. Less shines through, and is drawn after what is solid. */
  setOpacity(opacity: number): void {
    if (opacity === this.opacity) return;
    this.opacity = opacity;
    this.skin?.setOpacity(opacity);
    for (const { material, veil } of this.parts()) {
      material.transparent = opacity < 1;
      material.opacity = opacity;
      material.polygonOffset = opacity < 1;
      material.needsUpdate = true;
      veil.visible = opacity < 1;
    }
  }

  /** Of the joints in order; null: the figure's own colour again. */
  paint(colours: ColorRepresentation[] | null): void {
    if (!colours && !this.colours) return;
    this.colours = colours;
    this.skin?.paint(colours);
    for (const { name, joint, material } of this.parts())
      material.color.copy(colours ? new Color(colours[joint]!) : shade(this.colour, sideOf(name)));
  }

  /** How far it would have walked by then, were it not in place; metres along +Z. */
  travelled(phase: number): number {
    return this.motion ? this.motion.displacement[2] * phase : 0;
  }

  /** `rounds`: how often it went through its motion before, while its face may have gone on. */
  pose(phase: number, rounds = 0): void {
    const { motion } = this;
    if (!motion) return;
    if (this.isDressed()) {
      this.poseJoints(motion, phase, this.skin!.joints, this.poses ?? motion);
      const seconds = (motion.loops ? rounds + phase : phase) * secondsOf(motion);
      this.skin!.setFace(this.face ? weightsAt(this.face, seconds, motion.fps) : null);
      return;
    }
    const body = this.body.map(({ group }) => group);
    this.poseJoints(motion, phase, body, motion);
    if (!this.showsFingers()) return;
    this.poseJoints(motion, phase, [...body, ...this.fingers.map(({ group }) => group)], this.poses!);
    this.putPalms();
  }

  private putPalms(): void {
    for (const { group, joint } of this.palms) {
      const wrist = this.body[joint]!.group;
      group.position.copy(wrist.position);
      group.quaternion.copy(wrist.quaternion);
    }
  }

  private poseJoints(
    motion: LiveMotion, phase: number, joints: Object3D[], poses: Pick<JointPoses, "positions" | "rotations">,
  ): void {
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

  /** Poses it by places and rotations in the world (joints × 3, joints × 4), of whatever motion: of the joints of its
      skin, of its body, or of its body and hands. */
  standAs(positions: ArrayLike<number>, rotations: ArrayLike<number>, face: ArrayLike<number> | null = null): void {
    this.group.visible = true;
    const count = positions.length / 3;
    const isDressed = this.skin?.joints.length === count;
    const hasFingers = !isDressed && this.fingers.length > 0 && count === this.body.length + this.fingers.length;
    this.dressAs(isDressed, hasFingers);
    const parts = hasFingers ? [...this.body, ...this.fingers] : this.body;
    const joints = isDressed ? this.skin!.joints : parts.map(({ group }) => group);
    joints.forEach((joint, j) => {
      joint.position.fromArray(positions, 3 * j);
      joint.quaternion.fromArray(rotations, 4 * j);
    });
    if (isDressed) this.skin!.setFace(face);
    else if (hasFingers) this.putPalms();
  }

  release(): void {
    this.wear(null);
    for (const { group, material } of this.parts()) {
      for (const part of group.children) (part as Mesh).geometry.dispose();
      material.dispose();
    }
  }
}
