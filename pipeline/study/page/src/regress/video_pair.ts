import { element } from "../questionnaire/elements";
import type { Clock, Driver } from "./clock";
import { editions, type Edition, type Videos } from "./stimulus";

/** What the page holds as text, as something that players can seek in; other addresses as they are. */
function blobAddress(address: string): string {
  if (!address.startsWith("data:")) return address;
  const [head, text] = address.split(",") as [string, string];
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return URL.createObjectURL(new Blob([bytes], { type: head.slice(5, head.indexOf(";")) }));
}

/** Both videos of a stimulus, held together by its clock. */
export class VideoPair implements Driver {
  readonly players: Record<Edition, HTMLVideoElement>;
  /** The longer one tells the clock; the other keeps up with it. */
  private readonly leader: Edition;
  private readonly follower: Edition;
  private runs = false;

  /** `ready`: both can be seen. */
  constructor(private readonly videos: Videos, private readonly clock: Clock, ready: () => void) {
    const player = (name: Edition): HTMLVideoElement => {
      const made = element("video", { playsinline: "", preload: "auto", "aria-label": name });
      made.muted = true;
      made.src = blobAddress(videos[name].src);
      made.addEventListener("loadeddata", () => {
        if (!Object.values(this.players).every((one) => one.readyState >= 2)) return;
        this.seek();
        ready();
      });
      return made;
    };
    this.players = { before: player("before"), now: player("now") };
    [this.leader, this.follower] = this.frames("before") > this.frames("now") ? ["before", "now"] : ["now", "before"];
    this.players[this.leader].addEventListener("ended", () => {
      if (!this.runs) return;
      clock.show(0);
      this.seek();
      this.play();
    });
  }

  private frames = (name: Edition): number => this.videos[name].frames - this.videos[name].first;

  /** The middle of a frame's time, so that no rounding leads to another. */
  private time(name: Edition, frame: number): number {
    const { first, fps } = this.videos[name];
    return (first + Math.min(frame, this.frames(name) - 1) + 0.5) / fps;
  }

  /** To the clock's frame; while both play, they go on. */
  seek(): void {
    for (const name of editions) this.players[name].currentTime = this.time(name, this.clock.frame);
  }

  isRunning = (): boolean => this.runs;

  private keepUp(mediaTime: number): void {
    if (!this.runs) return;
    const { leader, follower, players } = this;
    const { fps, first } = this.videos[leader];
    const frame = Math.round(mediaTime * fps) - first;
    this.clock.show(frame);
    const late = players[follower].currentTime - players[leader].currentTime - (this.time(follower, 0) - this.time(leader, 0));
    if (frame < this.frames(follower) - 1 && Math.abs(late) > 0.6 / fps)
      players[follower].currentTime = this.time(follower, frame);
    this.followLeader();
  }

  private followLeader(): void {
    this.players[this.leader].requestVideoFrameCallback((_, shown) => this.keepUp(shown.mediaTime));
  }

  play(): void {
    this.runs = true;
    this.followLeader();
    for (const player of Object.values(this.players)) player.play().catch(() => this.clock.stop());
  }

  stop(): void {
    this.runs = false;
    for (const player of Object.values(this.players)) player.pause();
    this.seek();
  }
}
