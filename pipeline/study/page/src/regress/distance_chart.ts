// How far apart both motions are: over time, and by part of the body.
import { element } from "../questionnaire/elements";
import type { Clock } from "./clock";
import { flipText } from "./flip_colours";
import { colour, dot, font, isDark, prepared, stroke, type View } from "./painting";
import { millimetres, partAt, type ComparedMotion } from "./stimulus";

const rowHeight = 15, top = 26, curveHeight = 96, left = 112, right = 10;
const rowsTop = top + curveHeight + 30;

/** A round length of time that fits about so many times. */
function tickStep(seconds: number, ticks: number): number {
  const rough = Math.max(seconds, 1e-6) / ticks;
  const ten = 10 ** Math.floor(Math.log10(rough));
  return ten * [1, 2, 5, 10].find((step) => step * ten >= rough)!;
}

/** From nothing to the most, against the page's ground. */
const shade = (share: number): string => flipText(isDark() ? share : 1 - share);

class Chart {
  private width = 640;
  private readonly most: number;
  private readonly moments: number;
  private readonly rowsEnd: number;
  private readonly worstText: string;
  private readonly canvas: HTMLCanvasElement;
  private readonly told = element("span");
  /** What is below the mark of the moment. */
  private picture: HTMLCanvasElement | null = null;
  readonly node: HTMLElement;

  constructor(private readonly motion: ComparedMotion, private readonly clock: Clock) {
    this.moments = motion.curve.length;
    this.most = Math.max(1e-9, ...motion.curve);
    this.rowsEnd = rowsTop + rowHeight * motion.parts.length;
    this.worstText = `${millimetres(this.most)}, ${this.worstPart()?.name} at ${(motion.worst / motion.fps).toFixed(2)} s`;
    this.canvas = element("canvas", { class: "chart", role: "img",
      "aria-label": `Distance of both motions over time and by part of the body. The most: ${this.worstText}.` });
    this.node = element("figure", { class: "wide" }, this.canvas, element("figcaption", {},
      "Distance of a joint, or of a point 10 cm beside it, before and now. Click to go to a frame. ", this.told));
    this.canvas.addEventListener("pointerdown", (event) => this.follow(event));
    this.canvas.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) this.follow(event);
    });
    clock.onFrame(() => this.mark());
  }

  private worstPart = () => partAt(this.motion, this.motion.worst);
  private x = (moment: number): number =>
    left + (this.width - left - right) * (this.moments > 1 ? moment / (this.moments - 1) : 0.5);
  private y = (value: number): number => top + curveHeight * (1 - value / this.most);

  private drawCurve(context: CanvasRenderingContext2D): void {
    const { motion, most, x, y } = this;
    context.strokeStyle = colour("--line");
    context.fillStyle = colour("--quiet");
    context.textAlign = "right";
    for (const share of [0, 0.5, 1]) {
      const up = Math.round(y(share * most)) + 0.5;
      stroke(context, [left, up], [this.width - right, up]);
      context.fillText(share ? millimetres(share * most) : "0 mm", left - 8, up + 4);
    }
    context.textAlign = "center";
    const seconds = (this.moments - 1) / motion.fps;
    const step = tickStep(seconds, 8);
    const digits = step < 0.1 ? 2 : step < 1 ? 1 : 0;
    for (let second = 0; second <= seconds + 1e-9; second += step)
      context.fillText(`${second.toFixed(digits)} s`, x(second * motion.fps), top + curveHeight + 18);
    context.strokeStyle = colour("--ink");
    context.lineWidth = 1.75;
    stroke(context, ...motion.curve.map((value, moment): [number, number] => [x(moment), y(value)]));
    context.lineWidth = 1;
  }

  private drawWorst(context: CanvasRenderingContext2D): void {
    const at = this.x(this.motion.worst);
    context.fillStyle = colour("--bad");
    dot(context, [at, this.y(this.most)], 4.5);
    context.fill();
    const text = `worst: ${this.worstText}`;
    const half = context.measureText(text).width / 2;
    context.textAlign = "center";
    context.fillText(text, Math.min(this.width - right - half, Math.max(left + half, at)), top - 10);
  }

  private drawParts(context: CanvasRenderingContext2D): void {
    const half = (this.width - left - right) / Math.max(1, this.moments - 1) / 2;
    this.motion.parts.forEach((part, row) => {
      const up = rowsTop + rowHeight * row;
      context.fillStyle = colour(part === this.worstPart() ? "--bad" : "--quiet");
      context.textAlign = "right";
      context.fillText(part.name, left - 8, up + rowHeight - 4);
      part.curve.forEach((value, moment) => {
        context.fillStyle = shade(value / this.most);
        const from = Math.max(left, Math.floor(this.x(moment) - half));
        const to = Math.min(this.width - right, Math.ceil(this.x(moment) + half));
        context.fillRect(from, up, Math.max(1, to - from), rowHeight - 1);
      });
    });
  }

  private drawLegend(context: CanvasRenderingContext2D): void {
    const up = this.rowsEnd + 9;
    for (let i = 0; i < 120; i += 1) {
      context.fillStyle = shade(i / 119);
      context.fillRect(left + i, up, 1, 9);
    }
    context.fillStyle = colour("--quiet");
    context.textAlign = "right";
    context.fillText("0 mm", left - 8, up + 9);
    context.textAlign = "left";
    context.fillText(millimetres(this.most), left + 128, up + 9);
  }

  paint(): void {
    const height = this.rowsEnd + 30;
    this.width = Math.max(320, Math.round(this.canvas.clientWidth || 640));
    this.canvas.style.height = `${height}px`;
    const context = prepared(this.canvas, this.width, height);
    context.font = font(12);
    this.drawParts(context);
    this.drawCurve(context);
    this.drawWorst(context);
    this.drawLegend(context);
    this.picture = element("canvas");
    this.picture.width = this.canvas.width;
    this.picture.height = this.canvas.height;
    this.picture.getContext("2d")!.drawImage(this.canvas, 0, 0);
    this.mark();
  }

  private mark(): void {
    if (!this.picture) return;
    const { canvas, motion, clock } = this;
    const moment = Math.min(this.moments - 1, Math.round(clock.seconds() * motion.fps));
    const context = canvas.getContext("2d")!;
    context.save();
    context.resetTransform();
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(this.picture, 0, 0);
    context.restore();
    for (const [name, width] of [["--paper", 4], ["--mark", 2]] as const) {
      context.strokeStyle = colour(name);
      context.lineWidth = width;
      stroke(context, [this.x(moment), top], [this.x(moment), this.rowsEnd]);
    }
    context.lineWidth = 1;
    const part = partAt(motion, moment);
    this.told.textContent = `At ${(moment / motion.fps).toFixed(2)} s: ${part?.name} ${millimetres(part?.curve[moment] ?? 0)}.`;
  }

  private follow(event: PointerEvent): void {
    const box = this.canvas.getBoundingClientRect();
    const share = (event.clientX - box.left - left) / (box.width - left - right);
    this.clock.go(this.clock.frameAt(Math.min(1, Math.max(0, share)) * (this.moments - 1) / this.motion.fps));
  }
}

export function distanceChart(motion: ComparedMotion, clock: Clock): View {
  if (Math.max(...motion.curve) > 0) return new Chart(motion, clock);
  const seconds = (motion.curve.length / motion.fps).toFixed(2);
  return { node: element("p", { class: "wide quiet" }, `No joint is elsewhere in the ${seconds} s that both motions have.`),
    paint: () => {} };
}
