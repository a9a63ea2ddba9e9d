// The size of stimuli on the screen: in pixels of the screen, or in centimetres or degrees of visual angle on a
// screen that the participant has calibrated with a card.

import { button, element, heading, paragraphs } from "./elements";
import type { Display, Media } from "./experiment";
import { Drawer } from "./store";
import type { Texts } from "./texts";

/** Width and height of bank cards, identity cards and driving licences, millimetres (ISO/IEC 7810 ID-1). */
const cardMm = [85.6, 53.98] as const;

/** The calibration holds for a screen and a zoom of the page. */
const drawer = (): Drawer => new Drawer(`mien/calibration/${screen.width}x${screen.height}@${devicePixelRatio}`);

/** CSS pixels per millimetre; null where the screen is not calibrated. */
export const calibration = (): number | null => drawer().read<number>();

export const needsCalibration = (display: Display | undefined): boolean =>
  typeof display?.size === "object" && calibration() === null;

const viewingCm = (display: Display): number => display.measured_cm ?? display.distance_cm;

const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** The width of a stimulus, CSS pixels; null: as large as the window allows. */
export function fixedWidth(display: Display | undefined, media: Media): number | null {
  if (!display || !media.width) return null;
  const { size } = display;
  const distance = viewingCm(display);
  if (size === "native") return media.width / devicePixelRatio;
  const cm = "cm" in size ? size.cm : 2 * distance * Math.tan(radians(size.degrees) / 2);
  const perMm = calibration();
  return perMm === null ? null : 10 * cm * perMm;
}

/** What was shown, as records have it. */
export interface ShownSize {
  shown_width: number;
  shown_height: number;
  pixel_ratio: number;
  shown_cm: number | null;
  shown_degrees: number | null;
  viewing_cm: number | null;
}

const rounded = (value: number): number => Math.round(1000 * value) / 1000;

/** Width and height of what an element shows: a film is as large as its element allows, with space beside or above it
    (object-fit: contain); a turned figure fills its element. */
function sizeInside(shown: Element): [number, number] {
  const { width, height } = shown.getBoundingClientRect();
  if (!(shown instanceof HTMLVideoElement) || !shown.videoWidth || getComputedStyle(shown).objectFit !== "contain")
    return [width, height];
  const scale = Math.min(width / shown.videoWidth, height / shown.videoHeight);
  return [scale * shown.videoWidth, scale * shown.videoHeight];
}

/** The size of a stimulus on the screen that this element shows. */
export function shownSize(display: Display | undefined, shown: Element): ShownSize {
  const [width, height] = sizeInside(shown);
  const perMm = calibration();
  const cm = perMm === null ? null : width / perMm / 10;
  const degrees = cm === null || !display ? null
    : (2 * Math.atan(cm / 2 / viewingCm(display)) * 180) / Math.PI;
  return { shown_width: rounded(width), shown_height: rounded(height), pixel_ratio: rounded(devicePixelRatio),
    shown_cm: cm === null ? null : rounded(cm), shown_degrees: degrees === null ? null : rounded(degrees),
    viewing_cm: display?.measured_cm ?? null };
}

/** The rows in which the stimuli of a trial are shown: the first half, rounded up, of more than three, and the rest. */
export const rowsOfSet = (media: Media[]): Media[][] => {
  const columns = media.length > 3 ? Math.ceil(media.length / 2) : media.length;
  return media.length > columns ? [media.slice(0, columns), media.slice(columns)] : [media];
};

/** Width and height of the window that trials with stimuli in these rows need, CSS pixels. */
export function neededWindow(display: Display | undefined, trials: Media[][][]): [number, number] {
  const around = [64, 150] as const;  // margins, the title and the progress
  let width = 0, height = 0;
  for (const rows of trials) {
    let all = 0;
    for (const row of rows) {
      const widths = row.map((media) => fixedWidth(display, media) ?? 0);
      width = Math.max(width, widths.reduce((sum, one) => sum + one + 24, 0));
      all += Math.max(0, ...row.map((media, index) =>
        media.width ? (widths[index]! * media.height) / media.width : 0));
    }
    height = Math.max(height, all);
  }
  return width ? [Math.ceil(width) + around[0], Math.ceil(height) + around[1]] : [0, 0];
}

/** Asks to make a picture as large as a card; resolves once that is confirmed. */
export function calibrate(display: HTMLElement, texts: Texts, distanceCm: number): Promise<void> {
  return new Promise((done) => {
    const card = element("div", { class: "card", role: "img", "aria-label": texts.card });
    const slider = element("input",
      { type: "range", min: "150", max: "1000", step: "1", "aria-label": texts.cardWidth });
    slider.value = "324";  // of screens with 96 dots per inch
    const show = () => {
      card.style.width = `${slider.value}px`;
      card.style.height = `${(Number(slider.value) * cardMm[1]) / cardMm[0]}px`;
    };
    const step = (by: number) => {
      slider.value = String(Number(slider.value) + by);
      show();
      touched();
    };
    // A slider that was never moved means that no card was compared.
    const touched = () => {
      confirm.disabled = false;
      first.textContent = "";
    };
    slider.addEventListener("input", () => { show(); touched(); });
    show();
    const head = heading(texts.calibrate);
    const confirm = button(texts.sizesMatch, () => {
      drawer().write(Number(slider.value) / cardMm[0]);
      done();
    }, "main");
    confirm.disabled = true;
    const first = element("p", { class: "card-first", id: "card-first", role: "status" }, texts.cardFirst);
    confirm.setAttribute("aria-describedby", first.id);
    display.replaceChildren(element("article", { class: "page calibration" }, head,
      ...paragraphs([texts.calibrateHow, texts.sitAt({ cm: distanceCm })]), card,
      element("div", { class: "card-width" }, button("−", () => step(-1)), slider, button("+", () => step(1))),
      first, element("div", { class: "buttons" }, confirm)));
    head.focus();
  });
}
