import type { Media } from "./experiment";
import { playsThrough, release, runScript, videoOf } from "./media";

/** Something that is shown from its beginning to its end. */
export interface Screen {
  element: HTMLElement;
  /** Once it can be played without a stop. */
  ready: Promise<void>;
  /** From the beginning. */
  play(): void;
  /** Before its end; it is not told. */
  stop(): void;
  /** Whether it has been played to its end. */
  hasEnded(): boolean;
  /** Frames that were not shown since the screen was made; null where that is unknown. */
  dropped_frames(): number | null;
  release(): void;
}

/** What a screen tells while it plays. */
export interface ScreenEvents {
  began(): void;
  stalled(): void;
  wentOn(): void;
  ended(): void;
  /** The volume of what is heard was changed: 0 (muted) to 1. */
  volumeChanged(volume: number): void;
}

function videoScreen(url: string, media: Media, told: ScreenEvents): Screen {
  const video = videoOf(url, media.sound);
  if (media.width && media.height) {
    video.width = media.width;
    video.height = media.height;
  }
  // Seeking to the beginning makes a video wait too, which is no stall.
  let state: "still" | "starting" | "running" = "still";
  video.addEventListener("playing", () => {
    if (state === "still") return;
    state = "running";
    told.wentOn();
    // The moment at which a first frame is on the screen, where the browser tells it.
    if (video.requestVideoFrameCallback) video.requestVideoFrameCallback(() => told.began());
    else told.began();
  });
  // The last frames may be waited for as well, on no account of the network.
  const isOver = () => video.ended || video.duration - video.currentTime < 0.1;
  video.addEventListener("waiting", () => {
    if (state === "running" && !isOver()) told.stalled();
  });
  video.addEventListener("ended", () => {
    state = "still";
    told.ended();
  });
  if (media.sound)
    video.addEventListener("volumechange", () => told.volumeChanged(video.muted ? 0 : video.volume));
  return {
    element: video,
    ready: playsThrough(video),
    play() {
      state = "starting";
      if (video.currentTime > 0) video.currentTime = 0;
      video.play().catch(() => told.stalled());
    },
    stop() {
      state = "still";
      video.pause();
    },
    hasEnded: () => video.ended,
    dropped_frames: () => video.getVideoPlaybackQuality?.().droppedVideoFrames ?? null,
    release: () => release(video),
  };
}

/** What turn_view.js puts beside the page's own script. */
export interface TurnView {
  (url: string, label: string, colour: string, told: ScreenEvents): Screen;
}

const turnView = (): TurnView | undefined =>
  (globalThis as { mienTurnView?: TurnView }).mienTurnView;

/** Brings three.js, which is needed only where figures are turned. */
export async function loadTurnView(): Promise<void> {
  if (!turnView()) await runScript("turn_view.js");
}

export function screenOf(
  url: string, media: Media, label: string, colour: string, told: ScreenEvents,
): Screen {
  if (media.type.startsWith("video/")) return videoScreen(url, media, told);
  return turnView()!(url, label, colour, told);
}
