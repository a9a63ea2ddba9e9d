// What cannot be played stops nobody: it may be tried again on a page that is loaded anew, or be left out.

import { button, element } from "./elements";
import type { Texts } from "./texts";

/** How long a film may stand still before it may be started again. */
export const patienceMs = 6000;

/** How long a participant waits for a film that says nothing before it may be left out. */
export const waitForFilmMs = 20000;

/** After so many stops a film may be left out. */
export const stopsOfFault = 2;

/** Says what can be done, and does it. */
export const leaveOutOffer = (texts: Texts, leftOut: () => void): HTMLElement[] => [
  element("p", { role: "status" }, texts.leaveOutHow),
  element("div", { class: "buttons" }, button(texts.again, () => location.reload(), "main"),
    button(texts.leaveOut, leftOut)),
];
