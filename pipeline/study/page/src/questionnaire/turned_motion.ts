import {
  AnimationMixer, LoopOnce, Mesh, MeshStandardMaterial, Vector3, type AnimationClip, type Object3D,
} from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import type { Turned } from "../figure/turned";

/** The part that a translation moves is what the camera follows. */
function hipsOf(figure: Object3D, clip: AnimationClip): Object3D {
  const moved = clip.tracks.find((track) => track.name.endsWith(".position"))?.name.split(".")[0];
  return (moved && figure.getObjectByName(moved)) || figure;
}

/** A motion file, whose bones are shown in one colour. */
export async function readTurnedMotion(bytes: ArrayBuffer, colour: string): Promise<Turned> {
  const { scene: object, animations } = await new GLTFLoader().parseAsync(bytes, "");
  const clip = animations[0];
  if (!clip) throw new Error("a file without a motion");
  object.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    part.material = new MeshStandardMaterial({ color: colour, roughness: 0.75, flatShading: true });
    part.frustumCulled = false;
  });
  const mixer = new AnimationMixer(object);
  const action = mixer.clipAction(clip).setLoop(LoopOnce, 1);
  action.clampWhenFinished = true;
  action.play();
  const hips = hipsOf(object, clip);
  const place = new Vector3();
  return {
    object,
    seconds: clip.duration,
    stands: {},
    pose(seconds) {
      action.reset();
      mixer.setTime(seconds);
      object.updateMatrixWorld(true);
    },
    middle: () => hips.getWorldPosition(place),
    release: () => object.traverse((part) => {
      if (part instanceof Mesh) part.geometry.dispose();
    }),
  };
}
