import { element } from "../questionnaire/elements";
import { secondsOf } from "../figure/playing";
import { heat } from "./heat";
import type { Made } from "./server";
import type { StageView } from "./stage_view";
import type { Studio } from "./studio";

const rows = { D: 14, left: 11, right: 11, findings: 12 };
const margin = 64;  // pixels, for names

/** One cycle from left to right: where it is different, where feet stand, keytimes and findings. */
export function timeline(studio: Studio, stage: StageView): HTMLElement {
  const canvas = element("canvas", { class: "timeline", tabindex: "0", role: "slider", "aria-label": "time in the motion",
    "aria-valuemin": "0", "aria-valuemax": "100" });
  // What is there already is not drawn again.
  let drawn: unknown[] = [];
  const draw = (): void => {
    const now = [studio.made, stage.phase(), canvas.clientWidth, canvas.clientHeight, devicePixelRatio];
    if (now.every((one, i) => one === drawn[i])) return;
    drawn = now;
    if (studio.made) paint(canvas, studio.made, stage.phase());
    canvas.setAttribute("aria-valuenow", String(Math.round(100 * stage.phase())));
  };
  const seek = (event: PointerEvent): void => {
    const width = canvas.clientWidth - margin - 8;
    stage.seek(Math.min(1, Math.max(0, (event.offsetX - margin) / width)));
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    seek(event);
  });
  canvas.addEventListener("pointermove", (event) => canvas.hasPointerCapture(event.pointerId) && seek(event));
  canvas.addEventListener("keydown", (event) => {
    const frames = studio.made?.motion.frames ?? 1;
    const by = { ArrowLeft: -1 / frames, ArrowRight: 1 / frames }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    stage.seek((stage.phase() + by + 1) % 1);
  });
  const step = (): void => {
    draw();
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
  return canvas;
}

function paint(canvas: HTMLCanvasElement, made: Made, phase: number): void {
  const ratio = Math.min(2, devicePixelRatio);
  const width = canvas.clientWidth;
  const height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const pen = canvas.getContext("2d")!;
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  const along = (share: number): number => margin + share * (width - margin - 8);
  pen.font = "11px system-ui, sans-serif";
  pen.textBaseline = "middle";
  let y = 6;
  const row = (name: string, high: number): number => {
    pen.fillStyle = "#3f3f3f";
    pen.fillText(name, 4, y + high / 2);
    const at = y;
    y += high + 5;
    return at;
  };
  paintDistance(pen, made, along, row("D", rows.D));
  paintContacts(pen, made, 0, along, row("left foot", rows.left));
  paintContacts(pen, made, 1, along, row("right foot", rows.right));
  paintFindings(pen, made, along, row("findings", rows.findings));
  paintTimes(pen, made, along, y, phase);
}

type Along = (share: number) => number;

function paintDistance(pen: CanvasRenderingContext2D, made: Made, along: Along, y: number): void {
  const byTime = made.distance?.by_time;
  pen.fillStyle = "#d9d9d9";
  pen.fillRect(along(0), y, along(1) - along(0), rows.D);
  if (!byTime) return;
  byTime.forEach((metres, k) => {
    const from = Math.max(0, (k - 0.5) / 10);
    const to = Math.min(1, (k + 0.5) / 10);
    pen.fillStyle = heat(metres);
    pen.fillRect(along(from), y, along(to) - along(from) + 0.5, rows.D);
  });
}

function paintContacts(pen: CanvasRenderingContext2D, made: Made, foot: number, along: Along, y: number): void {
  const { frames, contacts } = made.motion;
  pen.fillStyle = "#d9d9d9";
  pen.fillRect(along(0), y, along(1) - along(0), rows.left);
  pen.fillStyle = "#55657a";
  for (let frame = 0; frame < frames; frame += 1)
    if (contacts[2 * frame + foot]) pen.fillRect(along(frame / frames), y, along(1 / frames) - along(0) + 0.5, rows.left);
}

function paintFindings(pen: CanvasRenderingContext2D, made: Made, along: Along, y: number): void {
  const { frames } = made.motion;
  pen.fillStyle = "#d9d9d9";
  pen.fillRect(along(0), y, along(1) - along(0), rows.findings);
  for (const finding of made.findings) {
    const from = along(Math.min(1, finding.first / frames));
    const to = along(Math.min(1, (finding.last + 1) / frames));
    pen.fillStyle = finding.is_error ? "#8c1d18" : "#c08a1e";
    pen.fillRect(from, y + (finding.is_error ? 0 : 3), Math.max(3, to - from), rows.findings - (finding.is_error ? 0 : 6));
  }
}

function paintTimes(pen: CanvasRenderingContext2D, made: Made, along: Along, bottom: number, phase: number): void {
  const seconds = secondsOf(made.motion);
  pen.strokeStyle = "#1c1c1c";
  pen.lineWidth = 1;
  for (const time of made.motion.keytimes) {
    const x = Math.round(along(time / seconds)) + 0.5;
    pen.beginPath();
    pen.moveTo(x, 2);
    pen.lineTo(x, bottom);
    pen.stroke();
  }
  pen.fillStyle = "#3f3f3f";
  const step = seconds > 4 ? 1 : 0.2;
  for (let time = 0; time <= seconds + 1e-6; time += step)
    pen.fillText(`${time.toFixed(1)} s`, Math.min(along(time / seconds), along(1) - 22), bottom + 8);
  pen.strokeStyle = "#b3261e";
  pen.lineWidth = 2;
  pen.beginPath();
  pen.moveTo(along(phase), 0);
  pen.lineTo(along(phase), bottom + 14);
  pen.stroke();
}
