// Both motions as figures of lines on a floor, from a side that can be turned.
import { element } from "../questionnaire/elements";
import type { Clock } from "./clock";
import { colour, dot, font, prepared, stroke, type View } from "./painting";
import { millimetres, partAt, type ComparedMotion, type PackedPoses } from "./stimulus";

type Vector = [x: number, y: number, z: number];

/** World places of joints, in millimetres. */
export class Poses {
  readonly count: number;
  private readonly values: Int16Array;

  constructor(readonly packed: PackedPoses) {
    const bytes = Uint8Array.from(atob(packed.places.slice(packed.places.indexOf(",") + 1)), (letter) => letter.charCodeAt(0));
    const view = new DataView(bytes.buffer);
    this.values = Int16Array.from({ length: bytes.length / 2 }, (_, i) => view.getInt16(2 * i, true));
    this.count = this.values.length / (3 * packed.joints);
  }

  frameAt = (seconds: number): number => Math.min(this.count - 1, Math.max(0, Math.round(seconds * this.packed.fps)));

  place(frame: number, joint: number): Vector {
    const at = 3 * (frame * this.packed.joints + joint);
    return [0, 1, 2].map((axis) => this.packed.step_mm * this.values[at + axis]!) as Vector;
  }

  /** Of all joints in all frames, the lowest and the highest. */
  heights(): [low: number, high: number] {
    let low = Infinity, high = -Infinity;
    for (let i = 1; i < this.values.length; i += 3) {
      low = Math.min(low, this.values[i]!);
      high = Math.max(high, this.values[i]!);
    }
    return [low * this.packed.step_mm, high * this.packed.step_mm];
  }
}

const distance = (p: Vector, q: Vector): number => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);

/** The side from which most of the difference at a moment is seen, and something of the figure. */
function bestTurn(before: Poses, now: Poses, seconds: number): number {
  const b = before.frameAt(seconds), n = now.frameAt(seconds);
  const apart: [number, number][] = [], spread: [number, number][] = [];
  const root = now.place(n, 0);
  for (let j = 0; j < Math.min(before.packed.joints, now.packed.joints); j += 1) {
    const p = before.place(b, j), q = now.place(n, j);
    apart.push([q[0] - p[0], q[2] - p[2]]);
    spread.push([q[0] - root[0], q[2] - root[2]]);
  }
  const seen = (vectors: [number, number][], turn: number): number =>
    vectors.reduce((sum, [x, z]) => sum + (Math.cos(turn) * x - Math.sin(turn) * z) ** 2, 0)
    / vectors.reduce((sum, [x, z]) => sum + x * x + z * z, 1e-9);
  let best = 0.6, most = -1;
  for (let i = 0; i < 24; i += 1) {
    const turn = Math.PI * i / 12;
    const share = seen(apart, turn) + 0.8 * seen(spread, turn) + 0.01 * Math.cos(turn);
    if (share > most) {
      most = share;
      best = turn;
    }
  }
  return best;
}

const turns: Record<string, [aside: number, up: number]> = { a: [0.15, 0], d: [-0.15, 0], w: [0, 0.1], s: [0, -0.1] };

/** Where a place is on the canvas. */
type Projection = (place: Vector) => [number, number];

class MotionView implements View {
  private readonly before: Poses;
  private readonly now: Poses;
  private readonly floor: number;
  private readonly tall: number;
  private turn: number;
  private tilt = 0.22;
  private readonly told = element("span");
  private readonly canvas = element("canvas", { class: "space", tabindex: "0", role: "img",
    "aria-label": "Both motions in 3-D, before in orange and now in blue. A and D turn it, W and S tilt it." });
  readonly node: HTMLElement;

