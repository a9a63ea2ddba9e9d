/** How the face of a character moves: the weights of its morphs (scenes/skinning/skinned_glb.h) over a film. */
export interface FaceFrames {
  /** frames × morphs. */
  weights: Float32Array;
  /** 1: it stays as it is. */
  frames: number;
}

/** The weights at a time; a film that has ended begins again. */
export function weightsAt({ weights, frames }: FaceFrames, seconds: number, fps: number): Float32Array {
  const morphs = weights.length / frames;
  const at = (seconds * fps) % frames;
  const frame = Math.floor(at);
  const next = Math.min(frame + 1, frames - 1);
  return weights.slice(frame * morphs, (frame + 1) * morphs).map((weight, morph) =>
    weight + (at - frame) * (weights[next * morphs + morph]! - weight));
}
