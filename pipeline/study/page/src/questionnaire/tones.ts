// The test of sound: tones are played, and the participant counts them.

import { button, element, heading, paragraphs } from "./elements";
import type { Response } from "./experiment";
import { plainDigits } from "./text_view";
import type { Texts } from "./texts";
import { hasCountedTones, toneAttempts, toneCount, toneItem } from "./tone_count";

const betweenSeconds = 0.6;
const toneSeconds = 0.25;
const edgeSeconds = 0.02;

/** Plays tones of 440 Hz, a fifth of full scale; resolves after the last. */
async function playTones(count: number): Promise<void> {
  const context = new AudioContext();
  await context.resume();
  const start = context.currentTime + 0.1;
  for (let i = 0; i < count; i += 1) {
    const from = start + i * betweenSeconds;
    const tone = context.createOscillator();
    const level = context.createGain();
    tone.frequency.value = 440;
    level.gain.setValueAtTime(0, from);
    level.gain.linearRampToValueAtTime(0.2, from + edgeSeconds);
    level.gain.setValueAtTime(0.2, from + toneSeconds - edgeSeconds);
    level.gain.linearRampToValueAtTime(0, from + toneSeconds);
    tone.connect(level).connect(context.destination);
    tone.start(from);
    tone.stop(from + toneSeconds);
  }
  await new Promise((over) => setTimeout(over, 1000 * (0.1 + count * betweenSeconds)));
  await context.close();
}

/** Plays tones and asks how many there were, until the number is right or all attempts were made. */
export async function countedTones(display: HTMLElement, session: string, texts: Texts): Promise<Response[]> {
  const responses: Response[] = [];
  for (let attempt = 1; attempt <= toneAttempts; attempt += 1) {
    responses.push(await askForTones(display, session, attempt, texts));
    if (hasCountedTones(session, responses)) break;
  }
  return responses;
}

function askForTones(display: HTMLElement, session: string, attempt: number, texts: Texts): Promise<Response> {
  return new Promise((done) => {
    const began = performance.now();
    const wrong = element("p", { class: "wrong", id: "tones-wrong", role: "alert" });
    const input = element("input", { type: "text", id: "tones", inputmode: "numeric", maxlength: "3",
      autocomplete: "off", "aria-describedby": "tones-wrong" });
    const status = element("p", { role: "status" });
    const play = button(texts.playTones, () => void start());
    const next = button(texts.next, () => answer(), "main");
    next.disabled = input.disabled = true;
    const head = heading(texts.testSound);
    const start = async () => {
      play.disabled = true;
      status.textContent = texts.tonesPlaying;
      try {
        await playTones(toneCount(session, attempt));
        status.textContent = "";
      } catch {
        status.textContent = texts.noTones;
      }
      play.disabled = next.disabled = input.disabled = false;
      input.focus();
    };
    const answer = () => {
      const text = plainDigits(input.value.trim());
      const isNumber = /^\d+$/.test(text);
      wrong.textContent = isNumber ? "" : texts.numberWanted;
      input.setAttribute("aria-invalid", String(!isNumber));
      if (!isNumber) return input.focus();
      done({ item: toneItem(attempt), value_raw: Number(text), rt_ms: Math.round(performance.now() - began) });
    };
    input.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" || event.isComposing || event.repeat) return;
      event.preventDefault();
      answer();
    });
    const how = attempt === 1 ? [texts.testSoundHow] : [texts.tonesAgain, texts.testSoundHow];
    display.replaceChildren(element("article", { class: "page" }, head, ...paragraphs(how),
      element("div", { class: "buttons" }, play), status,
      element("div", { class: "question" }, element("label", { for: "tones" }, texts.howManyTones), input, wrong),
      element("div", { class: "buttons" }, next)));
    scrollTo(0, 0);
    head.focus();
  });
}
