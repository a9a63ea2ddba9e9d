// A walker that somebody steers, on any page that has room for it.

import { openWalker, type WalkFrame, type WalkRequest, type Walker } from "../live/walker";
import { element } from "../questionnaire/elements";
import { MoodPanel, slider } from "./mood_panel";
import { Steering, type Hold } from "./steering";
import { WalkView } from "./walk_view";

export interface WalkOptions {
  /** The motion core for browsers (live_core.wasm), as bytes or base64. */
  module: ArrayBuffer | string;
  /** The built-in walks that moods are taken from, and which of them. */
  set?: string;
  moods?: string[];
  colour?: string;
}

/** Milliseconds that a frame took. */
export interface WalkTimes {
  walker: number;
  drawing: number;
}

export interface MountedWalk {
  readonly walker: Walker;
  /** What is wanted of the walker now. */
  wish(): WalkRequest;
  /** Called with each frame that is shown, seconds since the one before, and what it took. */
  watch(seen: (frame: WalkFrame, seconds: number, times: WalkTimes) => void): void;
  /** Takes it off the page again. */
  release(): void;
}

const help = "Arrow keys or W, A, D: walk and turn; Shift: faster; Space: walk on; a gamepad's stick does the same. " +
  "Drag to turn the camera, wheel to come nearer.";

function holdButton(text: string, label: string, what: Hold, steering: Steering): HTMLElement {
  const made = element("button", { type: "button", class: "hold", "aria-label": label }, text);
  const set = (isHeld: boolean) => () => steering.hold(what, isHeld);
  made.addEventListener("pointerdown", (event) => {
    made.setPointerCapture(event.pointerId);
    steering.hold(what, true);
  });
  for (const end of ["pointerup", "pointercancel", "lostpointercapture", "blur"]) made.addEventListener(end, set(false));
  made.addEventListener("keydown", (event) => {
    if (event.code === "Enter" || event.code === "Space") steering.hold(what, true);
  });
  made.addEventListener("keyup", set(false));
  return made;
}

function check(text: string, value: boolean, changed: (value: boolean) => void): [HTMLElement, HTMLInputElement] {
  const box = element("input", { type: "checkbox" });
  box.checked = value;
  box.addEventListener("change", () => changed(box.checked));
  return [element("label", { class: "check" }, box, text), box];
}

/** The controls beside the view. */
function panelOf(steering: Steering, view: WalkView, moods: MoodPanel): HTMLElement {
  const [onField, on] = check("walk on", false, (value) => (steering.walksOn = value));
  steering.changed = () => (on.checked = steering.walksOn);
  const [alongField] = check("camera turns along", true, (value) => (view.turnsAlong = value));
  const pace = slider("pace", steering.pace, 1.2, (value) => (steering.pace = value));
  return element("div", { class: "walk-panel" },
    element("div", { class: "holds" },
      holdButton("↰", "turn left", "left", steering), holdButton("↑", "walk", "forward", steering),
      holdButton("↱", "turn right", "right", steering)),
    element("div", { class: "mood-row" }, element("span", {}, "pace"), pace),
    onField, alongField, moods.element, element("p", { class: "help" }, help));
}

/**
 * Puts a walker into the element, with what steers it: keys while the focus is in it, a gamepad, buttons,
 * and a slider a mood. Rejects with an Error when there is no motion core or no WebGL.
 */
export async function mountWalk(place: HTMLElement, options: WalkOptions): Promise<MountedWalk> {
  const walker = await openWalker(options.module, options.set, options.moods);
  const view = new WalkView(walker.info, options.colour ?? "#3f7fbf", "a walker, steered by keys");
  const status = element("p", { class: "walk-status", role: "status" });
  const root = element("div", { class: "walk" });
  const steering = new Steering(root);
  let shares = [] as number[];
  const moods = new MoodPanel(walker.info.moods, () => (shares = moods.shares()));
  shares = moods.shares();
  root.append(element("div", { class: "walk-stage" }, view.element, status), panelOf(steering, view, moods));
  place.append(root);
  view.element.focus();

  let seen: Parameters<MountedWalk["watch"]>[0] = () => undefined;
  let last = 0, told = 0, isReleased = false;
  const wish = (): WalkRequest => ({ ...steering.now(), moods: shares });
  const show = (now: number): void => {
    if (isReleased) return;
    const seconds = last === 0 ? 0 : Math.min(0.25, Math.max(0, (now - last) / 1000));
    last = now;
    const begun = performance.now();
    const frame = walker.advance(seconds, wish());
    const walked = performance.now();
    view.draw(frame, seconds);
    seen(frame, seconds, { walker: walked - begun, drawing: performance.now() - walked });
    if (now - told > 250) {
      told = now;
      status.textContent = `${frame.speed.toFixed(2)} m/s`;
    }
    requestAnimationFrame(show);
  };
  requestAnimationFrame(show);
  return {
    walker,
    wish,
    watch: (watcher) => (seen = watcher),
    release() {
      isReleased = true;
      steering.release();
      view.release();
      root.remove();
    },
  };
}
