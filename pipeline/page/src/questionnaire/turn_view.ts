import {
  AnimationMixer, BufferGeometry, Color, DirectionalLight, Float32BufferAttribute, HemisphereLight,
  LineBasicMaterial, LineSegments, LoopOnce, Mesh, MeshStandardMaterial, PerspectiveCamera, Scene, Vector3, WebGLRenderer, type AnimationAction, type Object3D,
} from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import type { Screen, ScreenEvents, TurnView } from "./screen";

const background = "#808080";

/** Where the camera stands about what it looks at; radians and metres. */
interface Turn {
  azimuth: number;
  elevation: number;
  distance: number;
}

const within = (least: number, value: number, most: number): number =>
  Math.min(most, Math.max(least, value));

/** Mouse, fingers and keys turn the camera; plus and minus, or the wheel, bring it nearer. */
function let_turn(canvas: HTMLCanvasElement, turn: Turn, changed: () => void): void {
  const by = (azimuth: number, elevation: number, nearer = 1) => {
    turn.azimuth += azimuth;
    turn.elevation = within(-0.2, turn.elevation + elevation, 1.45);
    turn.distance = within(1.5, turn.distance * nearer, 12);
    changed();
  };
  canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    if (canvas.hasPointerCapture(event.pointerId))
      by(-event.movementX * 0.008, event.movementY * 0.006);
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    by(0, 0, Math.exp(event.deltaY * 0.001));
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => {
    const step = 0.12;
    const steps: Record<string, [number, number, number]> = {
      ArrowLeft: [-step, 0, 1], ArrowRight: [step, 0, 1], ArrowUp: [0, step, 1],
      ArrowDown: [0, -step, 1], "+": [0, 0, 0.9], "-": [0, 0, 1 / 0.9],
    };
    const found = steps[event.key];
    if (!found) return;
    event.preventDefault();
    by(...found);
  });
}

/** Squares of half a metre, in short pieces: some drivers lose lines that begin behind the camera. */
function floor(): LineSegments {
  const points: number[] = [];
  for (let across = -10; across <= 10; across += 0.5) {
    for (let along = -10; along < 10; along += 0.5)
      points.push(across, 0, along, across, 0, along + 0.5, along, 0, across, along + 0.5, 0, across);
  }
  const lines = new BufferGeometry();
  lines.setAttribute("position", new Float32BufferAttribute(points, 3));
  return new LineSegments(lines, new LineBasicMaterial({ color: "#727272" }));
}

/** A floor to walk on, light from above, a figure of one colour. */
function scene_of(figure: Object3D, colour: string): Scene {
  const scene = new Scene();
  scene.background = new Color(background);
  scene.add(new HemisphereLight("#ffffff", "#777777", 2.2));
  const sun = new DirectionalLight("#ffffff", 1.6);
  sun.position.set(2, 4, 3);
  scene.add(sun, floor(), figure);
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
  private slow_frames = 0;
  private is_over = false;
  private is_released = false;
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
    let_turn(this.element, this.turn, () => this.draw());
    this.ready = this.load(url, colour);
  }

  private async load(url: string, colour: string): Promise<void> {
    const { scene: figure, animations } = await new GLTFLoader().loadAsync(url);
    const clip = animations[0];
    if (!clip) throw new Error("a file without a motion");
    this.figure = figure;
    this.scene = scene_of(figure, colour);
    this.mixer = new AnimationMixer(figure);
    this.action = this.mixer.clipAction(clip);
    this.action.setLoop(LoopOnce, 1);
    this.action.clampWhenFinished = true;
    this.mixer.addEventListener("finished", () => {
      this.is_over = true;
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
    this.is_over = false;
    this.frames = 0;
    this.action.reset().play();
    this.last = performance.now();
    requestAnimationFrame(this.step);
  }

  private step = (now: number): void => {
    if (this.is_released || this.is_over || !this.mixer) return;
    const seconds = within(0, (now - this.last) / 1000, 0.25);
    this.last = now;
    if (this.frames > 0 && seconds > 0.05) this.slow_frames += 1;
    this.frames += 1;
    this.mixer.update(seconds);
    this.draw();
    if (this.frames === 1) this.told.began();
    requestAnimationFrame(this.step);
  };

  private draw(): void {
    const { element, scene, hips, figure, turn } = this;
    if (!scene || !hips || !figure || this.is_released || !element.clientWidth) return;
    const width = element.clientWidth;
    const height = element.clientHeight;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    figure.updateMatrixWorld(true);
    const centre = hips.getWorldPosition(new Vector3());
    centre.y = 0.9;
    const flat = Math.cos(turn.elevation) * turn.distance;
    this.camera.position.set(centre.x + flat * Math.sin(turn.azimuth),
      centre.y + Math.sin(turn.elevation) * turn.distance, centre.z + flat * Math.cos(turn.azimuth));
    this.camera.lookAt(centre);
    this.renderer.render(scene, this.camera);
  }

  has_ended = (): boolean => this.is_over;

  /** Steps that took longer than three of a usual screen. */
  dropped_frames = (): number => this.slow_frames;

  release(): void {
    this.is_released = true;
    this.resized.disconnect();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}

const view: TurnView = (url, label, colour, told) => new TurnScreen(url, label, colour, told);
(globalThis as { mienTurnView?: TurnView }).mienTurnView = view;
