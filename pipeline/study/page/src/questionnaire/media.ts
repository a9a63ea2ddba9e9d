import { mediaOf } from "./adaptive/tracks";
import type { Experiment, Media, Session } from "./experiment";

/** What is shown of a token: a URL that plays without a network. */
export type Stock = Map<string, string>;

/** Tokens of a session, each once, in the order in which they are needed. */
const tokensOf = (session: Session, media: Experiment["media"]): string[] => [
  ...new Set(session.trials
    .flatMap((trial) => (trial.reference ? [...mediaOf(trial), trial.reference] : mediaOf(trial)))
    .flatMap((token) => [token, ...(media[token]?.figures ?? [])])),
];

/** A page of file:// may show the files beside it and not fetch them. */
const isFolder = (): boolean => location.protocol === "file:";

async function sha256Of(bytes: ArrayBuffer): Promise<string | null> {
  if (!globalThis.crypto?.subtle) return null;  // on http, anywhere but on this machine
  const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

async function fetched(media: Media): Promise<string> {
  const answer = await fetch(media.file);
  if (!answer.ok) throw new Error(`${media.file}: ${answer.status}`);
  const bytes = await answer.arrayBuffer();
  const hash = await sha256Of(bytes);
  if (hash !== null && hash !== media.sha256) throw new Error(`${media.file}: damaged in transmission`);
  return URL.createObjectURL(new Blob([bytes], { type: media.type }));
}

/**
 * Waits until a video says that it can be played to its end. Of one that is here already, WebKit never says that; it is
 * enough that it can be played.
 */
export function playsThrough(video: HTMLVideoElement): Promise<void> {
  const isHere = video.src.startsWith("blob:");
  return new Promise((ready, failed) => {
    const [enough, event] = isHere ? [HTMLMediaElement.HAVE_FUTURE_DATA, "canplay"]
      : [HTMLMediaElement.HAVE_ENOUGH_DATA, "canplaythrough"];
    if (video.readyState >= enough) return ready();
    video.addEventListener(event, () => ready(), { once: true });
    video.addEventListener("error", () => failed(new Error(video.error?.message ?? "no video")),
      { once: true });
  });
}

export function videoOf(url: string, sound = false): HTMLVideoElement {
  const video = document.createElement("video");
  video.muted = !sound;
  video.playsInline = true;
  video.preload = "auto";
  video.disableRemotePlayback = true;
  video.setAttribute("disablepictureinpicture", "");
  video.src = url;
  return video;
}

export function release(video: HTMLVideoElement): void {
  video.removeAttribute("src");
  video.load();
}

async function playedFromFolder(media: Media): Promise<string> {
  const video = videoOf(media.file);
  await playsThrough(video);
  release(video);
  return media.file;
}

/** Runs a script that lies beside the page. */
export function runScript(file: string): Promise<void> {
  return new Promise((done, failed) => {
    const script = document.createElement("script");
    script.src = file;
    script.addEventListener("load", () => done());
    script.addEventListener("error", () => failed(new Error(`${file} was not found`)));
    document.head.append(script);
  });
}

/** A motion or a figure that a page of file:// finds in a script beside it, as base64. */
async function unpacked(token: string, media: Media): Promise<string> {
  await runScript(media.file.replace(/\.[a-z]+$/, ".js"));
  const packed = (globalThis as { mienMedia?: Record<string, string> }).mienMedia?.[token];
  if (!packed) throw new Error(`${media.file}: its script is empty`);
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  return URL.createObjectURL(new Blob([bytes], { type: media.type }));
}

function loaded(token: string, media: Media): Promise<string> {
  if (!isFolder()) return fetched(media);
  return media.type.startsWith("video/") ? playedFromFolder(media) : unpacked(token, media);
}

/**
 * Brings all that a session shows, two at a time, and tells how far it is. Throws when one cannot be had, once the
 * others are there.
 */
export async function fill(
  stock: Stock, experiment: Experiment, session: Session, told: (done: number, all: number) => void,
): Promise<void> {
  const tokens = tokensOf(session, experiment.media);
  const missing = tokens.filter((token) => !stock.has(token));
  told(tokens.length - missing.length, tokens.length);
  const failures: unknown[] = [];
  const next = async (): Promise<void> => {
    for (let token = missing.shift(); token; token = missing.shift()) {
      const media = experiment.media[token];
      if (!media) throw new Error(`there is no media ${token}`);
      try {
        stock.set(token, await loaded(token, media));
      } catch (failure) {
        failures.push(failure);
      }
      told(tokens.filter((one) => stock.has(one)).length, tokens.length);
    }
  };
  await Promise.all([next(), next()]);
  if (failures.length) throw failures[0];
}
