import { Color, Group, Mesh, MeshLambertMaterial, Quaternion, Vector3, type Material } from "three";
import type { LiveMotion } from "../live/core";
import { joint_shape, side_of, type Body, type BodyStyle } from "./body_shape";
import { between_frames, middle_of, type Place } from "./playing";

/** The left side is darker and the right one lighter, so that legs can be told apart. */
function shade(colour: string, side: string): Color {
  const made = new Color(colour);
  if (side === "left") made.multiplyScalar(0.7);
  if (side === "right") made.lerp(new Color("#ffffff"), 0.14);
  return made;
}

/** Where surfaces fall together, this one counts as the nearer. */
function let_come_first(material: Material): void {
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

  constructor(private body: Body, private colour: string, style: BodyStyle = "mannequin") {
    const depth_alone = new MeshLambertMaterial({ colorWrite: false });
    let_come_first(depth_alone);
    body.names.forEach((name, joint) => {
      const material = new MeshLambertMaterial({ color: shade(colour, side_of(name)) });
      let_come_first(material);
      material.polygonOffset = false;
      const shape = joint_shape(body, joint, style);
      const solid = new Mesh(shape, material);
      solid.renderOrder = 2;
      // Drawn before what shines through, so that only the nearest surface does.
      const veil = new Mesh(shape, depth_alone);
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

  show(motion: LiveMotion | null): void {
    this.motion = motion;
    this.group.visible = motion !== null;
    if (motion) this.middle = middle_of(motion);
  }

  /** 1: solid. Less shines through, and is drawn after what is solid. */
  set_opacity(opacity: number): void {
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
    this.materials.forEach((material, joint) => {
      const own = shade(this.colour, side_of(this.body.names[joint]!));
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
    const count = this.joints.length;
    const { frame, next, share, rounds } = between_frames(motion, phase);
    const [dx, dy, dz] = motion.displacement;
    const here = new Vector3();
    const there = new Vector3();
    const turn = new Quaternion();
    const turned = new Quaternion();
    this.joints.forEach((joint, j) => {
      here.fromArray(motion.positions, (frame * count + j) * 3);
      there.fromArray(motion.positions, (next * count + j) * 3);
      there.set(there.x + rounds * dx, there.y + rounds * dy, there.z + rounds * dz);
      joint.position.lerpVectors(here, there, share);
      joint.position.x -= dx * phase + this.middle.x;
      joint.position.z -= dz * phase + this.middle.z;
      turn.fromArray(motion.rotations, (frame * count + j) * 4);
      turned.fromArray(motion.rotations, (next * count + j) * 4);
      joint.quaternion.slerpQuaternions(turn, turned, share);
    });
  }

  /** Poses it by places and rotations in the world (joints × 3, joints × 4), of whatever motion. */
  stand_as(positions: ArrayLike<number>, rotations: ArrayLike<number>): void {
    this.group.visible = true;
    this.joints.forEach((joint, j) => {
      joint.position.fromArray(positions, 3 * j);
      joint.quaternion.fromArray(rotations, 4 * j);
    });
  }

  release(): void {
    for (const group of this.joints)
      for (const part of group.children) (part as Mesh).geometry.dispose();
    for (const material of this.materials) material.dispose();
  }
}
