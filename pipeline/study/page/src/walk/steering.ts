// What keys, a gamepad and buttons on the page want of the walker.

/** Degrees a second that the walker turns at most when it is told to. */
const turnDegS = 70;
const fastPace = 1.2;
/** Of a gamepad's stick that is let go. */
const dead = 0.15;

/** What can be held down. */
export type Hold = "forward" | "left" | "right" | "fast";

const keys: Record<string, Hold> = {
  ArrowUp: "forward", KeyW: "forward", ArrowLeft: "left", KeyA: "left", ArrowRight: "right", KeyD: "right",
  ShiftLeft: "fast", ShiftRight: "fast",
};

export interface Steer {
  pace: number;
  turn_deg_s: number;
}

const beyondDead = (value: number): number =>
  Math.abs(value) < dead ? 0 : Math.sign(value) * Math.min(1, (Math.abs(value) - dead) / (0.95 - dead));

/** The first gamepad that is there and is moved: its left stick, or its cross. */
function fromGamepad(): Steer | null {
  const pads = typeof navigator.getGamepads === "function" ? navigator.getGamepads() : [];
  for (const pad of pads) {
    if (!pad) continue;
    const pressed = (button: number) => (pad.buttons[button]?.pressed ? 1 : 0);
    const across = beyondDead(pad.axes[0] ?? 0) + pressed(15) - pressed(14);
    const ahead = beyondDead(-(pad.axes[1] ?? 0)) + pressed(12);
    if (across === 0 && ahead <= 0) continue;
    const fast = 1 + (fastPace - 1) * (pad.buttons[7]?.value ?? 0);
    return { pace: Math.min(1, Math.max(0, ahead)) * fast, turn_deg_s: -turnDegS * Math.max(-1, Math.min(1, across)) };
  }
  return null;
}

/** Listens to the keys while the focus is in the element. Space walks on without a key. */
export class Steering {
  private held = new Set<Hold>();
  /** Walks on by itself. */
  walksOn = false;
  /** Share of the mood's own speed at which it walks. */
  pace = 1;
  /** Told when `walksOn` has changed by a key. */
  changed: () => void = () => undefined;
  private ended = new AbortController();

  constructor(element: HTMLElement) {
    const { signal } = this.ended;
    // Before the camera hears of them, which the same keys would turn.
    element.addEventListener("keydown", (event) => this.key(event, true), { capture: true, signal });
    element.addEventListener("keyup", (event) => this.key(event, false), { capture: true, signal });
    for (const lost of ["blur", "pagehide"])
      window.addEventListener(lost, () => this.held.clear(), { signal });
    element.addEventListener("focusout", (event) => {
      if (!element.contains(event.relatedTarget as Node | null)) this.held.clear();
    }, { signal });
  }

  hold(what: Hold, isHeld: boolean): void {
    if (isHeld) this.held.add(what);
    else this.held.delete(what);
  }

  now(): Steer {
    const pad = fromGamepad();
    if (pad) return { pace: pad.pace * this.pace, turn_deg_s: pad.turn_deg_s };
    const walks = this.held.has("forward") || this.walksOn;
    const turn = Number(this.held.has("left")) - Number(this.held.has("right"));
    const fast = this.held.has("fast") ? fastPace : 1;
    return { pace: walks ? Math.min(fastPace, this.pace * fast) : 0, turn_deg_s: turn * turnDegS };
  }

  release(): void {
    this.ended.abort();
  }

  private key(event: KeyboardEvent, isDown: boolean): void {
    // Sliders and buttons have keys of their own.
    const inField = event.target instanceof HTMLInputElement || event.target instanceof HTMLButtonElement;
    if (isDown && (inField || event.ctrlKey || event.altKey || event.metaKey)) return;
    if (event.code === "Space" || event.code === "ArrowDown" || event.code === "KeyS") {
      if (inField) return;
      event.preventDefault();
      event.stopPropagation();
      if (!isDown || event.repeat) return;
      this.walksOn = event.code === "Space" && !this.walksOn;
      return this.changed();
    }
    const what = keys[event.code];
    if (!what) return;
    this.hold(what, isDown);
    if (!isDown || what === "fast") return;
    event.preventDefault();
    event.stopPropagation();
  }
}