  constructor(private readonly motion: ComparedMotion, private readonly clock: Clock) {
    this.before = new Poses(motion.before);
    this.now = new Poses(motion.now);
    this.turn = bestTurn(this.before, this.now, clock.seconds()) + 0.3; // a little aside, to see depth
    const heights = [...this.before.heights(), ...this.now.heights()];
    this.floor = Math.min(0, ...heights);
    this.tall = Math.max(Math.max(...heights) - this.floor, 500);
    const keys = ["A", "D", "W", "S"].flatMap((key) => [" ", element("kbd", {}, key)]);
    this.node = element("figure", {}, this.canvas, element("figcaption", {}, element("span", { class: "before" }, "━ before"),
      "  ", element("span", { class: "now" }, "━ now"), "  ", this.told, " A square is 0.5 m. Drag, or", ...keys, ", to turn."));
    this.canvas.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) this.turnBy(event.movementX * 0.01, event.movementY * 0.01);
    });
    clock.onFrame(() => this.paint());
  }

  keys(event: KeyboardEvent): boolean {
    const by = turns[event.key.toLowerCase()];
    if (by) this.turnBy(...by);
    return by !== undefined;
  }

  private turnBy(aside: number, up: number): void {
    this.turn += aside;
    this.tilt = Math.min(1.5, Math.max(0, this.tilt + up));
    this.paint();
  }

  private hasEnded = (poses: Poses): boolean => this.clock.seconds() * poses.packed.fps > poses.count - 0.5;

  private projection(centre: Vector, width: number, height: number): Projection {
    const scale = height / (this.tall * 1.3);
    const [sin, cos, lift, flat] = [Math.sin(this.turn), Math.cos(this.turn), Math.sin(this.tilt), Math.cos(this.tilt)];
    return (place) => {
      const [x, y, z] = place.map((value, axis) => value - centre[axis]!) as Vector;
      return [width / 2 + scale * (cos * x - sin * z), height / 2 - scale * (flat * y - lift * (sin * x + cos * z))];
    };
  }

  paint(): void {
    const { canvas, before, now, clock } = this;
    const width = Math.max(240, canvas.clientWidth || 480), height = Math.max(240, canvas.clientHeight || 360);
    const context = prepared(canvas, width, height);
    const b = before.frameAt(clock.seconds()), n = now.frameAt(clock.seconds());
    const rootBefore = before.place(b, 0), rootNow = now.place(n, 0);
    const centre: Vector = [(rootBefore[0] + rootNow[0]) / 2, this.floor + this.tall / 2, (rootBefore[2] + rootNow[2]) / 2];
    const seen = this.projection(centre, width, height);
    this.drawFloor(context, centre, seen);
    for (const [poses, frame, name, wide] of [[before, b, "--before", 6], [now, n, "--now", 3]] as const) {
      context.strokeStyle = context.fillStyle = colour(name);
      context.lineWidth = wide;
      context.lineCap = "round";
      for (const [from, to] of poses.packed.bones) stroke(context, seen(poses.place(frame, from)), seen(poses.place(frame, to)));
    }
    this.nameFarthest(context, seen, b, n, width);
    const ended = [this.hasEnded(before) ? " Before has ended." : "", this.hasEnded(now) ? " Now has ended." : ""].join("");
    this.told.textContent = `Frame ${clock.frame}, ${clock.seconds().toFixed(2)} s.${ended}`;
  }

  private drawFloor(context: CanvasRenderingContext2D, centre: Vector, seen: Projection): void {
    const square = 500, reach = 3 * square;
    context.strokeStyle = colour("--line");
    context.lineWidth = 1;
    const x0 = Math.round(centre[0] / square) * square, z0 = Math.round(centre[2] / square) * square;
    for (let at = -reach; at <= reach; at += square) {
      stroke(context, seen([x0 + at, this.floor, z0 - reach]), seen([x0 + at, this.floor, z0 + reach]));
      stroke(context, seen([x0 - reach, this.floor, z0 + at]), seen([x0 + reach, this.floor, z0 + at]));
    }
  }

  /** The joint that is farthest apart, now; null where both cannot be compared. */
  private farthest(b: number, n: number): Vector | null {
    const { before, now } = this;
    if (before.packed.joints !== now.packed.joints || this.hasEnded(before) || this.hasEnded(now)) return null;
    let most = 0, at: Vector | null = null;
    for (let j = 0; j < now.packed.joints; j += 1) {
      const place = now.place(n, j), apart = distance(before.place(b, j), place);
      if (apart > most) [most, at] = [apart, place];
    }
    return at;
  }

  /** Names the part that is farthest apart, beside it. */
  private nameFarthest(context: CanvasRenderingContext2D, seen: Projection, b: number, n: number, width: number): void {
    const moment = Math.min(this.motion.curve.length - 1, Math.round(this.clock.seconds() * this.motion.fps));
    const part = partAt(this.motion, moment);
    const apart = part?.curve[moment] ?? 0;
    const at = apart > 0 ? this.farthest(b, n) : null;
    if (!part || !at) return;
    const [x, y] = seen(at);
    context.strokeStyle = context.fillStyle = colour("--bad");
    context.lineWidth = 1.5;
    dot(context, [x, y], 9);
    context.stroke();
    context.font = font(13);
    const text = `${part.name} ${millimetres(apart)}`;
    const room = context.measureText(text).width + 20;
    const isLeft = x + room > width || (x < width / 2 && x > room); // away from the figure
    const from = x + (isLeft ? -16 : 16);
    context.textAlign = isLeft ? "right" : "left";
    context.strokeStyle = colour("--paper");
    context.lineWidth = 4;
    context.lineJoin = "round";
    context.strokeText(text, from, y + 4);
    context.fillText(text, from, y + 4);
  }
}

export const motionView = (motion: ComparedMotion, clock: Clock): View => new MotionView(motion, clock);
