import { PerspectiveCamera, type WebGLRenderer } from "three";
import { letTurn, stand, type Turn } from "../figure/camera_turn";
import { Figure } from "../figure/figure";
import { floor, floorSquare, litScene, rendererOn } from "../figure/stage";
import type { WalkFrame, WalkerInfo } from "../live/walker";

const fieldOfView = 32;  // degrees, upright
const radians = Math.PI / 180;
/** How soon the camera follows, 1/s. */
const follows = 8;

/** A walker on an endless floor, with a camera that goes with it and may be turned about it. */
export class WalkView {
  readonly element: HTMLCanvasElement;
  /** Whether the camera turns as the walker does. */
  turnsAlong = true;
  private renderer: WebGLRenderer;
  private camera = new PerspectiveCamera(fieldOfView, 1, 0.05, 60);
  private turn: Turn = { azimuth: Math.PI - 0.55, elevation: 0.22, distance: 5.2 };
  private scene = litScene();
  private ground = floor();
  private figure: Figure;
  private at = { x: 0, z: 0, heading: 0 };

  constructor(info: WalkerInfo, colour: string, label: string) {
    this.element = document.createElement("canvas");
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "img");
    this.element.setAttribute("aria-label", label);
    this.element.className = "walk-view";
    this.renderer = rendererOn(this.element);
    this.figure = new Figure(info.body, colour);
    this.scene.add(this.ground, this.figure.group);
    letTurn(this.element, this.turn, () => undefined);
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
    this.figure.standAs(frame.positions, frame.rotations);
    this.follow(frame, seconds);
    camera.aspect = width / height;
    const wider = Math.max(1, 0.62 / camera.aspect);
    camera.fov = 2 * Math.atan(Math.tan(fieldOfView / 2 * radians) * wider) / radians;
    camera.updateProjectionMatrix();
    const along = this.turnsAlong ? this.at.heading : 0;
    stand(camera, { ...this.turn, azimuth: this.turn.azimuth + along }, this.at.x, 0.9, this.at.z);
    // The floor is endless: its squares are put where the walker is.
    this.ground.position.x = Math.round(this.at.x / floorSquare) * floorSquare;
    this.ground.position.z = Math.round(this.at.z / floorSquare) * floorSquare;
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
