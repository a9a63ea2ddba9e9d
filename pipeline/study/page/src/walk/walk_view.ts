import { PerspectiveCamera, type WebGLRenderer } from "three";
import { let_turn, stand, type Turn } from "../figure/camera_turn";
import { Figure } from "../figure/figure";
import { floor, floor_square, lit_scene, renderer_on } from "../figure/stage";
import type { WalkFrame, WalkerInfo } from "../live/walker";

const field_of_view = 32;  // degrees, upright
const radians = Math.PI / 180;
/** How soon the camera follows, 1/s. */
const follows = 8;

/** A walker on an endless floor, with a camera that goes with it and may be turned about it. */
export class WalkView {
  readonly element: HTMLCanvasElement;
  /** Whether the camera turns as the walker does. */
  turns_along = true;
  private renderer: WebGLRenderer;
  private camera = new PerspectiveCamera(field_of_view, 1, 0.05, 60);
  private turn: Turn = { azimuth: Math.PI - 0.55, elevation: 0.22, distance: 5.2 };
  private scene = lit_scene();
  private ground = floor();
  private figure: Figure;
  private at = { x: 0, z: 0, heading: 0 };

  constructor(info: WalkerInfo, colour: string, label: string) {
    this.element = document.createElement("canvas");
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "img");
    this.element.setAttribute("aria-label", label);
    this.element.className = "walk-view";
    this.renderer = renderer_on(this.element);
    this.figure = new Figure(info.body, colour);
    this.scene.add(this.ground, this.figure.group);
    let_turn(this.element, this.turn, () => undefined);
  }

  /** Draws the frame, `seconds` after the last one. */
  draw(frame: WalkFrame, seconds: number): void {
    const { element, renderer, camera } = this;
    const width = element.clientWidth;
    const height = element.clientHeight;
    if (!width || !height) return;
    const ratio = Math.min(2, devicePixelRatio);
    if (element.width !== Math.floor(width * ratio) || element.height !== Math.floor(height * ratio)) {
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
    }
    this.figure.stand_as(frame.positions, frame.rotations);
    this.follow(frame, seconds);
    camera.aspect = width / height;
    const wider = Math.max(1, 0.62 / camera.aspect);
    camera.fov = 2 * Math.atan(Math.tan(field_of_view / 2 * radians) * wider) / radians;
    camera.updateProjectionMatrix();
    const along = this.turns_along ? this.at.heading : 0;
    stand(camera, { ...this.turn, azimuth: this.turn.azimuth + along }, this.at.x, 0.9, this.at.z);
    // The floor is endless: its squares are put where the walker is.
    this.ground.position.x = Math.round(this.at.x / floor_square) * floor_square;
    this.ground.position.z = Math.round(this.at.z / floor_square) * floor_square;
    renderer.render(this.scene, camera);
  }

  release(): void {
    this.figure.release();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private follow(frame: WalkFrame, seconds: number): void {
    const share = 1 - Math.exp(-follows * seconds);
    this.at.x += share * (frame.positions[0]! - this.at.x);
    this.at.z += share * (frame.positions[2]! - this.at.z);
    const left = frame.heading * radians - this.at.heading;
    this.at.heading += 0.25 * share * Math.atan2(Math.sin(left), Math.cos(left));
  }
}
