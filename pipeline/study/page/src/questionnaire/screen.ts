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
  /** The film's own time, in seconds; of films. */
  time?(): number;
  /** Frames that were not shown since the screen was made; null where that is unknown. */
  dropped_frames(): number | null;
  release(): void;
}

/** What a screen tells while it plays. */
export interface ScreenEvents {
  /** A first frame is on the screen since that moment (performance.now()). */
  began(at: number): void;
  stalled(): void;
  wentOn(): void;
  ended(): void;
  /** The volume of what is heard was changed: 0 (muted) to 1. */
  volumeChanged(volume: number): void;
}

/** A first frame that is told later than this after the beginning was on the screen before. WebKit tells it late, or
    never. */
const latestFrameMs = 200;

/** Calls back once with the moment at which a video that has begun to play shows its first frame. */
function firstFrame(video: HTMLVideoElement, shown: (at: number) => void): void {
  const playing = performance.now();
  let isTold = false;
  const tell = (at: number) => {
    if (!isTold) shown(at);
    isTold = true;
  };
  if (!video.requestVideoFrameCallback) return tell(playing);
  video.requestVideoFrameCallback((now) => tell(now - playing > latestFrameMs ? playing : now));
  setTimeout(() => tell(playing), latestFrameMs);
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
    firstFrame(video, (at) => told.began(at));
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
    time: () => video.currentTime,
    dropped_frames: () => video.getVideoPlaybackQuality?.().droppedVideoFrames ?? null,
    release: () => release(video),
  };
}

/** The URLs of what is turned. */
export interface TurnedFiles {
  url: string;
  /** The figures of its people. */
  figures: string[];
  /** A motion file whose bones are shown, instead of people. */
  isMotion: boolean;
}

/** What turn_view.js puts beside the page's own script. `colour`: of bones. */
export interface TurnView {
  (files: TurnedFiles, label: string, colour: string, told: ScreenEvents): Screen;
}

const turnView = (): TurnView | undefined =>
  (globalThis as { mienTurnView?: TurnView }).mienTurnView;

/** Brings three.js, which is needed only where figures are turned. */
export async function loadTurnView(): Promise<void> {
  if (!turnView()) await runScript("turn_view.js");
}

/** `figures`: URLs of the files that the media name. */
export function screenOf(
  url: string, figures: string[], media: Media, label: string, colour: string, told: ScreenEvents,
): Screen {
  if (media.type.startsWith("video/")) return videoScreen(url, media, told);
  return turnView()!({ url, figures, isMotion: media.type === "model/gltf-binary" }, label, colour, told);
}
