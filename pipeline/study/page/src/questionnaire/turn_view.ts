import {
  AnimationMixer, LoopOnce, Mesh, MeshStandardMaterial, PerspectiveCamera, Vector3, WebGLRenderer,
  type AnimationAction, type Object3D, type Scene,
} from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { letTurn, stand, within, type Turn } from "../figure/camera_turn";
import { floor, litScene } from "../figure/stage";
import type { Screen, ScreenEvents, TurnView } from "./screen";

/** A floor to walk on, light from above, a figure of one colour. */
function sceneOf(figure: Object3D, colour: string): Scene {
  const scene = litScene();
  scene.add(floor(), figure);
  figure.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    part.material = new MeshStandardMaterial({ color: colour, roughness: 0.75, flatShading: true });
    part.frustumCulled = false;
  });
  return scene;
}

class TurnScreen implements Screen {
  readonly element: HTMLCanvasElement;
  readonly ready: Promise<void>;
  private renderer: WebGLRenderer;
  private camera = new PerspectiveCamera(35, 4 / 3, 0.05, 60);
  private turn: Turn = { azimuth: Math.PI / 2, elevation: 0.12, distance: 3.7 };
  private scene: Scene | null = null;
  private mixer: AnimationMixer | null = null;
  private action: AnimationAction | null = null;
  private hips: Object3D | null = null;
  private figure: Object3D | null = null;
  private last = 0;
  private frames = 0;
  private slowFrames = 0;
  private isOver = false;
  private isReleased = false;
  private resized: ResizeObserver;

  constructor(url: string, label: string, colour: string, private told: ScreenEvents) {
    this.element = document.createElement("canvas");
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "img");
    this.element.setAttribute("aria-label", label);
    this.element.className = "turned";
    this.renderer = new WebGLRenderer({ canvas: this.element, antialias: true, preserveDrawingBuffer: true });
    this.resized = new ResizeObserver(() => this.draw());
    this.resized.observe(this.element);
    letTurn(this.element, this.turn, () => this.draw());
    this.ready = this.load(url, colour);
  }

  private async load(url: string, colour: string): Promise<void> {
    const { scene: figure, animations } = await new GLTFLoader().loadAsync(url);
    const clip = animations[0];
    if (!clip) throw new Error("a file without a motion");
    this.figure = figure;
    this.scene = sceneOf(figure, colour);
    this.mixer = new AnimationMixer(figure);
    this.action = this.mixer.clipAction(clip);
    this.action.setLoop(LoopOnce, 1);
    this.action.clampWhenFinished = true;
    this.mixer.addEventListener("finished", () => {
      this.isOver = true;
      this.told.ended();
    });
    // The part that a translation moves is what the camera follows.
    const moved = clip.tracks.find((track) => track.name.endsWith(".position"))?.name.split(".")[0];
    this.hips = (moved && figure.getObjectByName(moved)) || figure;
    this.action.play();
    this.mixer.setTime(0);
    this.draw();
  }

  play(): void {
    if (!this.action || !this.mixer) return;
    this.isOver = false;
    this.frames = 0;
    this.action.reset().play();
    this.last = performance.now();
    requestAnimationFrame(this.step);
  }

  stop(): void {
    this.isOver = true;
  }

  private step = (now: number): void => {
    if (this.isReleased || this.isOver || !this.mixer) return;
    const seconds = within(0, (now - this.last) / 1000, 0.25);
    this.last = now;
    if (this.frames > 0 && seconds > 0.05) this.slowFrames += 1;
    this.frames += 1;
    this.mixer.update(seconds);
    this.draw();
    if (this.frames === 1) {
      this.told.began(now);
      this.told.wentOn();
    }
    requestAnimationFrame(this.step);
  };

  private draw(): void {
    const { element, scene, hips, figure, turn } = this;
    if (!scene || !hips || !figure || this.isReleased || !element.clientWidth) return;
    const width = element.clientWidth;
    const height = element.clientHeight;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    figure.updateMatrixWorld(true);
    const centre = hips.getWorldPosition(new Vector3());
    stand(this.camera, turn, centre.x, 0.9, centre.z);
    this.renderer.render(scene, this.camera);
  }

  hasEnded = (): boolean => this.isOver;

  /** Steps that took longer than three of a usual screen. */
  dropped_frames = (): number => this.slowFrames;

  release(): void {
    this.isReleased = true;
    this.resized.disconnect();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}

const view: TurnView = (url, label, colour, told) => new TurnScreen(url, label, colour, told);
(globalThis as { mienTurnView?: TurnView }).mienTurnView = view;
