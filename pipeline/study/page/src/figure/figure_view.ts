import {
  Color, PerspectiveCamera, type LineBasicMaterial, type LineSegments, type Scene, type WebGLRenderer,
} from "three";
import type { LiveMotion } from "../live/core";
import type { Body } from "./body_shape";
import { letTurn, stand, within, type Turn } from "./camera_turn";
import type { FaceFrames } from "./face";
import { Figure, type JointPoses } from "./figure";
import { correspondingPhase, phaseInRound, roundSeconds, secondsOf, type Step } from "./playing";
import type { Skin } from "./skin";
import { floor, floorSquare, hasGraphicsCard, litScene, rendererOn } from "./stage";

/** Over each other, the first shining through, or each in its own part of the view, seen alike: from left to right
    (beside) or from above to below. */
export type Arrangement = "over" | "beside" | "below";

/** Where the camera may be sent. */
export type Side = "front" | "side" | "back" | "above";

const sides: Record<Side, Pick<Turn, "azimuth" | "elevation">> = {
  front: { azimuth: 0, elevation: 0.12 },
  side: { azimuth: Math.PI / 2, elevation: 0.12 },
  back: { azimuth: Math.PI, elevation: 0.12 },
  above: { azimuth: Math.PI / 2, elevation: 1.4 },
};

/** Part of the view, CSS pixels from its lower left corner. */
interface Pane {
  left: number;
  bottom: number;
  width: number;
  height: number;
}

const fieldOfView = 32;  // degrees, upright
const usualHeight = 1.8;  // metres
const longestRest = 100;  // milliseconds

/**
 * Figures of one body that play motions, again and again, walking in place on a floor that passes
 * under the first one that is shown. The camera is turned by mouse, fingers and keys (letTurn).
 *
 * The element fills what it stands in; its size may change. `release` ends it.
 */
export class FigureView {
  readonly element: HTMLCanvasElement;
  private renderer: WebGLRenderer;
  private camera = new PerspectiveCamera(32, 4 / 3, 0.05, 60);
  private turn: Turn = { azimuth: 1.1, elevation: 0.14, distance: 4.4 };
  private scene: Scene = litScene();
  private ground: LineSegments = floor();
  private figures: Figure[];
  /** Of each figure's round, 0 to 1. */
  private parts: number[];
  /** How far each walked in its earlier rounds and motions, metres. */
  private walked: number[];
  /** How often each went through its motion before, since it was last sent somewhere. */
  private rounds: number[];
  private arrangement: Arrangement = "over";
  private step: Step = "keytimes";
  private isPlaying = true;
  private isReleased = false;
  private isStale = true;
  private last = 0;
  private drawnAt = 0;
  /** Milliseconds between pictures of what plays: a processor alone needs time for the motions, too. */
  private interval = hasGraphicsCard() ? 0 : 30;
  /** Nothing is drawn before then (performance.now). */
  private restsUntil = 0;
  private waiting: (() => void)[] = [];
  private resized: ResizeObserver;

