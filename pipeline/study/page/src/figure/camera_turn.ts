import type { PerspectiveCamera } from "three";

/** Where a camera stands about what it looks at; radians and metres. */
export interface Turn {
  /** 0: from the front of who walks along +Z; a quarter turn: from his left. */
  azimuth: number;
  elevation: number;
  distance: number;
}

export const within = (least: number, value: number, most: number): number =>
  Math.min(most, Math.max(least, value));

/**
 * Mouse, fingers and keys turn the camera; plus and minus, the wheel or two fingers bring it nearer.
 * Home brings back where it stood.
 */
export function letTurn(canvas: HTMLCanvasElement, turn: Turn, changed: () => void): void {
  const home = { ...turn };
  const by = (azimuth: number, elevation: number, nearer = 1) => {
    turn.azimuth += azimuth;
    turn.elevation = within(-0.2, turn.elevation + elevation, 1.45);
    turn.distance = within(1.5, turn.distance * nearer, 12);
    changed();
  };
  letDrag(canvas, by);
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
    if (!found && event.key !== "Home") return;
    event.preventDefault();
    if (found) by(...found);
    else {
      Object.assign(turn, home);
      changed();
    }
  });
}

/** One finger or button turns, two fingers bring nearer as they part. */
function letDrag(
  canvas: HTMLCanvasElement, by: (azimuth: number, elevation: number, nearer?: number) => void): void {
  const fingers = new Map<number, [number, number]>();
  const apart = (): number => {
    const [a, b] = [...fingers.values()];
    return a && b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
  };
  canvas.style.touchAction = "none";
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const)
    canvas.addEventListener(end, (event) => fingers.delete(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    const last = fingers.get(event.pointerId);
    if (!last) return;
    const before = apart();
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    if (fingers.size === 1)
      by(-(event.clientX - last[0]) * 0.008, (event.clientY - last[1]) * 0.006);
    else if (before > 0 && apart() > 0) by(0, 0, before / apart());
  });
}

/** Puts the camera where it stands about a point on the middle line, that many metres up. */
export function stand(camera: PerspectiveCamera, turn: Turn, x: number, height: number, z: number): void {
  const flat = Math.cos(turn.elevation) * turn.distance;
  camera.position.set(x + flat * Math.sin(turn.azimuth), height + Math.sin(turn.elevation) * turn.distance,
    z + flat * Math.cos(turn.azimuth));
  camera.lookAt(x, height, z);
}
