import {
  Box3, Color, Float32BufferAttribute, Group, MeshLambertMaterial, MeshStandardMaterial, SkinnedMesh,
  type BufferAttribute, type ColorRepresentation, type Object3D, type Texture,
} from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { hasGraphicsCard } from "./stage";

/** A surface's own paint, kept while other colours lie over it. */
interface Paint {
  colour: Color;
  map: Texture | null;
}

type SurfaceMaterial = MeshStandardMaterial | MeshLambertMaterial;

/** What a processor draws sooner: without gloss and fine relief. */
function plain(material: MeshStandardMaterial): MeshLambertMaterial {
  const { color, map, transparent, opacity, side } = material;
  material.normalMap?.dispose();
  material.dispose();
  return new MeshLambertMaterial({ color, map, transparent, opacity, side });
}

/**
 * A mannequin or a character as the server writes it (scenes/skinning/skinned_glb.h): joints that stand
 * in the world, each for itself, and surfaces that follow them.
 */
export class Skin {
  readonly group = new Group();
  /** In the order in which motions tell where they are. */
  readonly joints: Object3D[];
  /** In the pose that it was modelled in, metres. */
  readonly height: number;
  private surfaces: SkinnedMesh[] = [];
  private paints: Paint[] = [];

  private constructor(scene: Object3D) {
    this.group.add(scene);
    scene.traverse((part) => {
      if (!(part instanceof SkinnedMesh)) return;
      part.frustumCulled = false;
      part.renderOrder = 2;
      if (!hasGraphicsCard()) part.material = plain(part.material as MeshStandardMaterial);
      this.surfaces.push(part);
      const { color, map } = this.materialOf(part);
      this.paints.push({ colour: color.clone(), map });
    });
    this.joints = this.surfaces[0]?.skeleton.bones ?? [];
    const box = new Box3();
    for (const { geometry } of this.surfaces)
      box.union(new Box3().setFromBufferAttribute(geometry.attributes["position"] as BufferAttribute));
    this.height = box.isEmpty() ? 0 : box.max.y - box.min.y;
  }

  /** Reads a file's bytes; rejects what is none. */
  static async read(bytes: ArrayBuffer): Promise<Skin> {
    return new Skin((await new GLTFLoader().parseAsync(bytes, "")).scene);
  }

  private materialOf(surface: SkinnedMesh): SurfaceMaterial {
    return surface.material as SurfaceMaterial;
  }

  /** How far each morph has changed the surfaces; null: not at all. */
  setFace(weights: ArrayLike<number> | null): void {
    for (const { morphTargetInfluences, userData } of this.surfaces) {
      const morphs = userData["morphs"] as number[] | undefined;
      morphs?.forEach((morph, target) => {
        morphTargetInfluences![target] = weights?.[morph] ?? 0;
      });
    }
  }

  /** 1: solid. */
  setOpacity(opacity: number): void {
    for (const surface of this.surfaces) {
      const material = this.materialOf(surface);
      material.transparent = opacity < 1;
      material.opacity = opacity;
      material.needsUpdate = true;
    }
  }

  /** Colours of the body's joints run into each other over the surface; null: its own paint again. */
  paint(colours: ColorRepresentation[] | null): void {
    this.surfaces.forEach((surface, k) => {
      const material = this.materialOf(surface);
      const own = this.paints[k]!;
      if (colours) this.mix(surface, colours.map((colour) => new Color(colour)));
      material.vertexColors = colours !== null;
      material.map = colours ? null : own.map;
      material.color.copy(colours ? new Color("#ffffff") : own.colour);
      material.needsUpdate = true;
    });
  }

  /** Every vertex in the mean of the colours of the joints that move it. */
  private mix(surface: SkinnedMesh, colours: Color[]): void {
    const { skinIndex, skinWeight, position } = surface.geometry.attributes;
    const ofJoint = this.joints.map((joint) =>
      (colours[Number(joint.userData["body_joint"])] ?? colours[0]!).toArray());
    const mixed = new Float32Array(3 * position!.count);
    for (let vertex = 0; vertex < position!.count; vertex += 1) {
      for (let k = 0; k < 4; k += 1) {
        const weight = skinWeight!.getComponent(vertex, k);
        if (weight === 0) continue;
        const colour = ofJoint[skinIndex!.getComponent(vertex, k)]!;
        for (let channel = 0; channel < 3; channel += 1)
          mixed[3 * vertex + channel] = mixed[3 * vertex + channel]! + weight * colour[channel]!;
      }
    }
    surface.geometry.setAttribute("color", new Float32BufferAttribute(mixed, 3));
  }

  release(): void {
    this.surfaces.forEach((surface, k) => {
      surface.geometry.dispose();
      this.paints[k]!.map?.dispose();
      const material = this.materialOf(surface);
      if (material instanceof MeshStandardMaterial) material.normalMap?.dispose();
      material.dispose();
      surface.skeleton.dispose();
    });
  }
}
