// Stimuli that cannot be played: participants may reload the page, or leave the trial out.

import { button, element } from "./elements";
import type { Texts } from "./texts";

/** How long a film may stand still before it may be started again. */
export const patienceMs = 6000;

/** How long a film may take until it can be played; then it may be left out. */
export const waitForFilmMs = 20000;

/** After so many stops a film may be left out. */
export const stopsOfFault = 2;

/** An explanation, and the buttons that reload the page or leave the trial out. */
export const leaveOutOffer = (texts: Texts, leftOut: () => void): HTMLElement[] => [
  element("p", { role: "status" }, texts.leaveOutHow),
  element("div", { class: "buttons" }, button(texts.again, () => location.reload(), "main"),
    button(texts.leaveOut, leftOut)),
];
