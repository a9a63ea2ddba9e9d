import {
  Color, PerspectiveCamera, type LineBasicMaterial, type LineSegments, type Scene, type WebGLRenderer,
} from "three";
import { letTurn, stand, within, type Turn } from "./camera_turn";
import { floor, hasGraphicsCard, litScene, rendererOn } from "./stage";
import type { Turned } from "./turned";

/** How long people stand still before their film begins again. */
const pauseSeconds = 0.7;

/**
 * The people of a film where they are in it, playing again and again, before a camera that is turned by mouse, fingers
 * and keys. The element fills what it stands in. `release` ends it.
 */
export class PeopleView {
  readonly element = document.createElement("canvas");
  private renderer: WebGLRenderer;
  private camera = new PerspectiveCamera(32, 4 / 3, 0.05, 60);
  private turn: Turn = { azimuth: 1.1, elevation: 0.14, distance: 4.4 };
  private scene: Scene = litScene();
  private ground: LineSegments = floor();
  private seconds = 0;
  private isPlaying = true;
  private isReleased = false;
  private isStale = true;
  private last = 0;
  private drawnAt = 0;
  private interval = hasGraphicsCard() ? 0 : 30;  // milliseconds
  private waiting: (() => void)[] = [];
  private resized: ResizeObserver;

  constructor(readonly turned: Turned, label: string) {
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "img");
    this.element.setAttribute("aria-label", label);
    this.element.className = "figure-view";
    this.renderer = rendererOn(this.element);
    Object.assign(this.turn, turned.stands);
    this.scene.add(this.ground, turned.object);
    letTurn(this.element, this.turn, () => this.changed());
    this.resized = new ResizeObserver(() => this.changed());
    this.resized.observe(this.element);
    requestAnimationFrame(this.frame);
  }

  private changed(): void {
    this.isStale = true;
  }

  drawn(): Promise<void> {
    this.isStale = true;
    return new Promise((resolve) => this.waiting.push(resolve));
  }

  play(): void {
    this.isPlaying = true;
  }

  pause(): void {
    this.isPlaying = false;
  }

  plays = (): boolean => this.isPlaying;

  phase = (): number => within(0, this.seconds / this.turned.seconds, 1);

  seek(phase: number): void {
    this.seconds = phase * this.turned.seconds;
    this.changed();
  }

  stands = (): Turn => ({ ...this.turn });

  standAt(turn: Turn): void {
    Object.assign(this.turn, turn);
    this.changed();
  }

  /** What is behind the people: "#rrggbb". */
  setBackground(colour: string): void {
    this.scene.background = new Color(colour);
    (this.ground.material as LineBasicMaterial).color.set(colour).multiplyScalar(0.72);
    this.changed();
  }

  release(): void {
    this.isReleased = true;
    this.resized.disconnect();
    this.turned.release();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private frame = (now: number): void => {
    if (this.isReleased) return;
    const seconds = this.last === 0 ? 0 : within(0, (now - this.last) / 1000, 0.25);
    this.last = now;
    if (this.isPlaying) this.seconds = (this.seconds + seconds) % (this.turned.seconds + pauseSeconds);
    if (this.isStale || (this.isPlaying && now - this.drawnAt >= this.interval)) {
      this.drawnAt = now;
      this.draw();
    }
    requestAnimationFrame(this.frame);
  };

  private draw(): void {
    const { element, camera } = this;
    const width = element.clientWidth;
    const height = element.clientHeight;
    if (!width || !height) return;
    this.isStale = false;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.turned.pose(Math.min(this.seconds, this.turned.seconds));
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    const { x, z } = this.turned.middle();
    stand(camera, this.turn, x, 0.9, z);
    this.renderer.render(this.scene, camera);
    for (const tell of this.waiting.splice(0)) tell();
  }
}
