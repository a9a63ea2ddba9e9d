import type { Object3D } from "three";
import type { Turn } from "./camera_turn";

/** What is seen from all sides, as it moves. */
export interface Turned {
  readonly object: Object3D;
  readonly seconds: number;
  /** Where the camera stands at first, as far as it is not where it usually does. */
  readonly stands: Partial<Turn>;
  pose(seconds: number): void;
  /** What the camera looks at, on the floor. */
  middle(): { x: number; z: number };
  release(): void;
}