  /** `colours`: of the figures, the first of which is the one that is looked at most. `handed`: the body with its
      hands' joints. */
  constructor(body: Body, colours: string[], label: string, handed: Body | null = null) {
    this.element = document.createElement("canvas");
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "img");
    this.element.setAttribute("aria-label", label);
    this.element.className = "figure-view";
    this.renderer = rendererOn(this.element);
    this.figures = colours.map((colour) => new Figure(body, colour, handed));
    this.parts = colours.map(() => 0);
    this.walked = colours.map(() => 0);
    this.rounds = colours.map(() => 0);
    this.scene.add(this.ground, ...this.figures.map((figure) => figure.group));
    letTurn(this.element, this.turn, () => this.changed());
    this.resized = new ResizeObserver(() => this.changed());
    this.resized.observe(this.element);
    this.arrange("over");
    requestAnimationFrame(this.frame);
  }

  /** A figure plays this from now on, from the phase where it was; null: it is gone. `data-shown` counts. */
  show(
    figure: number, motion: LiveMotion | null, poses: JointPoses | null = null, face: FaceFrames | null = null,
  ): void {
    const before = this.travelled(figure);
    this.figures[figure]!.show(motion, poses, face);
    if (motion) this.walked[figure]! += before - this.travelled(figure);  // the floor stays where it is
    this.restsUntil = 0;
    this.element.dataset.shown = String(Number(this.element.dataset.shown ?? 0) + 1);
    this.arrange(this.arrangement);
  }

  /** A motion is about to be shown: pictures of the old one, which would be in its way, are left out. */
  expectMotion(): void {
    this.restsUntil = performance.now() + longestRest;
  }

  /** Resolved when what was asked for before is on the screen. */
  drawn(): Promise<void> {
    this.isStale = true;
    return new Promise((resolve) => this.waiting.push(resolve));
  }

  arrange(arrangement: Arrangement): void {
    this.arrangement = arrangement;
    const shown = this.figures.filter((figure) => figure.shows());
    const shines = arrangement === "over" && shown.length > 1;
    shown.forEach((figure, place) => figure.setOpacity(shines && place === 0 ? 0.62 : 1));
    this.changed();
  }

  keep(step: Step): void {
    this.step = step;
    if (step === "time") return;
    const first = this.parts[this.leader()] ?? 0;
    this.parts.fill(first);
  }

  /** What a figure is drawn as; null: balls and bones. */
  wear(figure: number, skin: Skin | null): void {
    this.figures[figure]!.wear(skin);
    this.changed();
  }

  /** Colours of a figure's joints; null: its own again. */
  paint(figure: number, colours: string[] | null): void {
    this.figures[figure]!.paint(colours);
    this.changed();
  }

  lookFrom(side: Side): void {
    Object.assign(this.turn, sides[side]);
    this.changed();
  }

  /** What is behind the figures: "#rrggbb". */
  setBackground(colour: string): void {
    const wanted = new Color(colour);
    if (this.scene.background instanceof Color && wanted.equals(this.scene.background)) return;
    this.scene.background = wanted;
    (this.ground.material as LineBasicMaterial).color.copy(wanted).multiplyScalar(0.72);
    this.changed();
  }

  /** Where the camera stands; `standAt` sends it there. */
  stands(): Turn {
    return { ...this.turn };
  }

  standAt(turn: Turn): void {
    Object.assign(this.turn, turn);
    this.changed();
  }

  play(): void {
    this.isPlaying = true;
  }

  pause(): void {
    this.isPlaying = false;
  }

  plays(): boolean {
    return this.isPlaying;
  }

  /** All figures stand where the first one's motion is at a phase, 0 to 1. */
  seek(phase: number): void {
    const motion = this.figures[this.leader()]?.shows();
    const part = motion ? phase * secondsOf(motion) / roundSeconds(motion) : phase;
    this.parts.fill(within(0, part, 1));
    this.walked.fill(0);
    this.rounds.fill(0);
    this.changed();
  }

  /** The phase of the first figure that is shown. */
  phase(): number {
    const leader = this.leader();
    const motion = this.figures[leader]?.shows();
    return motion ? phaseInRound(motion, this.parts[leader]!) : 0;
  }

  release(): void {
    this.isReleased = true;
    this.resized.disconnect();
    for (const figure of this.figures) figure.release();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private changed(): void {
    this.isStale = true;
  }

  private leader(): number {
    return Math.max(0, this.figures.findIndex((figure) => figure.shows()));
  }

  private frame = (now: number): void => {
    if (this.isReleased) return;
    const seconds = this.last === 0 ? 0 : within(0, (now - this.last) / 1000, 0.25);
    this.last = now;
    if (this.isPlaying) this.advance(seconds);
    if (now >= this.restsUntil && (this.isStale || (this.isPlaying && now - this.drawnAt >= this.interval))) {
      this.drawnAt = now;
      this.draw();
    }
    requestAnimationFrame(this.frame);
  };

  private advance(seconds: number): void {
    const leader = this.leader();
    const before = this.parts.slice();
    this.figures.forEach((figure, k) => {
      const motion = figure.shows();
      if (motion) this.parts[k] = (this.parts[k]! + seconds / roundSeconds(motion)) % 1;
    });
    if (this.step === "keytimes") this.parts.fill(this.parts[leader]!);
    this.figures.forEach((figure, k) => {
      if (this.parts[k]! >= before[k]!) return;
      this.walked[k]! += figure.travelled(1);
      this.rounds[k]! += 1;
    });
  }

  /** How far a figure has walked, metres; without jumps where its motion begins again or another follows. */
  private travelled(k: number): number {
    const figure = this.figures[k]!;
    return this.walked[k]! + figure.travelled(this.phaseOf(figure));
  }

  /** Where a figure is in its motion. */
  private phaseOf(figure: Figure): number {
    const k = this.figures.indexOf(figure);
    const leader = this.leader();
    const first = this.figures[leader]?.shows();
    const motion = figure.shows();
    if (!motion || !first) return 0;
    return this.step === "keytimes" && k !== leader
      ? correspondingPhase(first, this.phase(), motion)
      : phaseInRound(motion, this.parts[k]!);
  }

  private pose(): void {
    this.figures.forEach((figure, k) => figure.pose(this.phaseOf(figure), this.rounds[k]));
  }

  private draw(): void {
    const { element } = this;
    const width = element.clientWidth;
    const height = element.clientHeight;
    if (!width || !height) return;
    this.isStale = false;
    const ratio = Math.min(2, devicePixelRatio);
    if (element.width !== Math.floor(width * ratio) || element.height !== Math.floor(height * ratio)) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
    }
    this.pose();
    const shown = this.figures.filter((figure) => figure.shows());
    const isApart = this.arrangement !== "over" && shown.length > 1;
    const panes = isApart ? shown.map((one) => [one]) : [shown];
    const [across, down] = this.arrangement === "below" ? [1, panes.length] : [panes.length, 1];
    panes.forEach((figures, pane) => this.drawPane(figures, {
      left: across > 1 ? pane * width / across : 0, bottom: down > 1 ? (down - 1 - pane) * height / down : 0,
      width: width / across, height: height / down }));
    const told = this.waiting.splice(0);
    for (const tell of told) tell();
  }

  private drawPane(figures: Figure[], { left, bottom, width, height }: Pane): void {
    const { renderer, camera } = this;
    for (const figure of this.figures) figure.group.visible = figures.includes(figure);
    const travelled = figures[0] ? this.travelled(this.figures.indexOf(figures[0])) : 0;
    this.ground.position.z = -(travelled % floorSquare);
    camera.aspect = width / height;
    // What is narrow still shows the whole figure.
    const wider = Math.max(1, 0.62 / camera.aspect);
    const half = Math.tan(fieldOfView / 2 * Math.PI / 180) * wider;
    camera.fov = 2 * Math.atan(half) * 180 / Math.PI;
    camera.updateProjectionMatrix();
    // Who is taller is seen from as much farther away.
    const scale = Math.max(1, ...figures.map((figure) => figure.height() / usualHeight));
    stand(camera, { ...this.turn, distance: this.turn.distance * scale }, 0, 0.9 * scale, 0);
    renderer.setViewport(left, bottom, width, height);
    renderer.setScissor(left, bottom, width, height);
    renderer.setScissorTest(true);
    renderer.render(this.scene, camera);
  }
}
