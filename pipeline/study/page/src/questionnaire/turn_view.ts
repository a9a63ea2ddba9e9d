import { PerspectiveCamera, WebGLRenderer, type Scene } from "three";
import { letTurn, stand, within, type Turn } from "../figure/camera_turn";
import { readPeople } from "../figure/people";
import { floor, litScene } from "../figure/stage";
import type { Turned } from "../figure/turned";
import type { Screen, ScreenEvents, TurnedFiles, TurnView } from "./screen";
import { readTurnedMotion } from "./turned_motion";

const bytesOf = async (url: string): Promise<ArrayBuffer> => (await fetch(url)).arrayBuffer();

async function read({ url, figures, isMotion }: TurnedFiles, colour: string): Promise<Turned> {
  if (isMotion) return readTurnedMotion(await bytesOf(url), colour);
  const [people, ...files] = await Promise.all([url, ...figures].map(bytesOf));
  return readPeople(people!, files);
}

class TurnScreen implements Screen {
  readonly element: HTMLCanvasElement;
  readonly ready: Promise<void>;
  private renderer: WebGLRenderer;
  private camera = new PerspectiveCamera(35, 4 / 3, 0.05, 60);
  private turn: Turn = { azimuth: Math.PI / 2, elevation: 0.12, distance: 3.7 };
  private scene: Scene | null = null;
  private turned: Turned | null = null;
  private seconds = 0;
  private last = 0;
  private frames = 0;
  private slowFrames = 0;
  private isOver = false;
  private isReleased = false;
  private resized: ResizeObserver;

  constructor(files: TurnedFiles, label: string, colour: string, private told: ScreenEvents) {
    this.element = document.createElement("canvas");
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "img");
    this.element.setAttribute("aria-label", label);
    this.element.className = "turned";
    this.renderer = new WebGLRenderer({ canvas: this.element, antialias: true, preserveDrawingBuffer: true });
    this.resized = new ResizeObserver(() => this.draw());
    this.resized.observe(this.element);
    this.ready = this.load(files, colour);
  }

  private async load(files: TurnedFiles, colour: string): Promise<void> {
    const turned = await read(files, colour);
    if (this.isReleased) return turned.release();
    this.turned = turned;
    Object.assign(this.turn, turned.stands);
    letTurn(this.element, this.turn, () => this.draw());
    this.scene = litScene();
    this.scene.add(floor(), turned.object);
    this.show(0);
  }

  play(): void {
    if (!this.turned) return;
    this.isOver = false;
    this.frames = 0;
    this.seconds = 0;
    this.last = performance.now();
    requestAnimationFrame(this.step);
  }

  stop(): void {
    this.isOver = true;
  }

  private step = (now: number): void => {
    if (this.isReleased || this.isOver || !this.turned) return;
    const seconds = within(0, (now - this.last) / 1000, 0.25);
    this.last = now;
    if (this.frames > 0 && seconds > 0.05) this.slowFrames += 1;
    this.frames += 1;
    this.show(Math.min(this.seconds + seconds, this.turned.seconds));
    if (this.frames === 1) {
      this.told.began(now);
      this.told.wentOn();
    }
    if (this.seconds >= this.turned.seconds) {
      this.isOver = true;
      this.told.ended();
    }
    requestAnimationFrame(this.step);
  };

  /** The moment of the motion. */
  show(seconds: number): void {
    this.seconds = seconds;
    this.turned?.pose(seconds);
    this.draw();
  }

  private draw(): void {
    const { element, scene, turned, turn } = this;
    if (!scene || !turned || this.isReleased || !element.clientWidth) return;
    const width = element.clientWidth;
    const height = element.clientHeight;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    const { x, z } = turned.middle();
    stand(this.camera, turn, x, 0.9, z);
    this.renderer.render(scene, this.camera);
  }

  hasEnded = (): boolean => this.isOver;

  /** Steps that took longer than three of a usual screen. */
  dropped_frames = (): number => this.slowFrames;

  release(): void {
    this.isReleased = true;
    this.resized.disconnect();
    this.turned?.release();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}

const view: TurnView = (files, label, colour, told) => {
  const screen = new TurnScreen(files, label, colour, told);
  Object.assign(screen.element, { screen });  // as consoles and tests find it
  return screen;
};
(globalThis as { mienTurnView?: TurnView }).mienTurnView = view;
