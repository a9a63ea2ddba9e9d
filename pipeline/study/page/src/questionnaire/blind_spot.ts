// The viewing distance by the blind spot of the eye, which lies at a known angle (Li, Joo, Yeatman and Reinecke 2020,
// Scientific Reports 10, 904): the participant looks at a square with the left eye alone, while a dot moves to the
// left, and tells when it has disappeared.

import { button, element, heading, paragraphs } from "./elements";
import { Drawer } from "./store";
import type { Texts } from "./texts";
import { measuredDistance, viewingDistance } from "./viewing_distance";

const readings = 5;
const mostFailures = 3;
const speedMmPerS = 25;
/** Of the square and the dot. */
const sizeMm = 6;

const drawerOf = (session: string): Drawer => new Drawer(`mien/${session}/distance`);

/** What was measured in this session; null where it could not be; undefined before. */
export function distanceOf(session: string): number | null | undefined {
  const kept = drawerOf(session).read<{ cm: number | null }>();
  return kept ? kept.cm : undefined;
}

export const forgetDistance = (session: string): void => drawerOf(session).clear();

function shape(look: string, perMm: number): HTMLElement {
  const made = element("div", { class: look });
  made.style.width = made.style.height = `${sizeMm * perMm}px`;
  return made;
}

/** The square that is looked at. */
const sight = (perMm: number): HTMLElement => shape("sight", perMm);

/** One reading: the distance between square and dot when the participant answers, pixels; null where the dot left. */
function readingOf(field: HTMLElement, perMm: number, answered: Promise<void>): Promise<number | null> {
  return new Promise((done) => {
    const size = sizeMm * perMm;
    const dot = shape("dot", perMm);
    field.replaceChildren(sight(perMm), dot);
    const reach = field.clientWidth - size;
    const began = performance.now();
    let apart = 0;
    let next = 0;
    const step = () => {
      apart = 2 * size + ((performance.now() - began) / 1000) * speedMmPerS * perMm;
      dot.style.right = `${apart}px`;
      if (apart > reach) done(null);
      else next = requestAnimationFrame(step);
    };
    step();
    void answered.then(() => {
      cancelAnimationFrame(next);
      done(apart);
    });
  });
}

/** Measures the distance and keeps it for this session; resolves once that is done or was found to be impossible. */
export function measureDistance(display: HTMLElement, texts: Texts, session: string, perMm: number): Promise<void> {
  return new Promise((done) => {
    const finish = (cm: number | null) => {
      drawerOf(session).write({ cm });
      done();
    };
    let press = () => {};
    const pressed = () => new Promise<void>((resolve) => { press = resolve; });
    const field = element("div", { class: "blind-spot", "aria-hidden": "true" });
    const note = element("p", { role: "status" });
    const go = button(texts.blindSpotStart, () => press(), "main");
    const cannot = button(texts.blindSpotCannot, () => finish(null), "quiet");
    const measure = async () => {
      let distances: number[] = [];
      for (let failures = 0; failures < mostFailures;) {
        go.textContent = texts.blindSpotStart;
        await pressed();
        go.textContent = texts.blindSpotGone;
        const apart = await readingOf(field, perMm, pressed());
        if (apart !== null) distances.push(viewingDistance(apart / perMm / 10));
        note.textContent = texts.blindSpotOf({ done: distances.length, all: readings });
        const cm = distances.length === readings ? measuredDistance(distances) : null;
        if (cm !== null) return cm;
        if (apart !== null && distances.length < readings) continue;
        failures += 1;
        distances = [];
        note.textContent = texts.blindSpotAgain;
      }
      return null;
    };
    field.replaceChildren(sight(perMm));
    display.replaceChildren(element("article", { class: "page wide-field" }, heading(texts.blindSpot),
      ...paragraphs(texts.blindSpotHow), field, note, element("div", { class: "buttons" }, go, cannot)));
    go.focus();
    void measure().then(finish);
  });
}
