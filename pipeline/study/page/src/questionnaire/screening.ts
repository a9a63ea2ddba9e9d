// The first page after consent: whether the window is large enough, the screen fast enough, sound is heard, and
// the answers to the screening questions are accepted.

import { button, element, heading, paragraphs } from "./elements";
import type { AnswerRange, PageRecord, Response, Screening } from "./experiment";
import { refreshRate } from "./measures";
import { showTextPage, type GivenOnPage } from "./text_view";
import type { Texts } from "./texts";
import { hasCountedTones } from "./tone_count";
import { countedTones } from "./tones";

const isLargeEnough = ([width, height]: [number, number]): boolean =>
  innerWidth >= width && innerHeight >= height;

/** Asks to enlarge the window until it is large enough; false if the participant cannot. */
export function enlargedWindow(display: HTMLElement, texts: Texts, window: [number, number]): Promise<boolean> {
  if (isLargeEnough(window)) return Promise.resolve(true);
  return new Promise((done) => {
    const size = element("p", { role: "status" });
    const end = (isLarge: boolean) => {
      removeEventListener("resize", look);
      done(isLarge);
    };
    const look = () => {
      if (isLargeEnough(window)) return end(true);
      const [needsWidth, needsHeight] = window;
      size.textContent = texts.windowSize({ width: innerWidth, height: innerHeight, needsWidth, needsHeight });
    };
    const head = heading(texts.enlargeWindow);
    display.replaceChildren(element("article", { class: "page" }, head, ...paragraphs([texts.enlargeHow]), size,
      element("div", { class: "buttons" }, button(texts.cannotEnlarge, () => end(false)))));
    addEventListener("resize", look);
    look();
    head.focus();
  });
}

const isWithin = (range: AnswerRange | undefined, value: number | string): boolean => {
  if (!range) return true;
  if (Array.isArray(range)) return range.includes(String(value));
  return Number(value) >= (range.from ?? -Infinity) && Number(value) <= (range.to ?? Infinity);
};

/** Why the record turns the participant away, where no server decides that; "" if it does not. */
export function screeningFault(screening: Screening | undefined, record: PageRecord | undefined): string {
  if (!screening || !record) return "";
  const [width, height] = screening.window ?? [0, 0];
  if ((record.viewport_width ?? 0) < width || (record.viewport_height ?? 0) < height) return "window";
  if ((record.refresh_hz ?? Infinity) < (screening.refresh_hz ?? 0)) return "refresh_hz";
  if (screening.sound && !hasCountedTones(record.session, record.responses)) return "sound";
  const given = new Map(record.responses.map(({ item, value_raw: value }) => [item, value]));
  const isRefused = (screening.questions ?? []).some(({ id, accept }) => {
    const value = given.get(id);
    return value === undefined || !isWithin(accept, value);
  });
  return isRefused ? "answer" : "";
}

/** Shows what is asked; returns once `keep` has kept the record. */
export async function runScreening(
  display: HTMLElement, screening: Screening, session: string, texts: Texts,
  keep: (record: PageRecord, page: HTMLElement) => Promise<void>,
): Promise<void> {
  const startedAt = new Date().toISOString();
  const isLarge = !screening.window || await enlargedWindow(display, texts, screening.window);
  const measured = screening.refresh_hz ? await refreshRate() : null;
  let tones: Response[] = [];
  const keepGiven = async ({ responses, started_at: at }: Partial<GivenOnPage>, page: HTMLElement) => {
    // The window may have become smaller while the questions were answered.
    if (isLarge && screening.window) await enlargedWindow(display, texts, screening.window);
    await keep({ record: "screening", session, responses: [...tones, ...(responses ?? [])], comment: "", started_at: at ?? startedAt,
      viewport_width: innerWidth, viewport_height: innerHeight, refresh_hz: measured },
    page.isConnected ? page : display);
  };
  const isFast = (measured ?? Infinity) >= (screening.refresh_hz ?? 0);
  if (screening.sound && isLarge && isFast) tones = await countedTones(display, session, texts);
  const isHeard = !screening.sound || hasCountedTones(session, tones);
  const questions = (screening.questions ?? []).map((one) => ({ ...one, required: true }));
  if (!isLarge || !isFast || !isHeard || !questions.length) return keepGiven({}, display);
  await showTextPage(display, { title: texts.screening, questions, buttons: [texts.next], words: texts,
    keep: keepGiven });
}
